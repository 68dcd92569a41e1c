#pragma once
// What the benches of a whole daemon share: the daemon with its page, and rows of JSON.

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "../programs/process.h"
#include "core/statistics.h"

namespace tp100::bench {

using Clock = std::chrono::steady_clock;

inline double ms_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Prints a row with the spread of `values`.
inline void print(const std::string& what, const std::vector<double>& values) {
  std::printf("{\"what\":\"%s\",\"count\":%zu,\"p50\":%.2f,\"p99\":%.2f,\"max\":%.2f}\n",
              what.c_str(), values.size(), percentile(values, 0.5), percentile(values, 0.99),
              percentile(values, 1.0));
  std::fflush(stdout);
}

/// tp100d that serves its page.
class Daemon {
 public:
  /// `arguments` follow those that every bench needs. `keyboard`: standard input, -1: none.
  Daemon(const std::string& link, const test::Words& arguments, int keyboard = -1)
      : process_(test::joined({"tp100d", "run", "--port", link, "--wait", "--stay", "--listen",
                               "127.0.0.1:0"},
                              arguments),
                 keyboard),
        port_(test::page_port(process_)) {}

  const std::string& port() const { return port_; }
  test::Process& process() { return process_; }

 private:
  test::Process process_;
  std::string port_;
};

}  // namespace tp100::bench
