#pragma once
// Kills a piece of code before each of its system calls in turn: every moment at which a kill, or
// the end of the power of a disk that keeps its order, can be told from another one.

#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>

namespace tp100::test {

/// Runs `action` in a child of one thread that is killed (SIGKILL) before its system call number
/// `number`, from 1 on. True: it was; false: the action ended before.
inline bool killed_before_call(int number, const std::function<void()>& action) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
    ::raise(SIGSTOP);
    action();
    std::_Exit(0);
  }
  int status = 0;
  const auto wait = [&] { return ::waitpid(child, &status, 0) == child && WIFSTOPPED(status); };
  bool stopped = wait();
  EXPECT_TRUE(stopped) << "no child can be traced here";
  // Each call stops twice, at its begin and at its end.
  for (int stop = 1; stopped && stop < 2 * number; ++stop) {
    ::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
    stopped = wait();
  }
  if (!stopped) {
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "status " << status;
    return false;
  }
  ::kill(child, SIGKILL);
  while (::waitpid(child, &status, 0) == child && WIFSTOPPED(status)) {
  }
  return true;
}

/// For each moment: `prepare`, the killed `action`, `check`. Returns how many there were; the last
/// check is after an action that ended by itself.
inline int at_each_kill(const std::function<void()>& prepare, const std::function<void()>& action,
                        const std::function<void()>& check) {
  for (int number = 1;; ++number) {
    const ::testing::ScopedTrace where(__FILE__, __LINE__,
                                       "killed before system call " + std::to_string(number));
    prepare();
    const bool killed = killed_before_call(number, action);
    check();
    if (!killed || ::testing::Test::HasFailure()) return number - 1;
  }
}

}  // namespace tp100::test
