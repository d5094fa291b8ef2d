/* The ring of touch_ring.h. */
#include "touch_ring.h"

#include <string.h>

void touch_ring_put(touch_ring *ring, const int16_t *samples, uint32_t count)
{
    const uint32_t written = ring->written;
    if (samples == NULL || ring->lost != ring->told || TOUCH_RING - (written - ring->read) < count) {
        ring->lost += count;
        return;
    }
    for (uint32_t k = 0; k < count; k++)
        memcpy(ring->samples[(written + k) % TOUCH_RING], samples + k * TOUCH_MICROPHONES, sizeof ring->samples[0]);
    ring->written = written + count;
}

uint32_t touch_ring_get(touch_ring *ring, int16_t *samples, uint32_t most)
{
    const uint32_t read = ring->read, held = ring->written - read;
    const uint32_t count = held < most ? held : most;
    for (uint32_t k = 0; k < count; k++)
        memcpy(samples + k * TOUCH_MICROPHONES, ring->samples[(read + k) % TOUCH_RING], sizeof ring->samples[0]);
    ring->read = read + count;
    return count;
}

uint32_t touch_ring_lost(touch_ring *ring)
{
    const uint32_t lost = ring->lost, more = lost - ring->told;
    /* What was put before the loss is read first: the interrupt puts nothing more until the loss is told. */
    if (more == 0 || ring->written != ring->read) return 0;
    ring->told = lost;
    return more;
}
