/* In place of Arduino: a serial port that writes to stdout. */
#ifndef STUB_ARDUINO_H
#define STUB_ARDUINO_H
#include <stddef.h>
#include <stdint.h>

struct SerialPort {
    void begin(unsigned long baud);
    int availableForWrite();
    explicit operator bool() const { return true; }
    size_t write(const uint8_t *bytes, size_t count);
    void print(const char *text);
    void println(int number);
};
extern SerialPort Serial;
void delay(unsigned long milliseconds);
void yield();
void setup();
void loop();
#endif
