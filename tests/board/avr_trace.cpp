#include "avr_trace.h"

#include <avr_ioport.h>
#include <gtest/gtest.h>
#include <sim_avr.h>
#include <sim_io.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <stdexcept>

#include "support/paths.h"
#include "wire/frame.h"

namespace tp100::sim {
namespace {

struct Signal {
  const char* name;
  int bits;
  char port;  // of a pin
  int bit;
};
// firmware/WIRING.md lists the pins.
constexpr std::array<Signal, 12> kSignals = {{{"encoder_left_a", 1, 'E', 4},
                                              {"encoder_left_b", 1, 'E', 5},
                                              {"encoder_right_a", 1, 'D', 3},
                                              {"encoder_right_b", 1, 'D', 2},
                                              {"motor_left_forward", 1, 'A', 0},
                                              {"motor_left_backward", 1, 'A', 1},
                                              {"motor_right_forward", 1, 'A', 2},
                                              {"motor_right_backward", 1, 'A', 3},
                                              {"motor_left_enable", 1, 'H', 3},
                                              {"motor_right_enable", 1, 'H', 4},
                                              {"wire_to_host", 8, 0, 0},
                                              {"wire_to_board", 8, 0, 0}}};
constexpr std::uint8_t kPins = 10, kToHost = 10, kToBoard = 11;

std::int64_t ns_of(CpuCycles cycle) { return static_cast<std::int64_t>(cycle) * 125 / 2; }

std::ofstream create(const std::string& path) {
  std::ofstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be written");
  return file;
}

}  // namespace

AvrTrace::AvrTrace(AvrBoard& board) : board_(board) {
  for (std::uint8_t i = 0; i < kPins; ++i) {
    pins_[i] = {this, i};
    const Signal& signal = kSignals[i];
    avr_irq_t* irq =
        avr_io_getirq(board.core().chip(),
                      static_cast<std::uint32_t>(AVR_IOCTL_IOPORT_GETIRQ(signal.port)), signal.bit);
    avr_irq_register_notify(irq, on_pin, &pins_[i]);
  }
}

AvrTrace::~AvrTrace() {
  if (!testing::Test::HasFailure()) return;
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test.test_suite_name()) + '.' + test.name();
  std::replace(name.begin(), name.end(), '/', '_');
  const std::string folder = build_path("tested/failed");
  try {
    write(folder, name);
    std::cerr << "the chip's pins: " << folder << '/' << name << ".vcd, the last frames: " << name
              << ".frames\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
}

void AvrTrace::on_pin(avr_irq_t*, std::uint32_t value, void* pin) {
  const Pin& of = *static_cast<Pin*>(pin);
  of.trace->keep({ns_of(of.trace->board_.core().cycle()), of.signal, value != 0});
}

void AvrTrace::byte(bool to_board, std::int64_t at_ns, std::uint8_t value) {
  keep({at_ns, to_board ? kToBoard : kToHost, value});
}

void AvrTrace::keep(Change change) {
  changes_.push_back(change);
  if (changes_.size() > kKept) changes_.pop_front();
}

void AvrTrace::write(const std::string& folder, const std::string& name) const {
  std::filesystem::create_directories(folder);
  std::deque<Change> changes = changes_;
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.at_ns < b.at_ns; });

  std::ofstream vcd = create(folder + '/' + name + ".vcd");
  vcd << "$timescale 1ns $end\n$scope module atmega2560 $end\n";
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    vcd << "$var wire " << kSignals[i].bits << ' ' << char('a' + i) << ' ' << kSignals[i].name
        << " $end\n";
  }
  vcd << "$upscope $end\n$enddefinitions $end\n";
  std::int64_t at_ns = -1;
  for (const Change& change : changes) {
    if (change.at_ns != at_ns) vcd << '#' << (at_ns = change.at_ns) << '\n';
    const char code = static_cast<char>('a' + change.signal);
    if (kSignals[change.signal].bits == 1) {
      vcd << int{change.value} << code << '\n';
      continue;
    }
    vcd << 'b';
    for (int bit = 7; bit >= 0; --bit) vcd << ((change.value >> bit) & 1);
    vcd << ' ' << code << '\n';
  }

  std::ofstream frames = create(folder + '/' + name + ".frames");
  std::array<wire::FrameDecoder, 2> decoders;
  for (const Change& change : changes) {
    if (change.signal < kToHost) continue;
    const bool to_board = change.signal == kToBoard;
    wire::FrameDecoder& decoder = decoders[to_board];
    const wire::DecodeResult received = decoder.push(change.value);
    if (received == wire::DecodeResult::kNothing) continue;
    frames << std::dec << std::fixed << std::setprecision(3) << 1e-6 * double(change.at_ns)
           << " ms " << (to_board ? "to board" : "to host ");
    if (received != wire::DecodeResult::kFrame) {
      frames << " corrupted\n";
      continue;
    }
    frames << " type " << int{decoder.type()} << ':' << std::hex << std::setfill('0');
    for (std::size_t i = 0; i < decoder.size(); ++i)
      frames << ' ' << std::setw(2) << int{decoder.payload()[i]};
    frames << '\n';
  }
  if (!vcd.flush() || !frames.flush()) throw std::runtime_error(folder + ": cannot be written");
}

}  // namespace tp100::sim
