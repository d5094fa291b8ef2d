/* A producer and a consumer of touch_ring.h in threads of their own: every sample that comes out must be the one that
 * went in, and every gap as long as what the ring says was lost. Prints samples and losses; ends with 1 at a mistake. */
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdio.h>

#include "touch_ring.h"

#define INSTANTS 500000u
#define CHUNK 64

static touch_ring ring;
static atomic_int has_ended;
static atomic_uint done; /* instants that the consumer knows of; relaxed, so that it orders nothing */

static int16_t value(uint32_t instant, int microphone)
{
    return (int16_t)((instant * 2654435761u) >> (7 + microphone));
}

static void *produce(void *unused)
{
    static int16_t block[CHUNK * TOUCH_MICROPHONES];
    uint32_t at = 0, turn = 1;
    (void)unused;
    while (at < INSTANTS) {
        turn = turn * 1664525u + 1013904223u;
        /* As a rule, it waits for room, so that threads which take turns are no single long loss. */
        while (at - atomic_load_explicit(&done, memory_order_relaxed) > TOUCH_RING - CHUNK && (turn >> 8 & 511) != 0)
            (void)sched_yield();
        const uint32_t count = 1 + (turn >> 16) % CHUNK;
        for (uint32_t k = 0; k < count; k++)
            for (int m = 0; m < TOUCH_MICROPHONES; m++) block[k * TOUCH_MICROPHONES + (uint32_t)m] = value(at + k, m);
        touch_ring_put(&ring, (turn >> 24) == 0 ? NULL : block, count);
        at += count;
    }
    atomic_store(&has_ended, 1);
    return NULL;
}

int main(void)
{
    static int16_t samples[CHUNK * TOUCH_MICROPHONES];
    uint32_t at = 0, got = 0, lost = 0, gaps = 0;
    pthread_t thread;
    if (pthread_create(&thread, NULL, produce, NULL) != 0) return 2;
    for (int is_last = 0;;) {
        const int ended = atomic_load(&has_ended);
        uint32_t count;
        while ((count = touch_ring_get(&ring, samples, 1 + at % CHUNK)) > 0)
            for (uint32_t k = 0; k < count; k++, at++, got++)
                for (int m = 0; m < TOUCH_MICROPHONES; m++)
                    if (samples[k * TOUCH_MICROPHONES + (uint32_t)m] != value(at, m)) {
                        printf("wrong sample at instant %lu\n", (unsigned long)at);
                        return 1;
                    }
        const uint32_t missing = touch_ring_lost(&ring);
        at += missing;
        atomic_store_explicit(&done, at, memory_order_relaxed);
        lost += missing;
        gaps += missing > 0;
        if (is_last && missing == 0) break;
        is_last = ended;
    }
    (void)pthread_join(thread, NULL);
    printf("%lu %lu %lu %lu\n", (unsigned long)got, (unsigned long)lost, (unsigned long)gaps, (unsigned long)at);
    return at < INSTANTS || at >= INSTANTS + CHUNK;
}
