/* The decoder on a board: samples of samples.f32 in, through the debugger's door to the host's files; a line for every
 * decision out: sample, state, level, point, ticks of the clock since the one before, stack in bytes, posterior. */
#include <stdint.h>
#include <stdio.h>

#include "touch_decoder.h"

#define CONTROL (*(volatile uint32_t *)0xE000E010)
#define RELOAD (*(volatile uint32_t *)0xE000E014)
#define CLOCK (*(volatile uint32_t *)0xE000E018)
#define TICKS 0xFFFFFFu

#define WORDS 1024 /* of the stack, that are looked at */
#define UNTOUCHED 0xA5C3E1F7u

static touch_decoder decoder;
static float samples[TOUCH_HOP * TOUCH_MICROPHONES];

/* Bytes of the stack that a call takes, from that of this function down. */
__attribute__((noinline)) static uint32_t stack_of(size_t *taken, size_t count, uint32_t *ticks)
{
    volatile uint32_t *const top = (volatile uint32_t *)__builtin_frame_address(0) - 32;
    for (int k = 1; k <= WORDS; k++) top[-k] = UNTOUCHED;
    const uint32_t begin = CLOCK;
    *taken += touch_push(&decoder, samples + *taken * TOUCH_MICROPHONES, count - *taken);
    *ticks += (begin - CLOCK) & TICKS;
    int used = WORDS;
    while (used > 0 && top[-used] == UNTOUCHED) used--;
    return ((uint32_t)used + 32) * (uint32_t)sizeof *top;
}

int main(void)
{
    FILE *in = fopen("samples.f32", "rb");
    if (in == NULL) return 1;
    RELOAD = TICKS;
    CLOCK = 0;
    CONTROL = 5;
    touch_init(&decoder, LIMIT);
    uint32_t ticks = 0, stack = 0;
    for (;;) {
        const size_t held = fread(samples, sizeof *samples * TOUCH_MICROPHONES, TOUCH_HOP, in);
        if (held == 0) return 0;
        for (size_t taken = 0; taken < held;) {
            const uint32_t used = stack_of(&taken, held, &ticks);
            if (used > stack) stack = used;
            if (!decoder.is_new) continue;
            const touch_decision *now = &decoder.decision;
            printf("%lu %d %.9g %d %lu %lu", (unsigned long)now->sample, (int)now->state, (double)now->level,
                   now->point, (unsigned long)ticks, (unsigned long)stack);
            for (int point = 0; now->state == TOUCH_TOUCHED && point < TOUCH_POINTS; point++)
                printf(" %.9g", (double)now->posterior[point]);
            printf("\n");
            ticks = stack = 0;
        }
    }
}
