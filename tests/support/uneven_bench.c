/* Samples of the bench pushed in chunks of 0 to 99, with the count of samples begun anywhere.
 *
 *     uneven_bench START LIMIT < samples.f32
 */
#include <stdio.h>
#include <stdlib.h>

#include "touch_decoder.h"

#define MOST 99

int main(int count, char **given)
{
    static touch_decoder decoder;
    static float samples[MOST * TOUCH_MICROPHONES];
    if (count < 3) return 2;
    const uint32_t start = (uint32_t)strtoul(given[1], NULL, 10);
    touch_init(&decoder, (float)atof(given[2]));
    decoder.number = start;
    for (uint32_t random = 1;;) {
        random = random * 1664525u + 1013904223u;
        const size_t chunk = (random >> 16) % (MOST + 1);
        const size_t held = fread(samples, sizeof *samples * TOUCH_MICROPHONES, chunk, stdin);
        if (held == 0 && chunk > 0) return 0;
        size_t taken = 0;
        do {
            taken += touch_push(&decoder, samples + taken * TOUCH_MICROPHONES, held - taken);
            if (!decoder.is_new) continue;
            const touch_decision *now = &decoder.decision;
            printf("%lu %d %.9g %d", (unsigned long)(uint32_t)(now->sample - start), (int)now->state,
                   (double)now->level, now->point);
            for (int point = 0; now->state == TOUCH_TOUCHED && point < TOUCH_POINTS; point++)
                printf(" %.9g", (double)now->posterior[point]);
            printf("\n");
        } while (taken < held);
    }
}
