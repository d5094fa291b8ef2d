/* The decimator of touch_decimator.h. */
#include "touch_compiler.h"
#include "touch_decimator.h"

#include <string.h>

static float output(const int16_t *history)
{
    float s0 = 0.0f, s1 = 0.0f;
    /* The taps are symmetric: one product for the oldest and the newest sample, and so on to the middle. */
    for (int k = 0; k < TOUCH_FIR_TAPS / 2; k += 2) {
        s0 += touch_fir[k] * (float)(history[k] + history[TOUCH_FIR_TAPS - 1 - k]);
        s1 += touch_fir[k + 1] * (float)(history[k + 1] + history[TOUCH_FIR_TAPS - 2 - k]);
    }
    return s0 + s1;
}

/* Blocks and the rest are counted apart: a count of instants at 16 kHz would begin again at 0 after 3.1 days. */
static void pass(touch_decimator *decimator, uint32_t count)
{
    decimator->number += count / TOUCH_FIR_FACTOR;
    decimator->place += count % TOUCH_FIR_FACTOR;
    if (decimator->place < TOUCH_FIR_FACTOR) return;
    decimator->place -= TOUCH_FIR_FACTOR;
    decimator->number++;
}

int touch_decimator_take(touch_decimator *decimator, const int16_t *samples, float *out)
{
    const uint32_t place = decimator->place;
    if (place == 0)
        for (int m = 0; m < TOUCH_MICROPHONES; m++) {
            int16_t *history = decimator->history[m];
            memmove(history, history + TOUCH_FIR_FACTOR, (TOUCH_FIR_TAPS - TOUCH_FIR_FACTOR) * sizeof *history);
        }
    for (int m = 0; m < TOUCH_MICROPHONES; m++)
        decimator->history[m][TOUCH_FIR_TAPS - TOUCH_FIR_FACTOR + place] = samples[m];
    pass(decimator, 1);
    if (decimator->held < TOUCH_FIR_TAPS) decimator->held++;
    if (place != TOUCH_FIR_FACTOR - 1 || decimator->held < TOUCH_FIR_TAPS) return 0;
    for (int m = 0; m < TOUCH_MICROPHONES; m++) out[m] = output(decimator->history[m]);
    return 1;
}

void touch_decimator_skip(touch_decimator *decimator, uint32_t count)
{
    pass(decimator, count);
    decimator->held = 0;
}
