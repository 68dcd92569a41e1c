#pragma once
// Consent to motion: the one rule for everything that can make motors turn, whoever asks and by
// whatever door. Pure; no clock.

#include <atomic>
#include <cstdint>
#include <limits>
#include <string>

#include "core/time.h"

namespace tp100 {

/// The door by which somebody asks.
enum class Door : std::uint8_t {
  kOption,    ///< the command line, or an emulated robot that starts by itself
  kTerminal,  ///< a line typed at the terminal
  kViewer,    ///< the page or a program on the server; has a number
  kRos2,      ///< a ROS 2 node
};

struct Requester {
  Door door = Door::kTerminal;
  std::uint32_t number = 0;  ///< of a viewer
};

/// For people: "viewer 3".
inline std::string to_string(const Requester& by) {
  switch (by.door) {
    case Door::kOption:
      return "the program's option";
    case Door::kTerminal:
      return "the terminal";
    case Door::kViewer:
      return "viewer " + std::to_string(by.number);
    case Door::kRos2:
      return "ROS 2";
  }
  return "unknown";
}

/// One person's consent to one motion. It travels with the request, from the door to the loop.
struct Consent {
  /// Life of an act: after this time the person may no longer be watching the robot.
  static constexpr HostNs kLifeNs = 3 * kNsPerS;
  /// Life of --go for a physical robot, from the program's start on.
  static constexpr HostNs kOptionLifeNs = 10 * kNsPerS;

  Requester by{};
  HostNs acted_ns = 0;           ///< when the person acted, or earlier
  HostNs seen_ns = 0;            ///< when the robot was as the person saw it then
  std::uint64_t stops_seen = 0;  ///< STOPs that the person had seen then, by ConsentRule::stops()
  HostNs life_ns = kLifeNs;
  /// Given before anything ran, by an option or a first Enter: it does not count after a run began,
  /// the course was changed or the port was handed over.
  bool first_only = false;
};

/// The consent of the program's option: --go is consent to start the physical robot that is there
/// when the program starts, while whoever typed it still watches. An emulated robot needs none: it
/// starts whenever it is there. `came_later`: plugged in, or in again, after the program's start.
constexpr Consent option_consent(bool emulator, bool came_later, HostNs program_start_ns,
                                 HostNs now) {
  Consent consent{.by = {Door::kOption},
                  .acted_ns = now,
                  .seen_ns = now,
                  .life_ns = Consent::kOptionLifeNs,
                  .first_only = true};
  if (emulator) return consent;
  consent.acted_ns = program_start_ns;
  if (came_later) consent.life_ns = 0;
  return consent;
}

/// Why a consent does not count (any more).
enum class ConsentLoss : std::uint8_t {
  kNone,
  kStopped,  ///< there was a STOP that the person had not seen
  kTooOld,
  kChanged,  ///< the robot was held or paused, or another course or place chosen, meanwhile
};

/// What happened and what to do, in one line; empty for kNone.
constexpr const char* to_string(ConsentLoss loss) {
  switch (loss) {
    case ConsentLoss::kNone:
      return "";
    case ConsentLoss::kStopped:
      return "STOP was pressed meanwhile; look at the robot, then ask again";
    case ConsentLoss::kTooOld:
      return "the request is too old; look at the robot, then ask again";
    case ConsentLoss::kChanged:
      return "somebody held or paused the robot, or changed what would run; look, then ask again";
  }
  return "unknown";
}

/// Judges every consent. Any thread, the real-time one included.
class ConsentRule {
 public:
  /// Counts a STOP, of whatever door. Count it before it is requested: then no older consent
  /// crosses it.
  void press_stop() { stops_.fetch_add(1, std::memory_order_acq_rel); }
  /// STOPs since the program's start.
  std::uint64_t stops() const { return stops_.load(std::memory_order_acquire); }

  /// The robot was held or paused, or what a start would begin has changed: whoever looked before
  /// does not know it. The real-time thread.
  void set_changed(HostNs now) { changed_ns_.store(now, std::memory_order_release); }
  /// A run began, or only a person may start from now on.
  void set_ran() { ran_.store(true, std::memory_order_release); }
  bool ran() const { return ran_.load(std::memory_order_acquire); }

  /// Whether the consent counts at `now`. The loop asks when it carries a request out; a door may
  /// ask before, to answer at once.
  ConsentLoss judge(const Consent& consent, HostNs now) const {
    if (consent.stops_seen != stops()) return ConsentLoss::kStopped;
    if (consent.first_only && ran()) return ConsentLoss::kChanged;
    if (consent.seen_ns < changed_ns_.load(std::memory_order_acquire)) return ConsentLoss::kChanged;
    return now - consent.acted_ns > consent.life_ns ? ConsentLoss::kTooOld : ConsentLoss::kNone;
  }

 private:
  std::atomic<std::uint64_t> stops_{0};
  std::atomic<HostNs> changed_ns_{std::numeric_limits<HostNs>::min()};
  std::atomic<bool> ran_{false};
};

}  // namespace tp100
