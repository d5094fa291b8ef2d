/* Frames for a serial line: samples, touches and the state of the board as bytes. Table of bytes: docs/serial.md of
 * acoustic-fem.
 *
 * Portable C99: no heap, nothing but string.h. All numbers are little-endian, whatever the processor is.
 *
 *     static touch_serial line;                            all zero: the counter begins at 0
 *     uint8_t frame[TOUCH_SERIAL_LARGEST];
 *     size_t count = touch_serial_touch(&line, frame, &event);
 *     send(frame, count);
 */
#ifndef TOUCH_SERIAL_H
#define TOUCH_SERIAL_H

#include <stddef.h>
#include <stdint.h>

#define TOUCH_SERIAL_VERSION 1
#define TOUCH_SERIAL_HEADER 12   /* bytes before the payload */
#define TOUCH_SERIAL_RAW 16      /* bytes of a payload of samples before the samples */
#define TOUCH_SERIAL_NUMBERS 256 /* most samples of all microphones in a frame */
#define TOUCH_SERIAL_NAME 32     /* most bytes of the name of an array */
/* Bytes of the longest frame. */
#define TOUCH_SERIAL_LARGEST (TOUCH_SERIAL_HEADER + TOUCH_SERIAL_RAW + 2 * TOUCH_SERIAL_NUMBERS + 2)

#ifdef __cplusplus
extern "C" {
#endif

typedef enum { TOUCH_DOWN = 1, TOUCH_MOVED = 2, TOUCH_BEAT = 3, TOUCH_UP = 4 } touch_kind;

typedef struct {
    uint32_t sample;   /* samples of 1 kHz up to the end of the frame that decided it */
    uint32_t touch;    /* number of the touch, from 1 */
    touch_kind kind;
    int point;         /* touched from now on, or until now; from 1 */
    float probability; /* of that point by all frames of the touch */
    float level;       /* of the loudest microphone, Pa rms */
    float latency;     /* longest time from the event to its report on the board, s */
} touch_event;

typedef enum { TOUCH_MODE_RAW, TOUCH_MODE_EVENTS } touch_mode;

typedef struct {
    uint32_t sample;   /* samples of 1 kHz since the start, lost ones included */
    uint32_t lost;     /* samples of 1 kHz that were lost on the board since the start */
    uint32_t unsent;   /* frames that found no room on the line since the start */
    float limit;       /* Pa, at which a sample is clipped; 0 where none is */
    int points, microphones;
    touch_mode mode;
    const char *name;  /* of the array, in UTF-8; the first 32 bytes are sent */
} touch_status;

typedef struct {
    uint32_t counter;  /* frames so far */
} touch_serial;

/* CRC-16/CCITT-FALSE: x^16 + x^12 + x^5 + 1, from 0xFFFF. */
uint16_t touch_serial_crc(const uint8_t *bytes, size_t count);

/* Each of these writes one frame, at most TOUCH_SERIAL_LARGEST bytes, and returns its length. A frame that is not sent
 * then is counted by the receiver, because the counter goes on. */
size_t touch_serial_status(touch_serial *line, uint8_t *frame, const touch_status *status);
size_t touch_serial_touch(touch_serial *line, uint8_t *frame, const touch_event *event);

/* Samples in Pa, interleaved by microphone, of 1 to 16 microphones, at most TOUCH_SERIAL_NUMBERS in all; NaN for those
 * that are lost. first: number of the first one. rate: Hz. limit: Pa, at which a sample is clipped; 0 where none is.
 * Returns 0 where there are too many. */
size_t touch_serial_samples(touch_serial *line, uint8_t *frame, uint32_t first, uint16_t rate, int microphones,
                            int count, const float *samples, float limit);

#ifdef __cplusplus
}
#endif

#endif
