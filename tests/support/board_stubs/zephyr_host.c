/* Devices of the stubs of Zephyr: samples from stdin, frames to stdout; the tenth block is one that the driver failed to
 * deliver, if the environment has STUB_FAILS. */
#include <zephyr/audio/dmic.h>
#include <zephyr/drivers/uart.h>

const struct device stub_dmic_dev = {"dmic_dev"}, stub_zephyr_console = {"console"};
static struct pcm_stream_cfg stream;
static uart_irq_callback_user_data_t callback;
static int ready, enabled, runs, reads;

int uart_irq_callback_user_data_set(const struct device *device, uart_irq_callback_user_data_t call, void *data)
{
    callback = call;
    return device == &stub_zephyr_console && data == NULL ? 0 : -1;
}

void uart_irq_tx_enable(const struct device *device)
{
    enabled = 1;
    ready = 100;
    callback(device, NULL);
}

void uart_irq_tx_disable(const struct device *device)
{
    enabled = device == NULL;
}

int uart_irq_update(const struct device *device)
{
    return device == &stub_zephyr_console;
}

int uart_irq_tx_ready(const struct device *device)
{
    return device != NULL && enabled && ready-- > 0;
}

int uart_fifo_fill(const struct device *device, const uint8_t *bytes, int count)
{
    const int sent = count < 16 ? count : 16;
    return device != NULL && fwrite(bytes, 1, (size_t)sent, stdout) == (size_t)sent ? sent : -1;
}

int dmic_configure(const struct device *device, struct dmic_cfg *wanted)
{
    stream = wanted->streams[0];
    const int is_good = wanted->channel.req_num_streams == 1 && stream.pcm_width == 16 && stream.pcm_rate == 16000;
    if (!is_good || wanted->channel.req_chan_map_lo != 0x10) abort(); /* left and right of the first line */
    return device == &stub_dmic_dev ? 0 : -1;
}

int dmic_trigger(const struct device *device, enum dmic_trigger what)
{
    runs = device != NULL && what == DMIC_TRIGGER_START;
    return feof(stdin) ? -1 : 0;
}

int dmic_read(const struct device *device, uint8_t number, void **block, size_t *bytes, int32_t timeout)
{
    if (device != &stub_dmic_dev || number != 0 || timeout <= 0 || !runs) abort();
    if (stream.mem_slab->held >= stream.mem_slab->count) abort();
    *block = malloc(stream.block_size);
    *bytes = fread(*block, 1, stream.block_size, stdin);
    if (*bytes == stream.block_size && !(++reads == 10 && getenv("STUB_FAILS") != NULL)) {
        stream.mem_slab->held++;
        return 0;
    }
    free(*block);
    runs = 0;
    return -5;
}
