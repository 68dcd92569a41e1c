#pragma once
// The signals that end `tp100d run`. Asio stays in the source file.

#include <functional>
#include <memory>

namespace boost::asio {
class io_context;
}

namespace tp100::live {

class EndSignals {
 public:
  /// From now on SIGINT, SIGTERM and, unless it is ignored, SIGHUP call `action` once with the
  /// signal's name, in the context's thread; SIGPIPE and SIGXFSZ are ignored.
  EndSignals(boost::asio::io_context& context, std::function<void(const char* name)> action);
  ~EndSignals();

  /// Waits for no further signal.
  void cancel();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::live
