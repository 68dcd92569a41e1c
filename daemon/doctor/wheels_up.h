#pragma once
// The guided test of `tp100d doctor --wheels-up`: drives each track on its own, forward and back,
// with the speed loops off, so that a track that is wired backwards cannot run away.

#include <atomic>
#include <string>

#include "course/robot.h"
#include "doctor/finding.h"
#include "link/session.h"
#include "link/transport.h"

namespace tp100::doctor {

struct WheelsUpOptions {
  std::string port;
  link::PortOptions serial{};
  link::SessionSettings session{};
  course::DriveValues drive{};
};

/// Asks on standard error and reads standard input. Nothing moves before Enter; the motors are off
/// when it returns. Names besides those of doctor/tracks.h: wheels-up. Throws SetupError if the
/// port cannot be opened.
doctor::Findings try_wheels_up(const WheelsUpOptions& options, const std::atomic<bool>& stop);

}  // namespace tp100::doctor
