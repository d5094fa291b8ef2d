/* The firmware of touch_firmware.h. */
#include "touch_firmware.h"

#include "touch_decimator.h"
#include "touch_hal.h"
#include "touch_ring.h"
#include "touch_serial.h"

#define RATE 1000
#define HOP 16         /* instants of 1 kHz in a frame */
#define STATUS_HOPS 16 /* frames of samples between those of the state */
#define AT_ONCE 16

static touch_ring ring;
static touch_decimator decimator;
static touch_serial line;
static float hop[HOP * TOUCH_MICROPHONES];
static uint32_t first, due;     /* numbers of the first instant in the hop, and of the one that comes next */
static int held;                /* instants in the hop */
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

static void send_hop(void)
{
    static uint8_t frame[TOUCH_SERIAL_LARGEST];
    if (held == 0) return;
    if (hops >= STATUS_HOPS) {
        const touch_status status = {first, lost, unsent, TOUCH_FULL_SCALE, TOUCH_POINTS, TOUCH_MICROPHONES,
                                     TOUCH_MODE_RAW, TOUCH_NAME};
        send(frame, touch_serial_status(&line, frame, &status));
        hops = 0;
    }
    send(frame, touch_serial_samples(&line, frame, first, RATE, TOUCH_MICROPHONES, held, hop, TOUCH_FULL_SCALE));
    hops++;
    held = 0;
}

/* An instant of 1 kHz, which is known. A gap before it ends the hop. */
static void take(const float *pressures, uint32_t number)
{
    if (has_begun && number != due) {
        send_hop();
        lost += number - due;
    }
    if (held == 0) first = number;
    for (int m = 0; m < TOUCH_MICROPHONES; m++)
        hop[held * TOUCH_MICROPHONES + m] = pressures[m] * (TOUCH_FULL_SCALE / 32767.0f);
    has_begun = 1;
    due = number + 1;
    if (++held == HOP) send_hop();
}

void touch_firmware_step(void)
{
    int16_t samples[AT_ONCE * TOUCH_MICROPHONES];
    uint32_t count;
    while ((count = touch_ring_get(&ring, samples, AT_ONCE)) > 0)
        for (uint32_t k = 0; k < count; k++) {
            float pressures[TOUCH_MICROPHONES];
            if (touch_decimator_take(&decimator, samples + k * TOUCH_MICROPHONES, pressures))
                take(pressures, decimator.number / TOUCH_FIR_FACTOR - 1);
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
