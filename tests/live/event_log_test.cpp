#include "live/event_log.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <thread>

namespace tp100::live {
namespace {

using ::testing::HasSubstr;

/// Redirects standard error into a pipe of one page during its lifetime.
class SmallPipe {
 public:
  SmallPipe() : before_(::dup(STDERR_FILENO)) {
    EXPECT_EQ(::pipe2(ends_.data(), O_CLOEXEC), 0);
    ::fcntl(ends_[1], F_SETPIPE_SZ, 4096);
    ::dup2(ends_[1], STDERR_FILENO);
    ::close(ends_[1]);
  }
  ~SmallPipe() {
    restore();
    ::close(ends_[0]);
  }
  void restore() {
    if (before_ < 0) return;
    ::dup2(before_, STDERR_FILENO);
    ::close(before_);
    before_ = -1;
  }
  /// Reads until all writers have closed the pipe.
  std::string read_all() const {
    std::string text;
    std::array<char, 4096> buffer{};
    for (ssize_t n = 0; (n = ::read(ends_[0], buffer.data(), buffer.size())) > 0;)
      text.append(buffer.data(), static_cast<std::size_t>(n));
    return text;
  }

 private:
  int before_;
  std::array<int, 2> ends_{};
};

// A person who reads on must know that something is missing. The last line: terminal_test.py.
TEST(EventLog, WhoDoesNotReadItHoldsUpNobodyAndIsToldHowManyOldLinesAreLost) {
  SmallPipe pipe;
  auto log = std::make_unique<EventLog>();
  for (int i = 0; i < 5000; ++i) log->info("line " + std::to_string(i) + ";");
  std::string output;
  std::thread reader([&] { output = pipe.read_all(); });
  EXPECT_TRUE(log->flush());
  log->tick(0);
  log->tick(0);
  log.reset();
  pipe.restore();
  reader.join();
  EXPECT_THAT(output, HasSubstr("line 4999;\n")) << "the newest lines must arrive";
  const auto shown = std::count(output.begin(), output.end(), '\n') - 1;
  EXPECT_LT(shown, 5000) << "the oldest lines must have been dropped";
  EXPECT_THAT(output, HasSubstr(std::to_string(5000 - shown) + " lines of this log are lost"));
}

}  // namespace
}  // namespace tp100::live
