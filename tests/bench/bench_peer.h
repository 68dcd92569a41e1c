#pragma once
// A program at the other end of a pty.

#include <signal.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <thread>
#include <vector>

namespace tp100::test {

/// Starts a program in its own process group, with `port` in place of every argument "PORT"; the
/// destructor terminates the group.
class BenchPeer {
 public:
  BenchPeer(const std::vector<std::string>& command, const std::string& port) {
    std::vector<std::string> words;
    for (const std::string& word : command) words.push_back(word == "PORT" ? port : word);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_ = ::fork();
    if (pid_ != 0) return;
    ::setpgid(0, 0);
    // Standard output is reserved for the measured times.
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  ~BenchPeer() {
    ::setpgid(pid_, pid_);
    ::kill(-pid_, SIGTERM);
    for (int i = 0; i < 200 && !ended(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ::kill(-pid_, SIGKILL);
    if (!ended_) ::waitpid(pid_, nullptr, 0);
  }
  BenchPeer(const BenchPeer&) = delete;
  BenchPeer& operator=(const BenchPeer&) = delete;

  bool ended() {
    ended_ = ended_ || ::waitpid(pid_, nullptr, WNOHANG) == pid_;
    return ended_;
  }

 private:
  pid_t pid_ = -1;
  bool ended_ = false;
};

}  // namespace tp100::test
