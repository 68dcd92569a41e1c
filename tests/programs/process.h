#pragma once
// Runs a program under test: its output, exit status and signals.

#include <sys/types.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "../support/eventually.h"
#include "../support/temporary_folder.h"

namespace tp100::test {

using Words = std::vector<std::string>;
Words joined(Words first, const Words& more);

/// One of the project's programs. The destructor kills it if it still runs; so does the end of the
/// thread that made it, for any reason.
class Process {
 public:
  /// `arguments[0]` is tp100d, tp100-sim or an absolute path. Standard output and standard error go
  /// to one buffer. `input` becomes standard input; -1 means none.
  explicit Process(std::vector<std::string> arguments, int input = -1);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Waits until `text` appears in the output after the text that earlier calls found. Returns
  /// false if the program ends or a minute passes before.
  bool wait_for(const std::string& text);
  /// Waits for `text` like wait_for(); returns the rest of its line, or throws.
  std::string line_after(const std::string& text);
  pid_t pid() const { return pid_; }
  /// Sends a signal, unless the program has ended.
  void signal(int number);
  /// Waits for the end. Returns the exit status, 128 + signal if the program was killed, or -1
  /// after two minutes. A daemon whose run was aborted asks a person to start again: unless a
  /// signal was sent it would never end, and -1 is returned at once.
  int wait();
  /// Everything printed so far.
  const std::string& output();

 private:
  bool read_some(std::chrono::milliseconds patience);
  bool asks_to_start_again() const;

  pid_t pid_ = -1;
  int pipe_ = -1;
  int status_ = -1;
  bool signalled_ = false;
  std::string output_;
  std::size_t searched_ = 0;
};

/// Status and output of a program that has ended.
struct Finished {
  int status;
  std::string output;
};
Finished run(std::vector<std::string> arguments);

/// Starts `tp100-sim robot` with the arguments `more`; returns when its port is there, at `link`.
std::unique_ptr<Process> start_robot(const std::string& link, const Words& more = {});

/// The port of the page that `tp100d run` serves; waits for it.
std::string page_port(Process& daemon);

/// The first number of that name in the file that tp100d --stats writes once a second; -1 if there
/// is none yet.
double figure(const std::string& stats, const std::string& name);
/// Writes a straight course into the folder, by default one of about six seconds, and returns the
/// file's path.
std::string short_course(const TemporaryFolder& folder, double length_m = 0.5);

/// Number of lines in `text`.
std::size_t lines(const std::string& text);

}  // namespace tp100::test
