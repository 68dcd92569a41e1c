// The second boot stage (RP2040 data sheet, 2.8.1.3): the chip's ROM copies these 256 bytes into the RAM, checks their
// CRC, which image.py puts in, and calls them with the flash in its power-up state. They make the flash readable at
// 0x10000000 by the basic command that every flash chip has (4.10.13: SSI registers), copy the whole program into the
// RAM and start it there: no instruction waits for the flash afterwards.
    .syntax unified
    .cpu cortex-m0plus
    .thumb
    .section .boot2, "ax"
    ldr   r3, =0x18000000
    movs  r0, #0
    str   r0, [r3, #0x08]       // SSIENR: off while it is configured
    movs  r0, #4
    str   r0, [r3, #0x14]       // BAUDR: a quarter of the system clock
    ldr   r0, =0x001f0300
    str   r0, [r3, #0x00]       // CTRLR0: 32-bit frames, instruction and address before data
    movs  r0, #0
    str   r0, [r3, #0x04]       // CTRLR1: one frame per access
    ldr   r1, =0x180000f4
    ldr   r0, =0x03000218
    str   r0, [r1]              // SPI_CTRLR0: command 03h, 24 address bits, all on one line
    movs  r0, #1
    str   r0, [r3, #0x08]
    ldr   r0, =program_load
    ldr   r1, =program_begin
    ldr   r2, =program_end
1:  ldmia r0!, {r4}
    stmia r1!, {r4}
    cmp   r1, r2
    blo   1b
    ldr   r0, =program_begin
    ldr   r1, =0xe000ed08
    str   r0, [r1]              // VTOR
    ldmia r0!, {r1, r2}
    msr   msp, r1
    bx    r2
    .ltorg
