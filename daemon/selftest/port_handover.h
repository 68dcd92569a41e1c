#pragma once
// The daemon's port, handed over to a check that opens it by itself: asked for, given once it is
// closed, and returned. Any thread.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>

namespace tp100::selftest {

class PortHandover {
 public:
  // The check:
  void ask();
  /// Waits until the port is given; nothing: it was not, and the request is withdrawn.
  std::optional<std::string> wait(std::chrono::milliseconds limit);
  /// The port is closed again.
  void end();

  // Whoever holds the port:
  /// The port of that path has just been closed. True: it was asked for, and must not be opened
  /// before the handover has ended.
  bool give(const std::string& path);
  bool given() const;

 private:
  enum class State { kNone, kAsked, kGiven };

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  State state_ = State::kNone;
  std::string path_;
};

}  // namespace tp100::selftest
