// Measures how much of an ATmega2560 the firmware uses, on the emulated chip.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "avr_rig.h"
#include "core/error.h"
#include "isr_monitor.h"
#include "loop_monitor.h"

namespace tp100::sim {
namespace {

constexpr double kSampleCycles = AvrCore::kHz / 200.0;
constexpr double kCountsPerMetre = 11140.0;
constexpr std::uint16_t kRamBegin = 0x200;
constexpr std::uint16_t kRamEnd = 0x21FF;
constexpr std::uint8_t kPaint = 0xA5;

void row(const char* what, double value, const char* unit) {
  std::printf("{\"what\":\"%s\",\"value\":%.6g,\"unit\":\"%s\"}\n", what, value, unit);
  std::fflush(stdout);
}

std::uint32_t symbol(const AvrImage& image, const char* name) {
  const auto found = image.symbols.find(name);
  if (found == image.symbols.end()) throw SetupError(image.path + ": no symbol " + name);
  return found->second & 0xFFFFU;
}

/// Measures the processor load and the emulation speed in one mode of operation.
void share(AvrRig& rig, LoopMonitor& loop, const IsrMonitor& interrupts, const char* what, int ms) {
  using Clock = std::chrono::steady_clock;
  const AvrBoardCounters before = rig.board.counters();
  const std::uint64_t runs = interrupts.runs();
  loop.clear();
  const Clock::time_point begin = Clock::now();
  rig.run(ms);
  const std::chrono::duration<double> wall = Clock::now() - begin;
  const AvrBoardCounters after = rig.board.counters();
  const auto cycles = static_cast<double>(after.cycles - before.cycles);
  // simavr does not count the cycles of an interrupt's entry.
  const auto entries = static_cast<double>((interrupts.runs() - runs) * IsrMonitor::kEntryCycles);
  const double busy =
      1.0 - (static_cast<double>(after.slept_cycles - before.slept_cycles) - entries) / cycles;
  const std::string way = std::string(what) + ": ";
  row((way + "processor busy").c_str(), busy * 100.0, "%");
  row((way + "a sample").c_str(), busy * kSampleCycles, "cycles");
  row((way + "longest pass of the loop").c_str(), static_cast<double>(loop.longest()) / 16.0, "us");
  row((way + "emulated").c_str(), ms * 1e-3 / wall.count(), "times real time");
}

void force_edges(AvrRig& rig, double per_channel_hz) {
  rig.forced_mps = 2.0 * per_channel_hz / kCountsPerMetre;
}

bool keeps_count(double per_channel_hz) {
  AvrRig rig;
  if (!rig.boot()) return false;
  rig.connect();
  rig.streams = true;
  rig.run(20);
  force_edges(rig, per_channel_hz);
  rig.run(300);
  rig.forced_mps = 0.0;
  rig.run(200);
  return !rig.samples.empty() && rig.last().left_counts == rig.left.counts() &&
         rig.last().right_counts == rig.right.counts() && rig.board.counters().rx_overruns == 0;
}

double highest_edge_rate() {
  double good = 1000.0;
  double bad = 100'000.0;
  while (bad - good > 250.0) {
    const double middle = 0.5 * (good + bad);
    (keeps_count(middle) ? good : bad) = middle;
  }
  return good;
}

void bench() {
  AvrRig rig;
  const AvrImage& image = rig.board.image();
  AvrCore& core = rig.board.core();
  const std::uint32_t ram_used = symbol(image, "_end");
  LoopMonitor loop(core);
  IsrMonitor left_encoder(core, 5);
  IsrMonitor right_encoder(core, 4);
  const IsrMonitor interrupts(core, IsrMonitor::kAny);
  IsrMonitor tick(core, 32);
  IsrMonitor receive(core, 25);
  IsrMonitor send(core, 26);

  rig.imu.power_on();
  rig.board.reset(PowerUp::kPowerOn, 0);
  std::fill(core.data() + ram_used, core.data() + kRamEnd + 1, kPaint);
  rig.run(50);

  row("flash", static_cast<double>(image.flash.size()), "bytes of 253952");
  row("RAM, static", ram_used - kRamBegin, "bytes of 8192");

  share(rig, loop, interrupts, "no host: hello", 500);
  rig.connect();
  rig.streams = true;
  rig.run(50);
  share(rig, loop, interrupts, "disarmed, 100 Hz commands, 200 Hz samples", 500);
  rig.arm();
  rig.speed_mps = 0.15f;
  rig.run(300);
  share(rig, loop, interrupts, "running at 0.15 m/s", 500);
  rig.speed_mps = 0.18f;
  rig.forced_mps = 0.2;
  share(rig, loop, interrupts, "running, edges of top speed (1.1 kHz a channel)", 1000);
  left_encoder.clear();
  right_encoder.clear();
  force_edges(rig, 10'000.0);
  share(rig, loop, interrupts, "4 x 10 kHz edges, motors off", 500);
  rig.speed_mps = 0.0f;
  rig.forced_mps = 0.0;
  rig.run(20);

  std::uint32_t deepest = ram_used;
  while (deepest <= kRamEnd && core.data()[deepest] == kPaint) ++deepest;
  row("stack, deepest", kRamEnd + 1.0 - deepest, "bytes");
  row("RAM never touched", deepest - ram_used, "bytes");
  row("encoder interrupt, longest",
      static_cast<double>(std::max(left_encoder.longest(), right_encoder.longest())), "cycles");
  row("1 kHz interrupt, longest", static_cast<double>(tick.longest()), "cycles");
  row("1 kHz interrupt, mean", tick.mean(), "cycles");
  row("receive interrupt, mean", receive.mean(), "cycles");
  row("send interrupt, mean", send.mean(), "cycles");
  row("IMU burst of 14 registers", static_cast<double>(rig.board.longest_i2c_transfer()), "cycles");
  row("IMU burst of 14 registers", static_cast<double>(rig.board.longest_i2c_transfer()) / 16.0,
      "us");
  row("receive overruns", static_cast<double>(rig.board.counters().rx_overruns), "bytes");
  row("highest edge rate without a lost edge", highest_edge_rate() * 1e-3,
      "kHz on each of four channels");
}

}  // namespace
}  // namespace tp100::sim

int main() {
  try {
    tp100::sim::bench();
    return 0;
  } catch (const tp100::SetupError& error) {
    std::fprintf(stderr, "firmware_bench: %s\n", error.what());
    return 2;
  }
}
