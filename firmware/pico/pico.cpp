// The firmware on a Pico: vectors, start and main loop. boot2.S has copied the program into the
// RAM.
#include "firmware.h"
#include "hal_pico.h"
#include "rp2040.h"
#include "scaling.h"

namespace {

using namespace tp100::firmware;

PicoHal hal;
Firmware robot(hal);

// Processor fault or unexpected interrupt: waits, motors off, until the watchdog restarts the
// board.
void on_defect() {
  PicoHal::outputs_off();
  for (;;) {
  }
}

void on_gpio() { hal.on_edge(); }
void on_uart() { hal.on_uart(); }
void on_systick() {
  robot.tick_1khz();
  hal.raise_work();
}

}  // namespace

extern "C" {

typedef void (*Handler)();
extern Handler init_begin[];
extern Handler init_end[];
extern uint32_t bss_begin[];
extern uint32_t bss_end[];
extern uint32_t stack_top[];

__attribute__((used, noreturn)) void start() {
  for (uint32_t* word = bss_begin; word != bss_end; ++word) *word = 0;
  for (Handler* init = init_begin; init != init_end; ++init) (*init)();
  hal.begin();
  robot.setup();
  rp2040::systick_reload() = pico::kSysHz / 1000 - 1;
  rp2040::systick_count() = 0;
  rp2040::systick_control() = 7;
  for (;;) robot.loop();
}

// The compiler puts this into the table of a class with pure virtual functions.
void __cxa_pure_virtual() { on_defect(); }

/// Initial stack pointer, 15 vectors of the core, 26 of the chip (2.3.2).
__attribute__((used, section(".vectors"))) const Handler vectors[16 + 26] = {
    reinterpret_cast<Handler>(stack_top),
    start,
    on_defect,  // NMI
    on_defect,  // HardFault
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,  // SVCall
    on_defect,
    on_defect,
    on_defect,  // PendSV
    on_systick,
    on_defect,  // chip's interrupt 0
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_gpio,  // 13
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_uart,  // 20
    on_defect,
    on_defect,
    on_defect,
    on_defect,
    on_defect,
};

}  // extern "C"
