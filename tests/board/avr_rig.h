#pragma once
// The rig with either board.

#include "board_rig.h"
#include "sim/board/avr_board.h"
#include "sim/board/native_board.h"

namespace tp100::sim {

/// The firmware image on an emulated Mega.
class AvrRig final : public BoardRig {
 public:
  explicit AvrRig(const AvrBoardSettings& settings = {})
      : BoardRig(settings.seed), board(settings, &imu) {}
  Board& hardware() override { return board; }

  AvrBoard board;
};

/// The firmware built for this machine.
class NativeRig final : public BoardRig {
 public:
  explicit NativeRig(const NativeBoardSettings& settings = {})
      : BoardRig(settings.seed), board(settings, &imu) {}
  Board& hardware() override { return board; }

  NativeBoard board;
};

}  // namespace tp100::sim
