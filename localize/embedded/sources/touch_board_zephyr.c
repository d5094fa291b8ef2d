/* The five functions of touch_hal.h for Zephyr: PDM microphones by its DMIC driver, frames by the UART that the device tree
 * chooses as the console. No silicon was tried; the tests compile and run this file with stubs in place of Zephyr.
 *
 * The device tree must have a DMIC at the label dmic_dev. */
#include "touch_compiler.h"

#include <zephyr/audio/dmic.h>
#include <zephyr/device.h>
#include <zephyr/drivers/uart.h>
#include <zephyr/kernel.h>
#include <zephyr/sys/ring_buffer.h>

#include "touch_firmware.h"
#include "touch_hal.h"
#include "touch_tables.h"

#if TOUCH_MICROPHONES > 8
#error "the DMIC driver of Zephyr maps eight microphones"
#endif

#define RATE 16000
#define BLOCK 64   /* instants of a block of the driver: 4 ms */
#define BLOCKS 8   /* of its queue: 32 ms, in which the main loop decides */
#define WAIT_MS 100
#define ROOM 4096  /* bytes that wait for the line */
#define BYTES (BLOCK * TOUCH_MICROPHONES * sizeof(int16_t))

K_MEM_SLAB_DEFINE_STATIC(blocks, BYTES, BLOCKS, 4);
RING_BUF_DECLARE(waiting, ROOM);

static const struct device *const microphones = DEVICE_DT_GET(DT_NODELABEL(dmic_dev));
static const struct device *const line = DEVICE_DT_GET(DT_CHOSEN(zephyr_console));

static void feed(const struct device *device, void *unused)
{
    (void)unused;
    while (uart_irq_update(device) && uart_irq_tx_ready(device)) {
        uint8_t *bytes;
        const uint32_t held = ring_buf_get_claim(&waiting, &bytes, ROOM);
        const int sent = held > 0 ? uart_fifo_fill(device, bytes, (int)held) : 0;
        (void)ring_buf_get_finish(&waiting, sent > 0 ? (uint32_t)sent : 0);
        if (held == 0) {
            uart_irq_tx_disable(device);
            return;
        }
    }
}

int touch_hal_start(void)
{
    struct pcm_stream_cfg stream = {.pcm_rate = RATE, .pcm_width = 16, .block_size = BYTES, .mem_slab = &blocks};
    struct dmic_cfg wanted = {
        .io = {.min_pdm_clk_freq = 1000000, .max_pdm_clk_freq = 3250000, .min_pdm_clk_dc = 40, .max_pdm_clk_dc = 60},
        .streams = &stream,
        .channel = {.req_num_streams = 1, .req_num_chan = TOUCH_MICROPHONES},
    };
    /* Two microphones on each data line, left and right, in the order of the design. */
    for (uint8_t m = 0; m < TOUCH_MICROPHONES; m++)
        wanted.channel.req_chan_map_lo |=
            dmic_build_channel_map(m, m / 2, m % 2 == 0 ? PDM_CHAN_LEFT : PDM_CHAN_RIGHT);
    if (!device_is_ready(microphones) || !device_is_ready(line)) return 1;
    if (uart_irq_callback_user_data_set(line, feed, NULL) < 0) return 2;
    if (dmic_configure(microphones, &wanted) < 0) return 3;
    return dmic_trigger(microphones, DMIC_TRIGGER_START) < 0 ? 4 : 0;
}

size_t touch_hal_room(void)
{
    return ring_buf_space_get(&waiting);
}

void touch_hal_send(const uint8_t *bytes, size_t count)
{
    (void)ring_buf_put(&waiting, bytes, (uint32_t)count);
    uart_irq_tx_enable(line);
}

int touch_hal_wait(void)
{
    void *block;
    size_t bytes;
    if (dmic_read(microphones, 0, &block, &bytes, WAIT_MS) < 0) {
        /* The driver stops when its queue has overflowed: one block is the least that was lost. */
        touch_firmware_take(NULL, BLOCK);
        return dmic_trigger(microphones, DMIC_TRIGGER_START) >= 0;
    }
    touch_firmware_take(block, (uint32_t)(bytes / TOUCH_MICROPHONES / sizeof(int16_t)));
    k_mem_slab_free(&blocks, block);
    return 1;
}

void touch_hal_fail(int reason)
{
    printk("touch_hal_start: %d\n", reason);
    k_panic();
}

int main(void)
{
    touch_firmware_run();
    return 0;
}
