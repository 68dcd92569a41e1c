#pragma once
// Lines that somebody types on standard input, without waiting for them.

#include <optional>
#include <string>

namespace tp100::doctor {

class Answers {
 public:
  /// The next line, if it is there; reads what there is. Never waits.
  std::optional<std::string> take();
  /// Forgets what was typed on a terminal before it was asked for; a pipe keeps its lines.
  void drop_typed_ahead();
  /// Nobody will answer any more.
  bool ended() const { return ended_ && pending_.empty(); }

 private:
  std::string pending_;
  bool ended_ = false;
};

}  // namespace tp100::doctor
