#pragma once
// The operator at the terminal, who is asked for a start, starts, stops (core/start_rule.h), or
// ends the program. Asio stays in the source file.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/link_state.h"
#include "core/run_state.h"
#include "core/start_rule.h"
#include "core/time.h"
#include "server/controls.h"

namespace boost::asio {
class io_context;
}

namespace tp100::live {

/// Used by the main thread only.
class Terminal {
 public:
  struct Reach {
    server::Controls& controls;  ///< must outlive the terminal
    /// A line for the person at the terminal.
    std::function<void(const std::string& line, bool warning)> say;
    /// STOP was pressed here; it is carried out already.
    std::function<void()> stop_pressed;
    std::function<std::string()> course;  ///< in force; returns an empty text: none
  };
  /// Receives signals and reads standard input in the context's thread; not without a context.
  /// `end` is called for the first signal that ends the program; later ones are ignored.
  Terminal(boost::asio::io_context* context, Reach reach,
           std::function<void(const char* signal)> end = {});
  ~Terminal();

  void follow(SessionState session) { session_ = session; }
  void follow(RunState run) { run_ = run; }
  /// Asks for a start, if one is possible; only input typed from now on counts, and whoever types
  /// it has seen the STOPs until now.
  void ask(HostNs now);
  /// Somebody typed this line, without surrounding white space.
  void take(const std::string& line, HostNs now);
  void stop();

 private:
  class Input;
  void start(LineMeaning meaning, bool first_only, HostNs now);
  void press_stop(const std::string& message, HostNs now);
  bool under_way() const { return tp100::under_way(run_); }

  Reach reach_;
  SessionState session_ = SessionState::kClosed;
  RunState run_ = RunState::kIdle;
  std::uint64_t stops_seen_ = 0;  // as of the last question, or pressed here
  HostNs seen_ns_ = 0;            // time of the last question, or of that press
  std::unique_ptr<Input> input_;
};

}  // namespace tp100::live
