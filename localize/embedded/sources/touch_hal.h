/* What a board must do: five functions. Those of the exported board are in the file whose name begins with touch_board. */
#ifndef TOUCH_HAL_H
#define TOUCH_HAL_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Start the clocks, the microphones and the line. From then on the board calls touch_firmware_take, mostly from an
 * interrupt. Returns 0, or another number if something failed. */
int touch_hal_start(void);
/* Bytes that the line can take now. */
size_t touch_hal_room(void);
/* Send bytes, of which there is room for all; copy them, for they change when this returns. */
void touch_hal_send(const uint8_t *bytes, size_t count);
/* Sleep until the next interrupt. Returns 0 where there will be none, so that the firmware ends: never on a chip. */
int touch_hal_wait(void);
/* Stop: something failed. */
void touch_hal_fail(int reason);

#ifdef __cplusplus
}
#endif

#endif
