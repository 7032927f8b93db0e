/* A target for `schuler hil` on a Cortex-M4F: QEMU's mps2-an386, whose first UART is the line.
 *
 *     schuler hil paper --precision f32 --device qemu --image hil-m4f.elf
 *
 * The UART is asked, not waited for: the host sends a frame and waits for its answer, and QEMU keeps what has come. A board
 * whose receiver holds a single byte takes an interrupt and a queue, as tests/firmware has them. */

#include "schuler.h"

#include <stddef.h>
#include <stdint.h>

int main(void);

typedef struct {
    volatile uint32_t data;
    volatile uint32_t state;
    volatile uint32_t control;
    volatile uint32_t interrupt;
    volatile uint32_t divider;
} uart;

#define UART0 ((uart *)0x40004000U)
#define FULL 1U
#define READY 2U

static void send(void *context, const uint8_t *bytes, size_t count)
{
    uart *line = context;
    size_t i;

    for (i = 0; i < count; i++) {
        while ((line->state & FULL) != 0U) {
        }
        line->data = bytes[i];
    }
}

int main(void)
{
    static schuler_target_f32 target;
    int32_t status;

    UART0->divider = 217U;
    UART0->control = 3U;
    status = schuler_target_f32_start(&target, SCHULER_ABI, 0U);
    if (status == SCHULER_OK) {
        status = schuler_target_f32_hello(&target, send, UART0);
    }
    while (status == SCHULER_OK) {
        if ((UART0->state & READY) != 0U) {
            status = schuler_target_f32_take(&target, (uint8_t)UART0->data, send, UART0);
        }
    }
    return 1;
}
