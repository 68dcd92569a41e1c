#pragma once
// What happened, from any thread to the one that logs and publishes it.

#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "messages/messages.h"

namespace tp100::messages {

class EventQueue {
 public:
  struct Entry {
    Event event;
    bool log_only = false;  ///< it may name a path of this machine, which viewers do not get
  };

  // Any thread; while very many wait, further ones are dropped.
  void post(Event event) { push({std::move(event)}); }
  /// A line for the log only.
  void note(std::string line, Event::Level level = Event::Level::kWarning) {
    push({{.level = level, .text = std::move(line)}, true});
  }

  /// Those since the last call, oldest first.
  std::vector<Entry> drain() {
    const std::lock_guard lock(mutex_);
    return std::exchange(entries_, {});
  }

 private:
  static constexpr std::size_t kMost = 256;
  void push(Entry entry) {
    const std::lock_guard lock(mutex_);
    if (entries_.size() < kMost) entries_.push_back(std::move(entry));
  }

  std::mutex mutex_;
  std::vector<Entry> entries_;
};

}  // namespace tp100::messages
