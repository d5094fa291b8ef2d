/* The ring of touch_ring.h.
 *
 * Safe between one interrupt, or thread, or core, that puts and one main loop that gets. Each count has one writer, and
 * is read and written at once, because it has 32 bits. A side publishes its count behind what the count promises: the
 * samples that lie in the ring, or the places that are free again. So the other side, which sees the count first, finds
 * the samples whole. A volatile count alone would not do: compilers may move the copying of samples, which are not
 * volatile, to the other side of it, and so may a processor with several cores. On a Cortex-M the order costs a
 * barrier instruction for each count, and neither a lock nor a disabled interrupt. */
#include "touch_compiler.h"
#include "touch_ring.h"

#include <string.h>

#if defined(__GNUC__) /* gcc, clang and Arm's compiler, in any version of C */
static uint32_t seen(const uint32_t *count)
{
    return __atomic_load_n(count, __ATOMIC_ACQUIRE);
}

static void publish(uint32_t *count, uint32_t value)
{
    __atomic_store_n(count, value, __ATOMIC_RELEASE);
}
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L && !defined(__STDC_NO_ATOMICS__)
#include <stdatomic.h>

static uint32_t seen(const uint32_t *count)
{
    const uint32_t value = *(const volatile uint32_t *)count;
    atomic_thread_fence(memory_order_acquire);
    return value;
}

static void publish(uint32_t *count, uint32_t value)
{
    atomic_thread_fence(memory_order_release);
    *(volatile uint32_t *)count = value;
}
#else
#error "touch_ring.c needs gcc, clang or C11 with atomics; write seen and publish with the barriers of your compiler"
#endif

void touch_ring_put(touch_ring *ring, const int16_t *samples, uint32_t count)
{
    const uint32_t written = ring->written;
    if (samples == NULL || ring->lost != seen(&ring->told) || TOUCH_RING - (written - seen(&ring->read)) < count) {
        publish(&ring->lost, ring->lost + count);
        return;
    }
    for (uint32_t k = 0; k < count; k++)
        memcpy(ring->samples[(written + k) % TOUCH_RING], samples + k * TOUCH_MICROPHONES, sizeof ring->samples[0]);
    publish(&ring->written, written + count);
}

uint32_t touch_ring_get(touch_ring *ring, int16_t *samples, uint32_t most)
{
    const uint32_t read = ring->read, held = seen(&ring->written) - read;
    const uint32_t count = held < most ? held : most;
    for (uint32_t k = 0; k < count; k++)
        memcpy(samples + k * TOUCH_MICROPHONES, ring->samples[(read + k) % TOUCH_RING], sizeof ring->samples[0]);
    publish(&ring->read, read + count);
    return count;
}

uint32_t touch_ring_lost(touch_ring *ring)
{
    const uint32_t lost = seen(&ring->lost), more = lost - ring->told;
    /* What was put before the loss is read first: the interrupt puts nothing more until the loss is told. */
    if (more == 0 || seen(&ring->written) != ring->read) return 0;
    publish(&ring->told, lost);
    return more;
}
