/* In place of Zephyr: blocks of memory, and the end of the program. */
#ifndef STUB_KERNEL_H
#define STUB_KERNEL_H
#include <stdio.h>
#include <stdlib.h>

#include <zephyr/device.h>

struct k_mem_slab {
    size_t size;
    int held, count;
};
#define K_MEM_SLAB_DEFINE_STATIC(name, block_size, blocks, align) static struct k_mem_slab name = {block_size, 0, blocks}
#define printk printf
#define k_panic() exit(3)
static inline void k_mem_slab_free(struct k_mem_slab *slab, void *block)
{
    slab->held--;
    free(block);
}
#endif
