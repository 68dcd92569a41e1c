#pragma once
// The firmware image on an emulated Mega.

#include "avr_trace.h"
#include "board_rig.h"
#include "sim/board/avr_board.h"

namespace tp100::sim {

class AvrRig final : public BoardRig {
 public:
  explicit AvrRig(const AvrBoardSettings& settings = {})
      : BoardRig(settings.seed), board(settings, &imu), trace(board) {}
  Board& hardware() override { return board; }
  void on_byte(bool to_board, const TimedByte& byte) override {
    trace.byte(to_board, byte.at_ns, byte.value);
  }

  AvrBoard board;
  AvrTrace trace;
};

}  // namespace tp100::sim
