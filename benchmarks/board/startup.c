/* What a bare Cortex-M does from reset to main: the floating-point unit on, then newlib's own start. */
#include <stdint.h>

extern uint32_t __stack;
extern void _start(void);

void reset(void);
void _init(void) {}
void _fini(void) {}

static void hang(void)
{
    for (;;)
        ;
}

typedef void (*handler)(void);

__attribute__((section(".vectors"), used)) const handler vectors[16] = {
    (handler)&__stack, reset, hang, hang, hang, hang, hang, 0, 0, 0, 0, hang, hang, 0, hang, hang,
};

void reset(void)
{
    *(volatile uint32_t *)0xE000ED88 |= 0xFu << 20;
    __asm volatile("dsb\nisb");
    _start();
}
