#pragma once
// The Enter key on standard input. Asio stays in the source files.

#include <functional>
#include <memory>

namespace boost::asio {
class io_context;
}

namespace tp100::app {

class OperatorInput {
 public:
  /// Calls `enter` in the context's thread for each line on standard input. Does nothing if
  /// standard input is no terminal of ours and no pipe (a file, /dev/null, a background job).
  OperatorInput(boost::asio::io_context& context, std::function<void()> enter);
  ~OperatorInput();
  /// Stops reading.
  void stop();
  bool listening() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace tp100::app
