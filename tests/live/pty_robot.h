#pragma once
// A scripted robot on a pty with its own thread, reached through a symbolic link.

#include <filesystem>
#include <mutex>
#include <thread>

#include "../link/pty_pair.h"
#include "../link/scripted_robot.h"
#include "core/clock.h"

namespace tp100 {

class PtyRobot {
 public:
  /// The robot creates `link` when it is plugged in.
  explicit PtyRobot(std::filesystem::path link)
      : link_(std::move(link)), robot_(monotonic_now()), thread_([this] { live(); }) {}
  ~PtyRobot() {
    stop_ = true;
    thread_.join();
  }

  void plug_in() {
    const std::lock_guard lock(mutex_);
    pty_ = std::make_unique<PtyPair>();
    std::filesystem::remove(link_);
    std::filesystem::create_symlink(pty_->near(), link_);
    robot_.reboot(monotonic_now());
  }
  void unplug() {
    const std::lock_guard lock(mutex_);
    pty_.reset();
    std::filesystem::remove(link_);
  }
  /// Runs `action` on the robot between two of its cycles.
  template <class Action>
  auto with(Action action) {
    const std::lock_guard lock(mutex_);
    return action(robot_);
  }

 private:
  void live() {
    while (!stop_) {
      {
        const std::lock_guard lock(mutex_);
        const HostNs now = monotonic_now();
        if (pty_ != nullptr) {
          robot_.receive(pty_->read(), now);
          robot_.tick(now);
          pty_->write(robot_.take());
        }
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  std::filesystem::path link_;
  std::mutex mutex_;
  std::unique_ptr<PtyPair> pty_;
  ScriptedRobot robot_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace tp100
