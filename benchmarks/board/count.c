/* Instructions and stack of a firmware, passed between the main loop and its touch_hal_wait by the linker's --wrap: what
 * runs from one return of that to the next call of it is counted. counts.u32 then has, in ticks of the clock: all, the
 * longest pass of the loop; and bytes of the stack below main. */
#include <stdint.h>

#define CONTROL (*(volatile uint32_t *)0xE000E010)
#define RELOAD (*(volatile uint32_t *)0xE000E014)
#define CLOCK (*(volatile uint32_t *)0xE000E018)
#define TICKS 0xFFFFFFu
#ifndef WORDS
#define WORDS 2048 /* of the stack, that are looked at */
#endif
#define UNTOUCHED 0xA5C3E1F7u

int __real_touch_hal_wait(void);
int __wrap_touch_hal_wait(void);

static uint32_t all, longest, resumed;
static volatile uint32_t *stack;

static int ask(int what, const void *arguments)
{
    register int r0 __asm("r0") = what;
    register const void *r1 __asm("r1") = arguments;
    __asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static void report(void)
{
    static const char name[] = "counts.u32";
    static uint32_t counts[3];
    uint32_t untouched = WORDS;
    while (untouched > 0 && stack[-(int)untouched] == UNTOUCHED) untouched--;
    counts[0] = all;
    counts[1] = longest;
    counts[2] = (uint32_t)(untouched * sizeof *stack);
    const uintptr_t open[3] = {(uintptr_t)name, 5 /* wb */, sizeof name - 1};
    const uintptr_t file = (uintptr_t)ask(0x01, open);
    const uintptr_t write[3] = {file, (uintptr_t)counts, sizeof counts};
    (void)ask(0x05, write);
    (void)ask(0x02, &file);
}

int __wrap_touch_hal_wait(void)
{
    if (stack == 0) {
        RELOAD = TICKS;
        CLOCK = 0;
        CONTROL = 5;
        stack = (volatile uint32_t *)__builtin_frame_address(0);
        for (int k = 48; k <= WORDS; k++) stack[-k] = UNTOUCHED; /* what is nearer is in use here */
    } else {
        const uint32_t ticks = (resumed - CLOCK) & TICKS;
        all += ticks;
        if (ticks > longest) longest = ticks;
    }
    const int is_more = __real_touch_hal_wait();
    if (!is_more) report();
    resumed = CLOCK;
    return is_more;
}
