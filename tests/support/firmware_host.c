/* The five functions of touch_hal.h on the host: samples from stdin, frames to stdout. Arguments are pairs: at the
 * instant of the first, as many instants as the second are lost. With a third one, "jam", the line is full at first. */
#include <stdio.h>
#include <stdlib.h>

#include "touch_firmware.h"
#include "touch_hal.h"
#include "touch_tables.h"

#define BLOCK 50

static int pairs, next;
static char **given;
static unsigned long at;

int touch_hal_start(void)
{
    return 0;
}

size_t touch_hal_room(void)
{
    return at < 3000 && pairs == 0 ? 60 : 4096;
}

void touch_hal_send(const uint8_t *bytes, size_t count)
{
    if (fwrite(bytes, 1, count, stdout) != count) abort();
}

int touch_hal_wait(void)
{
    static int16_t block[BLOCK * TOUCH_MICROPHONES];
    size_t count = BLOCK;
    if (next < pairs) {
        const unsigned long begin = strtoul(given[2 * next], NULL, 10), length = strtoul(given[2 * next + 1], NULL, 10);
        if (at == begin) {
            for (unsigned long k = 0; k < length; k++)
                if (fread(block, sizeof *block * TOUCH_MICROPHONES, 1, stdin) != 1) abort();
            touch_firmware_take(NULL, (uint32_t)length);
            at += length;
            next++;
            return 1;
        }
        if (begin - at < count)
            count = begin - at;
    }
    count = fread(block, sizeof *block * TOUCH_MICROPHONES, count, stdin);
    touch_firmware_take(block, (uint32_t)count);
    at += count;
    return count > 0;
}

void touch_hal_fail(int reason)
{
    exit(reason);
}

int main(int count, char **arguments)
{
    pairs = (count - 1) / 2;
    given = arguments + 1;
    touch_firmware_run();
    return 0;
}
