/* In place of Zephyr: a ring of bytes. */
#ifndef STUB_RING_BUFFER_H
#define STUB_RING_BUFFER_H
#include <stdint.h>

struct ring_buf {
    uint8_t *bytes;
    uint32_t size, put, got;
};
#define RING_BUF_DECLARE(name, count) \
    static uint8_t name##_bytes[count]; \
    static struct ring_buf name = {name##_bytes, count, 0, 0}
static inline uint32_t ring_buf_space_get(struct ring_buf *ring)
{
    return ring->size - (ring->put - ring->got);
}
static inline uint32_t ring_buf_put(struct ring_buf *ring, const uint8_t *bytes, uint32_t count)
{
    for (uint32_t k = 0; k < count; k++) ring->bytes[ring->put++ % ring->size] = bytes[k];
    return count;
}
static inline uint32_t ring_buf_get_claim(struct ring_buf *ring, uint8_t **bytes, uint32_t count)
{
    const uint32_t place = ring->got % ring->size, held = ring->put - ring->got;
    const uint32_t most = held < ring->size - place ? held : ring->size - place;
    *bytes = ring->bytes + place;
    return most < count ? most : count;
}
static inline int ring_buf_get_finish(struct ring_buf *ring, uint32_t count)
{
    ring->got += count;
    return 0;
}
#endif
