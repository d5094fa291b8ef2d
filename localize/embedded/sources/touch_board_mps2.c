/* The five functions of touch_hal.h for an Arm MPS2 board with a Cortex-M4 (AN386), as emulators have it, with its
 * start-up. Frames go to UART 0. The board has no microphones: samples come from the file samples.i16 on the debugger's
 * host, 16 kHz, interleaved, and arrive as if an interrupt had brought them. No silicon was tried.
 *
 * For a chip of your own, keep the start-up and replace what reads samples and what writes bytes. */
#include "touch_compiler.h"

#include <stdint.h>

#include "touch_firmware.h"
#include "touch_hal.h"
#include "touch_tables.h"

#define UART_DATA (*(volatile uint32_t *)0x40004000)
#define UART_STATE (*(volatile uint32_t *)0x40004004)
#define UART_CONTROL (*(volatile uint32_t *)0x40004008)
#define UART_DIVIDER (*(volatile uint32_t *)0x40004010)
#define CLOCK 25000000u
#ifndef TOUCH_BAUD
#define TOUCH_BAUD 115200
#endif
#define FULL 1u
#define BLOCK 64 /* instants of a block of the converter */

extern uint32_t __stack, __data_start__, __data_end__, __data_load__, __bss_start__, __bss_end__;
int main(void);
void reset(void);

static int file;

/* A call of the debugger: open, read, end. */
static int ask(int what, const void *arguments)
{
    register int r0 __asm("r0") = what;
    register const void *r1 __asm("r1") = arguments;
    __asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

int touch_hal_start(void)
{
    static const char name[] = "samples.i16";
    const uintptr_t open[3] = {(uintptr_t)name, 1 /* rb */, sizeof name - 1};
    file = ask(0x01, open);
    UART_DIVIDER = CLOCK / TOUCH_BAUD;
    UART_CONTROL = 1;
    return file < 0;
}

size_t touch_hal_room(void)
{
    return 4096; /* send waits for the line */
}

void touch_hal_send(const uint8_t *bytes, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        while (UART_STATE & FULL)
            ;
        UART_DATA = bytes[k];
    }
}

int touch_hal_wait(void)
{
    static int16_t block[BLOCK * TOUCH_MICROPHONES];
    const uintptr_t read[3] = {(uintptr_t)file, (uintptr_t)block, sizeof block};
    const uint32_t count = (sizeof block - (uint32_t)ask(0x06, read)) / sizeof block[0] / TOUCH_MICROPHONES;
    touch_firmware_take(block, count);
    return count > 0;
}

void touch_hal_fail(int reason)
{
    (void)reason;
    (void)ask(0x18, (const void *)0x20024); /* the program ends with an error */
    for (;;)
        ;
}

int main(void)
{
    touch_firmware_run();
    (void)ask(0x18, (const void *)0x20026); /* the program ends */
    return 0;
}

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
    *(volatile uint32_t *)0xE000ED88 |= 0xFu << 20; /* the floating-point unit on */
    __asm volatile("dsb\nisb");
    const uint32_t *from = &__data_load__;
    for (uint32_t *to = &__data_start__; to < &__data_end__;) *to++ = *from++;
    for (uint32_t *to = &__bss_start__; to < &__bss_end__;) *to++ = 0;
    (void)main();
    hang();
}
