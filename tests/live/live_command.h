#pragma once
// `tp100d run` in this process, with a script beside it.

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <thread>

#include "app/commands.h"
#include "core/error.h"

namespace tp100::live {

/// True once `condition` holds; false if it does not within `limit`.
inline bool soon(const std::function<bool()>& condition,
                 std::chrono::seconds limit = std::chrono::seconds(20)) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (std::chrono::steady_clock::now() < end) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

inline std::string content_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// Port of the page, from the command's statistics file; empty if none is served soon.
inline std::string page_of(const std::string& stats) {
  static const std::string kBefore = "http://127.0.0.1:";
  std::string served;
  soon([&] {
    const std::string text = content_of(stats);
    const std::size_t at = text.find(kBefore), end = text.find('/', at + kBefore.size());
    if (end == std::string::npos || at == std::string::npos) return false;
    served = text.substr(at + kBefore.size(), end - at - kBefore.size());
    return true;
  });
  return served;
}

struct Ended {
  int status = -1;
  std::string log;
};

/// Runs the command while `script` runs in parallel; the end of the script ends the command.
inline Ended run_beside(const app::RunOptions& options, const std::function<void()>& script) {
  std::thread beside([&] {
    try {
      script();
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    ::kill(::getpid(), SIGTERM);
  });
  testing::internal::CaptureStderr();
  Ended ended;
  try {
    ended.status = app::run_run(options);
  } catch (const SetupError& error) {
    ADD_FAILURE() << error.what();
  }
  beside.join();
  ended.log = testing::internal::GetCapturedStderr();
  return ended;
}

}  // namespace tp100::live
