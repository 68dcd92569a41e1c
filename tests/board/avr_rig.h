#pragma once
// The firmware image on an emulated Mega.

#include "board_rig.h"
#include "sim/board/avr_board.h"

namespace tp100::sim {

class AvrRig final : public BoardRig {
 public:
  explicit AvrRig(const AvrBoardSettings& settings = {})
      : BoardRig(settings.seed), board(settings, &imu) {}
  Board& hardware() override { return board; }

  AvrBoard board;
};

}  // namespace tp100::sim
