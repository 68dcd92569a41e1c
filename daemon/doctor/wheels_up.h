#pragma once
// The guided test of `tp100d doctor --wheels-up`: drives both tracks in opposite directions, then
// each one, with the speed loops off, so that one that is wired backwards cannot run away.

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "core/time.h"
#include "course/robot.h"
#include "doctor/finding.h"
#include "link/session.h"
#include "link/transport.h"

namespace tp100::doctor {

/// One possible answer to a question.
struct Choice {
  std::string answer;   ///< what is typed; empty: just Enter
  std::string meaning;  ///< "the left track, back first"
};

struct Question {
  std::string text;
  std::vector<Choice> choices;  ///< the first is the usual one
};

/// The person beside the robot. Called by the thread of the test only; nothing here waits.
class Operator {
 public:
  virtual ~Operator() = default;
  /// What happens now, one line.
  virtual void say(const std::string& line) = 0;
  /// Asks; earlier answers are ignored.
  virtual void ask(const Question& question) = 0;
  /// The answer to the last question, once; nothing if there is none yet.
  virtual std::optional<std::string> take_answer() = 0;
  /// There will be no more answers.
  virtual bool ended() const = 0;
  /// Whether a person watches. No track runs otherwise.
  virtual bool watches() const = 0;
  /// Called at the end: by host time `at`, the robot had acknowledged that its motors are off.
  virtual void motors_off(HostNs at) = 0;
};

struct WheelsUpOptions {
  std::string port;
  link::PortOptions serial{};
  link::SessionSettings session{};
  course::DriveValues drive{};
};

/// The result of a test that was not completed.
Findings wheels_up_broken_off(std::string seen, std::string fix);

/// The tracks run at once: the caller must have asked whether they are free. A motion during which
/// nobody watched is repeated when somebody watches again; after 2 s without, the test ends. The
/// motors are off when it returns, also after `stop`. Names besides those of doctor/tracks.h:
/// wheels-up. Throws UserError if the port cannot be opened.
Findings try_wheels_up(const WheelsUpOptions& options, Operator& person,
                       const std::atomic<bool>& stop);

}  // namespace tp100::doctor
