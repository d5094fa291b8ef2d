/* Samples of 16 kHz to 1 kHz: a linear-phase low-pass of which every sixteenth output is computed. Its response stands
 * in the README. */
#ifndef TOUCH_DECIMATOR_H
#define TOUCH_DECIMATOR_H

#include <stdint.h>

#include "touch_decimator_taps.h"
#include "touch_tables.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    int16_t history[TOUCH_MICROPHONES][TOUCH_FIR_TAPS]; /* the newest samples, oldest first; a block comes in at the end */
    uint32_t number;                                    /* whole blocks since the start, lost ones included: 1 kHz */
    uint32_t place;                                     /* instants of 16 kHz in the block that has begun */
    uint32_t held;                                      /* instants since the start or the last gap, at most the taps */
} touch_decimator;

/* Take an instant of all microphones. Returns 1 where an output is due and known: then out has it, in units of the
 * samples, and its number is number - 1. Numbers begin again at 0 after 49 days. */
int touch_decimator_take(touch_decimator *decimator, const int16_t *samples, float *out);
/* Instants that were lost. */
void touch_decimator_skip(touch_decimator *decimator, uint32_t count);

#ifdef __cplusplus
}
#endif

#endif
