#include "selftest/port_handover.h"

namespace tp100::selftest {

void PortHandover::ask() {
  const std::lock_guard lock(mutex_);
  state_ = State::kAsked;
}

std::optional<std::string> PortHandover::wait(std::chrono::milliseconds limit) {
  std::unique_lock lock(mutex_);
  if (changed_.wait_for(lock, limit, [this] { return state_ == State::kGiven; })) return path_;
  state_ = State::kNone;
  return std::nullopt;
}

void PortHandover::end() {
  const std::lock_guard lock(mutex_);
  state_ = State::kNone;
}

bool PortHandover::give(const std::string& path) {
  const std::lock_guard lock(mutex_);
  if (state_ != State::kAsked) return false;
  state_ = State::kGiven;
  path_ = path;
  changed_.notify_all();
  return true;
}

bool PortHandover::given() const {
  const std::lock_guard lock(mutex_);
  return state_ == State::kGiven;
}

}  // namespace tp100::selftest
