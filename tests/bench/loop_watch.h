#pragma once
// How long a turn of the firmware's main loop takes, told by its watchdog kicks.

#include <algorithm>
#include <cstdint>

#include "sim/board/avr_core.h"

struct avr_io_t;

namespace tp100::sim {

/// One at a time.
class LoopWatch {
 public:
  explicit LoopWatch(AvrCore& core);
  ~LoopWatch();
  LoopWatch(const LoopWatch&) = delete;
  LoopWatch& operator=(const LoopWatch&) = delete;

  /// Cycles of the longest turn, sleep left out.
  Cycle longest() const { return longest_; }
  std::uint64_t turns() const { return turns_; }
  void clear() { began_ = longest_ = turns_ = 0; }

 private:
  static int on_ioctl(avr_io_t* io, std::uint32_t control, void* parameter);
  void turn();

  AvrCore& core_;
  avr_io_t* watchdog_ = nullptr;
  int (*next_)(avr_io_t*, std::uint32_t, void*) = nullptr;
  Cycle began_ = 0;
  Cycle longest_ = 0;
  std::uint64_t turns_ = 0;
};

}  // namespace tp100::sim
