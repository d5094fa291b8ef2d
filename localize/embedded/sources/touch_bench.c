/* A test bench for the host: reads interleaved samples, 32-bit floats in Pa, and writes a line for every decision.
 *
 *     touch_bench CHUNK LIMIT < samples.f32
 */
#include "touch_compiler.h"

#include <stdio.h>
#include <stdlib.h>

#include "touch_decoder.h"

#define MOST 4096

int main(int count, char **given)
{
    static touch_decoder decoder;
    static float samples[MOST * TOUCH_MICROPHONES];
    const int chunk = count > 1 ? atoi(given[1]) : TOUCH_HOP;
    if (chunk < 1 || chunk > MOST) {
        fprintf(stderr, "touch_bench: CHUNK must be 1 to %d samples\n", MOST);
        return 2;
    }
    touch_init(&decoder, count > 2 ? (float)atof(given[2]) : 0.0f);
    for (;;) {
        const size_t held = fread(samples, sizeof *samples * TOUCH_MICROPHONES, (size_t)chunk, stdin);
        if (held == 0) return 0;
        for (size_t taken = 0; taken < held;) {
            taken += touch_push(&decoder, samples + taken * TOUCH_MICROPHONES, held - taken);
            if (!decoder.is_new) continue;
            const touch_decision *now = &decoder.decision;
            printf("%lu %d %.9g %d", (unsigned long)now->sample, (int)now->state, (double)now->level, now->point);
            for (int point = 0; now->state == TOUCH_TOUCHED && point < TOUCH_POINTS; point++)
                printf(" %.9g", (double)now->posterior[point]);
            printf("\n");
        }
    }
}
