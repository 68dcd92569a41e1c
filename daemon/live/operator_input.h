#pragma once
// Lines typed on standard input. Asio stays in the source files.

#include <functional>
#include <memory>
#include <string>

namespace boost::asio {
class io_context;
}

namespace tp100::live {

class OperatorInput {
 public:
  /// Calls `line` in the context's thread for each line on standard input, without white space
  /// around it. Lines that came together, as somebody typed on without looking, are one call with
  /// all of them. Does nothing if standard input is no terminal of ours and no pipe (a file,
  /// /dev/null, a background job).
  OperatorInput(boost::asio::io_context& context,
                std::function<void(const std::string& line)> line);
  ~OperatorInput();
  /// Forgets what was typed before now, the beginning of a line too. True if a whole line was among
  /// it.
  bool drop_typed_ahead();
  /// Stops reading.
  void stop();
  bool listening() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace tp100::live
