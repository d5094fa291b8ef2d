/* The five functions of touch_hal.h for Arduino: one or two PDM microphones by its library PDM, frames by Serial. No silicon
 * was tried; the tests compile and run this file with stubs in place of Arduino. */
#include "touch_compiler.h"

#include <Arduino.h>
#include <PDM.h>

#include "touch_firmware.h"
#include "touch_hal.h"
#include "touch_serial.h"
#include "touch_tables.h"

#if TOUCH_MICROPHONES > 2
#error "the library PDM of Arduino reads two microphones; write touch_hal.h for your converter"
#endif

#ifndef TOUCH_BAUD
#define TOUCH_BAUD 115200 /* of a UART; USB ignores it */
#endif

static const int RATE = 16000;
static const int INSTANTS = 64; /* of a block: 4 ms */
static const int BYTES = INSTANTS * TOUCH_MICROPHONES * static_cast<int>(sizeof(int16_t));

/* From the interrupt of the microphones. */
static void received()
{
    static int16_t block[INSTANTS * TOUCH_MICROPHONES];
    while (PDM.available() >= BYTES) {
        const int bytes = PDM.read(block, BYTES);
        touch_firmware_take(block, static_cast<uint32_t>(bytes) / TOUCH_MICROPHONES / sizeof(int16_t));
        if (bytes < BYTES) return;
    }
}

int touch_hal_start(void)
{
    Serial.begin(TOUCH_BAUD);
    PDM.onReceive(received);
    PDM.setBufferSize(BYTES);
    return PDM.begin(TOUCH_MICROPHONES, RATE) ? 0 : 1;
}

size_t touch_hal_room(void)
{
#if defined(ARDUINO_ARCH_MBED) || defined(ARDUINO_ARCH_RENESAS)
    /* Serial of these cores states no room, and write waits for the line. */
    return Serial ? TOUCH_SERIAL_LARGEST : 0;
#else
    const int room = Serial.availableForWrite();
    return room > 0 ? static_cast<size_t>(room) : 0;
#endif
}

void touch_hal_send(const uint8_t *bytes, size_t count)
{
    (void)Serial.write(bytes, count);
}

int touch_hal_wait(void)
{
    yield();
    return 1;
}

void touch_hal_fail(int reason)
{
    for (;;) {
        Serial.print("touch_hal_start: ");
        Serial.println(reason);
        delay(1000);
    }
}

void setup()
{
    const int reason = touch_hal_start();
    if (reason != 0) touch_hal_fail(reason);
}

void loop()
{
    touch_firmware_step();
}
