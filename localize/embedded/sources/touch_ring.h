/* Samples on their way from an interrupt to the main loop: one writes, one reads, and nobody waits.
 *
 * A ring that is full takes nothing more until it has been emptied, so that what is lost is one gap, and its place is
 * known: behind the samples that the ring holds.
 */
#ifndef TOUCH_RING_H
#define TOUCH_RING_H

#include <stddef.h>
#include <stdint.h>

#include "touch_tables.h"

#define TOUCH_RING 1024 /* instants that it holds, a power of two: 64 ms at 16 kHz */

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    int16_t samples[TOUCH_RING][TOUCH_MICROPHONES];
    uint32_t written, read; /* instants since the start; touch_ring.c says why they are safe from an interrupt */
    uint32_t lost, told;    /* instants that were lost, and those that the reader knows of */
} touch_ring;

/* For the interrupt: instants of all microphones, interleaved. With NULL they are lost. */
void touch_ring_put(touch_ring *ring, const int16_t *samples, uint32_t count);
/* For the main loop: at most so many instants; returns how many. */
uint32_t touch_ring_get(touch_ring *ring, int16_t *samples, uint32_t most);
/* For the main loop, where touch_ring_get gives none: instants that were lost since then. */
uint32_t touch_ring_lost(touch_ring *ring);

#ifdef __cplusplus
}
#endif

#endif
