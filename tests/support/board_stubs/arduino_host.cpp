/* The stubs of Arduino: samples from stdin as the microphones' interrupts bring them, one block for each loop. */
#include <Arduino.h>
#include <PDM.h>

#include <cstdio>
#include <cstdlib>

SerialPort Serial;
PDMClass PDM;
static void (*callback)(void);
static int buffer_size, is_full;

void SerialPort::begin(unsigned long baud)
{
    if (baud != 115200) abort();
}
int SerialPort::availableForWrite()
{
#ifdef ARDUINO_ARCH_MBED
    return 0; /* as the core has it, which does not override that of Print */
#else
    return 1024;
#endif
}
size_t SerialPort::write(const uint8_t *bytes, size_t count)
{
    return fwrite(bytes, 1, count, stdout);
}
void SerialPort::print(const char *text)
{
    fprintf(stderr, "%s", text);
}
void SerialPort::println(int number)
{
    fprintf(stderr, "%d\n", number);
}
void delay(unsigned long)
{
    exit(3);
}
void yield()
{
}
int PDMClass::begin(int channels, int rate)
{
    return channels == 2 && rate == 16000 && callback != nullptr;
}
void PDMClass::onReceive(void (*call)(void))
{
    callback = call;
}
void PDMClass::setBufferSize(int bytes)
{
    buffer_size = bytes;
}
int PDMClass::available()
{
    const int next = getc(stdin);
    if (next == EOF) return 0;
    ungetc(next, stdin);
    return is_full ? buffer_size : 0;
}
int PDMClass::read(void *buffer, int bytes)
{
    is_full = 0;
    return static_cast<int>(fread(buffer, 1, static_cast<size_t>(bytes), stdin));
}

int main()
{
    setup();
    while (!feof(stdin)) {
        const int next = getc(stdin);
        if (next == EOF) return 0;
        ungetc(next, stdin);
        is_full = 1;
        callback();
        loop();
    }
    return 0;
}
