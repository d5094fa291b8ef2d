/* The firmware of touch_firmware.h. */
#include "touch_compiler.h"
#include "touch_firmware.h"

#include <string.h>

#include "touch_decimator.h"
#include "touch_hal.h"
#include "touch_ring.h"
#include "touch_serial.h"

#if TOUCH_EVENT_MODE
#include "touch_decoder.h"
#include "touch_tracker.h"
#endif

#define RATE 1000
#define HOP 16         /* instants of 1 kHz from one frame of samples, or decision, to the next */
#define STATUS_HOPS 16 /* hops from one frame of the state to the next */
#define AT_ONCE 16
#define PASCALS (TOUCH_FULL_SCALE / (float)TOUCH_LARGEST)
#define LIMIT (TOUCH_FULL_SCALE < TOUCH_OVERLOAD ? TOUCH_FULL_SCALE : TOUCH_OVERLOAD)
#define NEARLY 0.9999f /* of the limit: a sample from there on is clipped */

static touch_ring ring;
static touch_decimator decimator;
static touch_serial line;
static uint32_t due;            /* number of the instant of 1 kHz that comes next */
static int hops = STATUS_HOPS;  /* since the last state */
static int has_begun;
static uint32_t lost, unsent;

void touch_firmware_take(const int16_t *samples, uint32_t count)
{
    touch_ring_put(&ring, samples, count);
}

static void send(const uint8_t *frame, size_t count)
{
    if (touch_hal_room() < count)
        unsent++;
    else
        touch_hal_send(frame, count);
}

/* The state of the board, where it is time for it. */
static void send_state(uint8_t *frame, uint32_t number)
{
    const touch_mode mode = TOUCH_EVENT_MODE ? TOUCH_MODE_EVENTS : TOUCH_MODE_RAW;
    const touch_status status = {number, lost, unsent, LIMIT, TOUCH_POINTS, TOUCH_MICROPHONES,
                                 mode, TOUCH_NAME};
    if (hops < STATUS_HOPS) return;
    send(frame, touch_serial_status(&line, frame, &status));
    hops = 0;
}

#if TOUCH_EVENT_MODE
static touch_decoder decoder;
static touch_tracker tracker;

static void begin(void)
{
    touch_init(&decoder, NEARLY * LIMIT);
    touch_tracker_init(&tracker, TOUCH_DELAY + TOUCH_FIR_DELAY);
}

static void gap(uint32_t count)
{
    touch_skip(&decoder, count);
}

static void take_known(const float *pressures)
{
    static uint8_t frame[TOUCH_SERIAL_LARGEST];
    touch_event events[TOUCH_EVENTS_AT_ONCE];
    (void)touch_push(&decoder, pressures, 1);
    if (!decoder.is_new) return;
    const int count = touch_tracker_take(&tracker, &decoder.decision, events);
    send_state(frame, decoder.decision.sample);
    for (int k = 0; k < count; k++) send(frame, touch_serial_touch(&line, frame, &events[k]));
    hops++;
}
#else
static float hop[HOP * TOUCH_MICROPHONES];
static uint32_t first; /* number of the first instant in the hop */
static int held;       /* instants in the hop */

static void begin(void)
{
}

static void send_hop(void)
{
    static uint8_t frame[TOUCH_SERIAL_LARGEST];
    if (held == 0) return;
    send_state(frame, first);
    send(frame, touch_serial_samples(&line, frame, first, RATE, TOUCH_MICROPHONES, held, hop, LIMIT));
    hops++;
    held = 0;
}

/* A gap ends the hop. */
static void gap(uint32_t count)
{
    (void)count;
    send_hop();
}

static void take_known(const float *pressures)
{
    if (held == 0) first = due;
    memcpy(hop + held * TOUCH_MICROPHONES, pressures, TOUCH_MICROPHONES * sizeof *hop);
    if (++held == HOP) send_hop();
}
#endif

/* An instant of 1 kHz, which is known. */
static void take(float *pressures, uint32_t number)
{
    if (!has_begun) begin();
    if (number != due) {
        gap(number - due);
        if (has_begun) lost += number - due;
    }
    for (int m = 0; m < TOUCH_MICROPHONES; m++) pressures[m] *= PASCALS;
    has_begun = 1;
    due = number;
    take_known(pressures);
    due++;
}

void touch_firmware_step(void)
{
    int16_t samples[AT_ONCE * TOUCH_MICROPHONES];
    uint32_t count;
    while ((count = touch_ring_get(&ring, samples, AT_ONCE)) > 0)
        for (uint32_t k = 0; k < count; k++) {
            float pressures[TOUCH_MICROPHONES];
            if (touch_decimator_take(&decimator, samples + k * TOUCH_MICROPHONES, pressures))
                take(pressures, decimator.number - 1);
        }
    const uint32_t missing = touch_ring_lost(&ring);
    if (missing > 0) touch_decimator_skip(&decimator, missing);
}

void touch_firmware_run(void)
{
    const int reason = touch_hal_start();
    if (reason != 0) touch_hal_fail(reason);
    do
        touch_firmware_step();
    while (touch_hal_wait());
}
