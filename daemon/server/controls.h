#pragma once
// Requests that a viewer may make of the daemon. The server has checked arguments and state; an
// implementation passes them on. Every call but stop() comes from the worker's thread (server.h)
// and must not block: neither on a disk nor on a lock that is held by a thread waiting for one.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/command.h"
#include "core/consent.h"
#include "core/pose.h"
#include "core/start_rule.h"
#include "core/time.h"
#include "course/goal.h"
#include "messages/figures.h"
#include "messages/parameter_text.h"
#include "runs/run_note.h"
#include "server/wheel.h"

namespace tp100::server {

/// An operator's choice; what is not named stays as it is.
struct SetupChoice {
  std::optional<std::string> course{};  ///< a name of the list; empty: none
  std::optional<std::string> robot{};   ///< a name of the list
  std::optional<std::string> setup{};   ///< stand, flat or terrain
  std::optional<course::Goal> goal{};   ///< in place of a name: the course that leads to it
};

/// One of the user's own files.
struct SetupFile {
  bool is_robot = false;  ///< else a course
  std::string name;
  std::string text{};
  bool replace = false;  ///< an existing one
};

/// Parameters for the configuration file, with checked names, types and limits.
struct ParameterSave {
  std::vector<std::pair<std::string, messages::ParameterValue>> values{};
  bool check = false;  ///< only reports what would change; writes nothing
};

/// The part that is examined at a time, in the order of `tp100d doctor`.
enum class DoctorPart { kPort, kRobot, kMachine };

/// A viewer's sign of life in the check of the tracks.
struct WheelsUpWatch {
  std::string token;
  double input_ms = 0.0;  ///< as in DriveRequest
  unsigned question = 0;  ///< number of the one that is answered
  std::optional<std::string> answer{};
};

/// What is done with a recorded run.
struct RunRequest {
  enum class What { kNote, kDelete, kReport, kCompare, kIdentify };
  What what = What::kNote;
  std::string run{};
  std::string with{};                 ///< of kCompare: another run
  runs::RunNoteChange note{};         ///< of kNote
  std::vector<std::string> drives{};  ///< of kIdentify, in place of `run`
  std::string measured{};             ///< of kIdentify, as in RunArchive::identify()
};

/// Refusal of requests that need a robot at rest.
inline constexpr const char* kUnderWay =
    "a run is under way, or somebody drives by hand; stop it first";

class Controls {
 public:
  virtual ~Controls() = default;

  // Each returns why it is impossible, in one line; empty: accepted.
  /// Sets the robot in motion: kStart, kGoOn or kResume. The consent is judged now and again by the
  /// loop.
  virtual std::string move(OperatorRequest request, const Consent& consent, HostNs now) = 0;
  virtual std::string hold() = 0;
  /// Pauses a run on the course; a paused one stays paused.
  virtual std::string pause() = 0;
  /// STOPs so far, of every door, as consents refer to them. Any thread.
  virtual std::uint64_t stop_count() = 0;
  /// Cannot be refused. Any thread; takes no lock.
  virtual void stop() = 0;
  /// `value` has the right type and lies within the limits.
  virtual std::string set(const messages::ParameterText& parameter,
                          const messages::ParameterValue& value) = 0;

  // Driving by hand. Each returns why it is impossible, in one line; empty: done.
  /// Gives `driver` the wheel, arms the robot and sets `token`.
  virtual std::string drive_take(const Driver& driver, const Consent& consent, HostNs now,
                                 std::string& token) = 0;
  virtual std::string drive(const DriveRequest& request, HostNs now) = 0;
  /// Stops and disarms the robot.
  virtual std::string drive_release(const std::string& token, HostNs now) = 0;
  /// The client of that Driver::id is gone: the robot stops if it drove.
  virtual void drive_lost(const std::string& id, HostNs now) = 0;
  virtual messages::DriverFigures driver(HostNs now) = 0;

  /// Receives why the request failed, in one line, or nothing; and the recording that has begun or
  /// ended. Called once, from any thread, when the disk has finished.
  using RecordAnswer =
      std::function<void(const std::string& why, const messages::RecordingFigures& recorded)>;
  virtual void record_start(const std::string& name, RecordAnswer answer) = 0;
  virtual void record_stop(RecordAnswer answer) = 0;

  /// Receives why the request failed, in one line, or nothing; and its answer as JSON. Called once,
  /// from any thread.
  using Answer = std::function<void(const std::string& why, const std::string& json)>;
  virtual void choose(const SetupChoice& choice, Answer answer) = 0;
  /// Places the robot at `at`, or without it at the course's start.
  virtual void place(const std::optional<Pose>& at, Answer answer) = 0;
  virtual void save_file(const SetupFile& file, Answer answer) = 0;
  virtual void delete_file(const SetupFile& file, Answer answer) = 0;
  /// Answers with what is wrong with the text; writes nothing.
  virtual void check_file(const SetupFile& file, Answer answer) = 0;
  virtual void save_parameters(const ParameterSave& asked, Answer answer) = 0;
  /// Exchanges the configuration file with the one that the last save has kept.
  virtual void restore_parameters(bool check, Answer answer) = 0;
  virtual void manage_run(const RunRequest& request, Answer answer) = 0;
  /// Answers with what `tp100d doctor` finds; nothing moves.
  virtual void examine(DoctorPart part, Answer answer) = 0;

  /// Starts the check of the tracks for `viewer`, which must keep polling; sets `token`. Returns
  /// why it is impossible, in one line.
  virtual std::string wheels_up_begin(const Driver& viewer, const Consent& consent, HostNs now,
                                      std::string& token) = 0;
  /// Answers at once with the state of the check. Returns why it is impossible, in one line.
  virtual std::string wheels_up_watch(const WheelsUpWatch& watch, HostNs now,
                                      std::string& json) = 0;

  /// Host time at which a check of the tracks, which has the port, last switched the motors off,
  /// acknowledged by the robot; 0: never.
  virtual HostNs motors_off_ns() = 0;

  // Figures known outside the server; cheap enough to be polled.
  virtual messages::LoopFigures loop() = 0;
  virtual messages::PortFigures port() = 0;
  virtual messages::RecordingFigures recording() = 0;
  /// The consent that a start requires now.
  virtual StartConsent start_consent() = 0;
};

}  // namespace tp100::server
