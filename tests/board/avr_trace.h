#pragma once
// The last seconds of a chip's pins and of its wire, for whoever looks into a failed test: a VCD
// file (IEEE 1364, as GTKWave and sigrok read it) and a list of frames.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

#include "sim/board/avr_board.h"

struct avr_irq_t;

namespace tp100::sim {

/// Follows a board from construction on and keeps the last kKept changes. Changes nothing of the
/// chip. If the test that runs has failed, the destructor writes TEST.vcd and TEST.frames into the
/// build folder's tested/failed and names them.
class AvrTrace {
 public:
  static constexpr std::size_t kKept = 200'000;

  explicit AvrTrace(AvrBoard& board);
  ~AvrTrace();
  AvrTrace(const AvrTrace&) = delete;
  AvrTrace& operator=(const AvrTrace&) = delete;

  /// A byte on the wire, from or to the board.
  void byte(bool to_board, std::int64_t at_ns, std::uint8_t value);
  /// `folder`/`name`.vcd and .frames; the folder is made. Throws std::runtime_error.
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
