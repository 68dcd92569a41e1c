#pragma once
// A program under test: its output, its end, its signals.

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace tp100::test {

/// A folder of its own, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// One of the project's programs; killed at the end if it still runs.
class Process {
 public:
  /// `arguments[0]` is tp100d, tp100-sim or an absolute path. Standard output and error go to one
  /// buffer.
  explicit Process(std::vector<std::string> arguments);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Waits until `text` appears in the output after what earlier calls found. False: it ended, or a
  /// minute has passed, without.
  bool wait_for(const std::string& text);
  /// Sends a signal.
  void signal(int number);
  /// Waits for the end and returns the exit status, 128 + signal if it was killed, -1 after two
  /// minutes.
  int wait();
  /// Everything printed so far.
  const std::string& output();

 private:
  bool read_some(std::chrono::milliseconds patience);

  pid_t pid_ = -1;
  int pipe_ = -1;
  int status_ = -1;
  std::string output_;
  std::size_t searched_ = 0;
};

/// Runs to the end; what it printed and how it ended.
struct Finished {
  int status;
  std::string output;
};
Finished run(std::vector<std::string> arguments);

/// Number of lines in `text`.
std::size_t lines(const std::string& text);

}  // namespace tp100::test
