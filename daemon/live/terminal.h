#pragma once
// Whoever sits at the terminal: is asked for a start, gives it, or stops. By core/start_rule.h.

#include <string>

#include "live/event_log.h"
#include "live/live_controls.h"
#include "live/live_cycle.h"
#include "live/operator_input.h"
#include "server/server.h"

namespace tp100::live {

/// One thread, the supervisor's.
class Terminal {
 public:
  /// All but `course`, whose empty name is none, must outlive the terminal.
  struct Reach {
    LiveCycle& cycle;
    LiveControls& controls;
    server::Server& server;
    EventLog& log;
    std::string course;
  };
  Terminal(boost::asio::io_context& context, Reach reach);

  void follow(SessionState session) { session_ = session; }
  void follow(RunState run) { run_ = run; }
  /// Asks for a start, if one is possible; only what is typed from now on is an answer.
  void ask();
  /// Nothing is read any more.
  void stop() { input_.stop(); }

 private:
  void take(const std::string& line);
  void press_stop(const std::string& told);
  bool under_way() const { return run_ == RunState::kArming || run_ == RunState::kRunning; }

  Reach reach_;
  SessionState session_ = SessionState::kClosed;
  RunState run_ = RunState::kIdle;
  OperatorInput input_;
};

}  // namespace tp100::live
