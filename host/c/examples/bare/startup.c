/* A Cortex-M from reset to main, with nothing of a C library: the vector table, the FPU, memory, and semihosting, by which
 * QEMU or a debugger shows what the program says. */

#include <stddef.h>
#include <stdint.h>

extern uint32_t _stack_top[], _data_load[], _data_start[], _data_end[], _bss_start[], _bss_end[];

int main(void);
void say(const char *text);
void finish(int failed);
void reset(void);
void fault(void);

static void semihosting(uint32_t operation, uintptr_t argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register uintptr_t r1 __asm__("r1") = argument;

    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void say(const char *text)
{
    semihosting(0x04U, (uintptr_t)text);
}

/* Ends the program: QEMU exits with 0 or 1. */
void finish(int failed)
{
    semihosting(0x18U, (failed == 0) ? 0x20026U : 0x20023U);
    for (;;) {
    }
}

void fault(void)
{
    say("fault\n");
    finish(1);
}

void reset(void)
{
    uint32_t *from = _data_load;
    uint32_t *to;

#if defined(__ARM_FP)
    /* Coprocessors 10 and 11. Flush-to-zero stays off, as it is after reset. */
    *(volatile uint32_t *)0xe000ed88U |= 0xfU << 20U;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
    for (to = _data_start; to < _data_end; to++) {
        *to = *from;
        from++;
    }
    for (to = _bss_start; to < _bss_end; to++) {
        *to = 0U;
    }
    finish(main());
}

typedef void (*handler)(void);

__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    handler handlers[15];
} vectors = {
    _stack_top,
    { reset, fault, fault, fault, fault, fault, fault, NULL, NULL, NULL, fault, fault, NULL, fault, fault },
};
