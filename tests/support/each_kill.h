#pragma once
// Kills a piece of code before each of its system calls in turn, or lets each of them fail: every
// moment at which a kill can be told from another one, and every error of a disk.

#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>

namespace tp100::test {

/// A child of one thread that runs `action` and is stopped before and after its system calls.
class TracedChild {
 public:
  explicit TracedChild(const std::function<void()>& action) : pid_(::fork()) {
    if (pid_ == 0) {
      ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
      ::raise(SIGSTOP);
      action();
      std::_Exit(0);
    }
    EXPECT_TRUE(wait()) << "no child can be traced here";
  }
  /// Ends it.
  ~TracedChild() {
    if (!stopped_) return;
    ::kill(pid_, SIGKILL);
    while (wait()) {
    }
  }
  TracedChild(const TracedChild&) = delete;
  TracedChild& operator=(const TracedChild&) = delete;

  pid_t pid() const { return pid_; }
  /// Lets it run to the begin of its system call number `number`, from 1 on, if it has not made it.
  /// False: it ended before.
  bool before_call(int number) {
    // Each call stops twice, at its begin and at its end.
    while (stopped_ && stops_ < 2 * number - 1) next();
    return stopped_;
  }
  void next() {
    ::ptrace(PTRACE_SYSCALL, pid_, nullptr, nullptr);
    ++stops_;
    wait();
  }
  /// Lets it run to its end. Returns the status of waitpid().
  int end() {
    while (stopped_) {
      const int signal = WSTOPSIG(status_) == SIGTRAP ? 0 : WSTOPSIG(status_);
      ::ptrace(PTRACE_CONT, pid_, nullptr, signal);
      wait();
    }
    return status_;
  }

 private:
  bool wait() { return stopped_ = ::waitpid(pid_, &status_, 0) == pid_ && WIFSTOPPED(status_); }

  pid_t pid_;
  int status_ = 0, stops_ = 0;
  bool stopped_ = false;
};

/// For each moment: `prepare`, the killed `action`, `check`. Returns how many there were; the last
/// check is after an action that ended by itself.
inline int at_each_kill(const std::function<void()>& prepare, const std::function<void()>& action,
                        const std::function<void()>& check) {
  for (int number = 1;; ++number) {
    const ::testing::ScopedTrace where(__FILE__, __LINE__,
                                       "killed before system call " + std::to_string(number));
    prepare();
    bool killed = false;
    {
      TracedChild child(action);
      killed = child.before_call(number);
      if (!killed) {
        EXPECT_EQ(child.end(), 0) << "it ends with an error";
      }
    }
    check();
    if (!killed || ::testing::Test::HasFailure()) return number - 1;
  }
}

#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
/// As at_each_kill(), for the error `error` of each system call in turn, which then does nothing.
/// What `action` throws is no failure, but its end by a signal is.
inline int at_each_error(int error, const std::function<void()>& prepare,
                         const std::function<void()>& action, const std::function<void()>& check) {
  const auto caught = [&] {
    try {
      action();
    } catch (const std::exception&) {
    }
  };
  for (int number = 1;; ++number) {
    const ::testing::ScopedTrace where(
        __FILE__, __LINE__,
        "error " + std::to_string(error) + " of system call " + std::to_string(number));
    prepare();
    TracedChild child(caught);
    bool made = child.before_call(number);
    user_regs_struct registers{};
    if (made) {
      ::ptrace(PTRACE_GETREGS, child.pid(), nullptr, &registers);
      made = registers.orig_rax != SYS_exit_group;
    }
    if (made) {
      registers.orig_rax = static_cast<unsigned long long>(-1);
      ::ptrace(PTRACE_SETREGS, child.pid(), nullptr, &registers);
      child.next();
      registers.rax = static_cast<unsigned long long>(-error);
      ::ptrace(PTRACE_SETREGS, child.pid(), nullptr, &registers);
    }
    EXPECT_EQ(child.end(), 0) << "it ended by a signal";
    check();
    if (!made || ::testing::Test::HasFailure()) return number - 1;
  }
}
#endif

}  // namespace tp100::test
