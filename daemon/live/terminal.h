#pragma once
// The operator at the terminal, who is asked for a start, starts, or stops (core/start_rule.h).
// Asio stays in the source file.

#include <cstdint>
#include <memory>
#include <string>

#include "core/link_state.h"
#include "core/run_state.h"
#include "live/event_log.h"
#include "live/live_controls.h"
#include "server/server.h"

namespace boost::asio {
class io_context;
}

namespace tp100::live {

/// Used by the supervisor's thread only.
class Terminal {
 public:
  /// All but `course`, whose name is empty if there is none, must outlive the terminal.
  struct Reach {
    LiveControls& controls;
    server::Server& server;
    EventLog& log;
    std::string course;
  };
  Terminal(boost::asio::io_context& context, Reach reach);
  ~Terminal();

  void follow(SessionState session) { session_ = session; }
  void follow(RunState run) { run_ = run; }
  /// Another course is in force; empty: none.
  void follow(const std::string& course) { reach_.course = course; }
  /// Asks for a start, if one is possible; only input typed from now on counts.
  void ask();
  /// Stops reading input.
  void stop();

 private:
  class Input;
  void take(const std::string& line);
  void start(bool first_only);
  void press_stop(const std::string& message);
  bool under_way() const { return tp100::under_way(run_); }

  Reach reach_;
  SessionState session_ = SessionState::kClosed;
  RunState run_ = RunState::kIdle;
  std::uint64_t stops_seen_ = 0;  // as of the last question, or pressed here
  std::unique_ptr<Input> input_;
};

}  // namespace tp100::live
