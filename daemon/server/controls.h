#pragma once
// What the clients of all doors may ask of the robot and its run. Every call but stop() comes from
// the server's thread (server.h), or from another door's, and must not block: neither on a disk nor
// on a lock that is held by a thread waiting for one.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/command.h"
#include "core/consent.h"
#include "core/pose.h"
#include "core/result.h"
#include "core/start_rule.h"
#include "core/time.h"
#include "course/goal.h"
#include "messages/figures.h"
#include "messages/messages.h"
#include "messages/parameter_text.h"
#include "server/lease.h"
#include "server/service.h"

namespace tp100::server {

/// An operator's choice; what is not named stays as it is.
struct SetupChoice {
  std::optional<std::string> course{};  ///< a name of the list; empty: none
  std::optional<std::string> robot{};   ///< a name of the list
  std::optional<std::string> setup{};   ///< stand, flat or terrain
  std::optional<course::Goal> goal{};   ///< in place of a name: the course that leads to it
};

class Controls {
 public:
  virtual ~Controls() = default;

  /// Sets the robot in motion: kStart, kStartPlaced, kContinue or kResume. The consent is judged
  /// now and again by the loop.
  virtual Result<> move(OperatorRequest request, const Consent& consent, HostNs now) = 0;
  virtual Result<> hold() = 0;
  /// Pauses a run on the course; a paused one stays paused.
  virtual Result<> pause() = 0;
  /// STOPs so far, of every door, as consents refer to them. Any thread.
  virtual std::uint64_t stop_count() = 0;
  /// Cannot be refused. Any thread; takes no lock.
  virtual void stop() = 0;
  /// `value` has the right type and lies within the limits.
  virtual Result<> set(const messages::ParameterText& parameter,
                       const messages::ParameterValue& value) = 0;

  // Driving by hand.
  /// Gives `driver`, a name that no other client has, the lease, and arms the robot. Returns the
  /// token.
  virtual Result<std::string> drive_take(const std::string& driver, const Consent& consent,
                                         HostNs now) = 0;
  virtual Result<> drive(const DriveRequest& request, HostNs now) = 0;
  /// Stops and disarms the robot.
  virtual Result<> drive_release(const std::string& token, HostNs now) = 0;
  /// The client of that name is gone: the robot stops if it drove.
  virtual void drive_lost(const std::string& driver, HostNs now) = 0;
  virtual messages::DriverFigures driver(HostNs now) = 0;

  virtual void choose(const SetupChoice& choice, Answer answer) = 0;
  /// Places the robot at `at`, or without it at the course's start.
  virtual void place(const std::optional<Pose>& at, Answer answer) = 0;

  /// Host time at which a check of the tracks, which has the port, last switched the motors off,
  /// acknowledged by the robot; 0: never.
  virtual HostNs motors_off_ns() = 0;

  // Figures known outside the server; cheap enough to be polled.
  virtual messages::LoopFigures loop() = 0;
  virtual messages::PortFigures port() = 0;
  virtual messages::RecordingFigures recording() = 0;
  /// The consent that a start requires now.
  virtual StartConsent start_consent() = 0;
  /// Why a start is refused for where the robot stands, by what it says of that.
  virtual StartPlaces start_places() = 0;
};

/// The services of motion: runs, driving by hand, and where the robot is; all but STOP. `controls`
/// must outlive the rows. `tell` receives who did what.
std::vector<ServiceRow> motion_services(Controls& controls,
                                        const std::function<void(const messages::Event&)>& tell);

}  // namespace tp100::server
