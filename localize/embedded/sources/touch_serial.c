/* The frames of touch_serial.h. Table of bytes: docs/serial.md of acoustic-fem. */
#include "touch_compiler.h"
#include "touch_serial.h"

#include <string.h>

#define SYNC_0 0xA5
#define SYNC_1 0x5A
#define STATUS 1
#define SAMPLES 2
#define TOUCH 3
#define LARGEST_NUMBER 32767
#define LOST (-32768)
/* Bits of 1e6 Pa: what lies above, without its sign, is no pressure. */
#define LARGEST_PRESSURE_BITS 0x49742400u

uint16_t touch_serial_crc(const uint8_t *bytes, size_t count)
{
    uint16_t crc = 0xFFFF;
    for (size_t k = 0; k < count; k++) {
        /* Eight bits at once: Bennett's form of the polynomial. */
        crc = (uint16_t)(crc >> 8 | crc << 8);
        crc = (uint16_t)(crc ^ bytes[k]);
        crc = (uint16_t)(crc ^ (crc & 0xFF) >> 4);
        crc = (uint16_t)(crc ^ crc << 12);
        crc = (uint16_t)(crc ^ (crc & 0xFF) << 5);
    }
    return crc;
}

static void put_16(uint8_t *out, uint32_t value)
{
    out[0] = (uint8_t)(value & 0xFF);
    out[1] = (uint8_t)(value >> 8 & 0xFF);
}

static void put_32(uint8_t *out, uint32_t value)
{
    put_16(out, value);
    put_16(out + 2, value >> 16);
}

static uint32_t bits_of(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

static void put_float(uint8_t *out, float value)
{
    put_32(out, bits_of(value));
}

static int is_pressure(float value)
{
    return (bits_of(value) & 0x7FFFFFFFu) < LARGEST_PRESSURE_BITS;
}

/* Header and checks about a payload of so many bytes that lies behind the header. */
static size_t closed(touch_serial *line, uint8_t *frame, uint8_t type, size_t count)
{
    frame[0] = SYNC_0;
    frame[1] = SYNC_1;
    frame[2] = TOUCH_SERIAL_VERSION;
    frame[3] = type;
    put_32(frame + 4, line->counter++);
    put_16(frame + 8, (uint32_t)count);
    put_16(frame + 10, touch_serial_crc(frame, 10));
    put_16(frame + TOUCH_SERIAL_HEADER + count, touch_serial_crc(frame, TOUCH_SERIAL_HEADER + count));
    return TOUCH_SERIAL_HEADER + count + 2;
}

size_t touch_serial_status(touch_serial *line, uint8_t *frame, const touch_status *status)
{
    uint8_t *payload = frame + TOUCH_SERIAL_HEADER;
    size_t length = 0;
    while (length < TOUCH_SERIAL_NAME && status->name[length] != '\0') length++;
    put_32(payload, status->sample);
    put_32(payload + 4, status->lost);
    put_32(payload + 8, status->unsent);
    put_float(payload + 12, status->limit);
    put_16(payload + 16, (uint32_t)status->points);
    payload[18] = (uint8_t)status->microphones;
    payload[19] = (uint8_t)status->mode;
    memcpy(payload + 20, status->name, length);
    return closed(line, frame, STATUS, 20 + length);
}

size_t touch_serial_touch(touch_serial *line, uint8_t *frame, const touch_event *event)
{
    uint8_t *payload = frame + TOUCH_SERIAL_HEADER;
    put_32(payload, event->sample);
    put_32(payload + 4, event->touch);
    put_16(payload + 8, (uint32_t)event->point);
    payload[10] = (uint8_t)event->kind;
    payload[11] = 0;
    put_float(payload + 12, event->probability);
    put_float(payload + 16, event->level);
    put_float(payload + 20, event->latency);
    return closed(line, frame, TOUCH, 24);
}

size_t touch_serial_samples(touch_serial *line, uint8_t *frame, uint32_t first, uint16_t rate, int microphones,
                            int count, const float *samples, float limit)
{
    const int numbers = microphones * count;
    float largest = 0.0f;
    if (microphones < 1 || microphones > 16 || count < 1 || count > 255 || numbers > TOUCH_SERIAL_NUMBERS) return 0;
    for (int k = 0; k < numbers; k++) {
        const float size = samples[k] < 0.0f ? -samples[k] : samples[k];
        if (is_pressure(size) && size > largest) largest = size;
    }
    /* The largest of a frame fills 16 bits, so that quiet samples are as exact as loud ones. */
    const float step = largest > 1e-30f ? largest / LARGEST_NUMBER : 1e-30f;
    uint8_t *payload = frame + TOUCH_SERIAL_HEADER;
    put_32(payload, first);
    put_16(payload + 4, rate);
    payload[6] = (uint8_t)microphones;
    payload[7] = (uint8_t)count;
    put_float(payload + 8, step);
    put_float(payload + 12, limit);
    for (int k = 0; k < numbers; k++) {
        int32_t number = LOST;
        if (is_pressure(samples[k])) {
            const float ratio = samples[k] / step;
            number = (int32_t)(ratio < 0.0f ? ratio - 0.5f : ratio + 0.5f);
            if (number > LARGEST_NUMBER) number = LARGEST_NUMBER;
            if (number < -LARGEST_NUMBER) number = -LARGEST_NUMBER;
        }
        put_16(payload + TOUCH_SERIAL_RAW + 2 * k, (uint32_t)number & 0xFFFFu);
    }
    return closed(line, frame, SAMPLES, TOUCH_SERIAL_RAW + 2 * (size_t)numbers);
}
