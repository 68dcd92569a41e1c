#pragma once
// Records the last seconds of a chip's pins and of its wire, for the analysis of a failed test: a
// VCD file (IEEE 1364, as GTKWave and sigrok read it) and a list of frames.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

#include "sim/board/avr_board.h"

struct avr_irq_t;

namespace tp100::sim {

/// Follows a board from its construction and keeps the last kKept changes, without an effect on the
/// chip. If the running test has failed, the destructor writes TEST.vcd and TEST.frames to the
/// folder tested/failed of the build and prints their names.
class AvrTrace {
 public:
  static constexpr std::size_t kKept = 200'000;

  explicit AvrTrace(AvrBoard& board);
  ~AvrTrace();
  AvrTrace(const AvrTrace&) = delete;
  AvrTrace& operator=(const AvrTrace&) = delete;

  /// A byte on the wire, from or to the board.
  void byte(bool to_board, std::int64_t at_ns, std::uint8_t value);
  /// Writes `folder`/`name`.vcd and .frames, and creates the folder. Throws std::runtime_error.
  void write(const std::string& folder, const std::string& name) const;

 private:
  struct Change {
    std::int64_t at_ns;
    std::uint8_t signal;
    std::uint8_t value;
  };
  struct Pin {
    AvrTrace* trace;
    std::uint8_t signal;
  };
  static void on_pin(avr_irq_t* irq, std::uint32_t value, void* pin);
  void keep(Change change);

  AvrBoard& board_;
  Pin pins_[10];
  std::deque<Change> changes_;
};

}  // namespace tp100::sim
