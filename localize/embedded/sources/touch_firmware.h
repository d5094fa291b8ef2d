/* The firmware of a sensor: samples of 16 kHz in, frames of touch_serial.h out. They hold samples of 1 kHz, or touches. */
#ifndef TOUCH_FIRMWARE_H
#define TOUCH_FIRMWARE_H

#include <stddef.h>
#include <stdint.h>

/* 0: it sends samples, for a computer that locates touches. 1: it locates them and sends touches. */
#ifndef TOUCH_EVENT_MODE
#define TOUCH_EVENT_MODE 0
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* For the board's interrupt: instants of all microphones at 16 kHz, interleaved in the order of the design. NULL for
 * instants that the board lost. */
void touch_firmware_take(const int16_t *samples, uint32_t count);
/* For main: runs until touch_hal_wait returns 0. */
void touch_firmware_run(void);
/* For a main loop of your own, after touch_hal_start: do what there is to do now. */
void touch_firmware_step(void);

#ifdef __cplusplus
}
#endif

#endif
