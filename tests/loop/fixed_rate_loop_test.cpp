#include "loop/fixed_rate_loop.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

#include "../link/pty_pair.h"

// The linker wraps read and poll: the calls of the loop for the watched descriptor are counted.
namespace {
std::atomic<int> watched{-1};
std::atomic<int> empty_reads{0}, polls{0};
}  // namespace

extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier): the names that the linker asks for.
ssize_t __real_read(int fd, void* buffer, size_t size);
int __real_poll(pollfd* of, nfds_t count, int timeout);

ssize_t __wrap_read(int fd, void* buffer, size_t size) {
  const ssize_t n = __real_read(fd, buffer, size);
  if (fd == watched && n < 0) ++empty_reads;
  return n;
}

int __wrap_poll(pollfd* of, nfds_t count, int timeout) {
  for (nfds_t i = 0; i < count; ++i) polls += of[i].fd == watched;
  return __real_poll(of, count, timeout);
}
// NOLINTEND(bugprone-reserved-identifier)
}

namespace tp100::loop {
namespace {

using namespace std::chrono_literals;

// Echoes every byte and counts what happens to the port.
class Echo : public LoopClient {
 public:
  void opened(HostNs) override { ++openings; }
  void closed(HostNs) override { ++closings; }
  bool received(std::span<const std::uint8_t> bytes, HostNs) override {
    if (done_after_write != steps) ++after_write_too_late;
    received_bytes += bytes.size();
    if (bytes.size() > largest_read) largest_read = bytes.size();
    if (echo) out_.insert(out_.end(), bytes.begin(), bytes.end());
    return true;
  }
  void step(HostNs) override {
    if (done_after_write != steps) ++after_write_too_late;
    ++steps;
    std::this_thread::sleep_for(takes_ms.load() * 1ms);
  }
  void after_write(HostNs) override {
    ++done_after_write;
    if (!out_.empty()) ++after_write_too_early;
  }
  std::span<const std::uint8_t> output() override { return out_; }
  void written(std::size_t n) override {
    out_.erase(out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(n));
  }
  void drop_output() override {
    ++drops;
    out_.clear();
  }
  bool expects_reply(HostNs) override { return prompt; }
  bool take_port_drop() override { return hang_up.exchange(false); }
  bool shut_down(HostNs) override { return ++shut_downs >= shut_down_cycles; }

  std::atomic<int> openings{0}, closings{0}, drops{0}, shut_downs{0}, shut_down_cycles{1},
      takes_ms{0};
  std::atomic<std::uint64_t> steps{0}, done_after_write{0}, after_write_too_early{0},
      after_write_too_late{0}, received_bytes{0}, largest_read{0};
  std::atomic<bool> echo{true}, prompt{false}, hang_up{false};

 private:
  std::vector<std::uint8_t> out_;
};

struct SocketPair {
  SocketPair() {
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends) != 0) ends[0] = ends[1] = -1;
  }
  ~SocketPair() {
    close_far();
    ::close(ends[0]);
  }
  void close_far() {
    if (ends[1] >= 0) ::close(ends[1]);
    ends[1] = -1;
  }
  int ends[2];
};

template <class Condition>
bool eventually(Condition condition) {
  for (int i = 0; i < 5000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

LoopSettings settings() {
  LoopSettings settings;
  settings.period_ns = 2 * kNsPerMs;
  settings.spin_ns = 0;
  settings.thread.priority = 0;
  return settings;
}

TEST(FixedRateLoop, StepsWithoutAPort) {
  Echo echo;
  FixedRateLoop loop(settings(), echo);
  loop.start();
  EXPECT_TRUE(eventually([&] { return echo.steps > 20; }));
  EXPECT_EQ(echo.openings, 0);
}

TEST(FixedRateLoop, ReadsStepsAndWrites) {
  for (const bool robot_paced : {false, true}) {
    Echo echo;
    SocketPair sockets;
    LoopSettings set = settings();
    set.robot_paced = robot_paced;
    FixedRateLoop loop(set, echo);
    loop.start();
    ASSERT_TRUE(loop.offer({sockets.ends[0], 7}));
    ASSERT_EQ(::write(sockets.ends[1], "hello", 5), 5);
    std::string back;
    EXPECT_TRUE(eventually([&] {
      char buffer[16];
      const ssize_t n = ::read(sockets.ends[1], buffer, sizeof buffer);
      if (n > 0) back.append(buffer, static_cast<std::size_t>(n));
      return back == "hello";
    }));
    EXPECT_EQ(echo.openings, 1);
    loop.request_stop();
    loop.join();
    EXPECT_TRUE(loop.ended());
    EXPECT_EQ(echo.closings, 1);
    EXPECT_EQ(echo.done_after_write, echo.steps);
    EXPECT_EQ(echo.after_write_too_early, 0u);
    EXPECT_EQ(echo.after_write_too_late, 0u);
  }
}

TEST(FixedRateLoop, GivesALostPortBackAndTakesTheNext) {
  for (const bool robot_paced : {false, true}) {
    Echo echo;
    SocketPair first;
    SocketPair second;
    LoopSettings set = settings();
    set.robot_paced = robot_paced;
    FixedRateLoop loop(set, echo);
    loop.start();
    ASSERT_TRUE(loop.offer({first.ends[0], 1}));
    EXPECT_TRUE(eventually([&] { return echo.openings == 1; }));
    first.close_far();
    LostPort lost;
    ASSERT_TRUE(eventually([&] { return loop.take_lost(lost); }));
    EXPECT_EQ(lost.id, 1u);
    EXPECT_EQ(lost.end, PortEnd::kHungUp);
    ASSERT_TRUE(loop.offer({second.ends[0], 2}));
    EXPECT_TRUE(eventually([&] { return echo.openings == 2; }));
    echo.hang_up = true;
    ASSERT_TRUE(eventually([&] { return loop.take_lost(lost); }));
    EXPECT_EQ(lost.id, 2u);
    EXPECT_EQ(lost.end, PortEnd::kSilent);
    loop.request_stop();
    loop.join();
    EXPECT_EQ(echo.after_write_too_late, 0u);
  }
}

// Both calls would wait for a kernel worker that runs at ordinary priority.
TEST(FixedRateLoop, NeitherReadsAnEmptyTerminalNorPollsIt) {
  for (const bool robot_paced : {false, true}) {
    for (const bool prompt : {false, true}) {
      Echo echo;
      echo.prompt = prompt;
      PtyPair pty;
      const int near = ::open(pty.near().c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
      ASSERT_GE(near, 0);
      LoopSettings set = settings();
      set.robot_paced = robot_paced;
      FixedRateLoop loop(set, echo);
      watched = near;
      empty_reads = polls = 0;
      loop.start();
      ASSERT_TRUE(loop.offer({near, 1}));
      std::string back;
      for (const char* word : {"how", "are", "you"}) {
        pty.write({reinterpret_cast<const std::uint8_t*>(word), 3});
        EXPECT_TRUE(eventually([&] {
          for (const std::uint8_t byte : pty.read()) back += static_cast<char>(byte);
          return back.ends_with(word);
        }));
        const std::uint64_t steps = echo.steps;
        EXPECT_TRUE(eventually([&] { return echo.steps > steps + 10; }));
      }
      EXPECT_EQ(back, "howareyou");
      EXPECT_EQ(polls, 0);
      // At most one for each word, where it arrived between its announcement and the read.
      EXPECT_LE(empty_reads, 3);
      pty.close();
      LostPort lost;
      EXPECT_TRUE(eventually([&] { return loop.take_lost(lost); }));
      EXPECT_EQ(lost.end, PortEnd::kHungUp);
      loop.request_stop();
      loop.join();
      watched = -1;
      ::close(near);
    }
  }
}

TEST(FixedRateLoop, DropsOutputThatNobodyTakesAndGoesOnOnceItIsTaken) {
  Echo echo;
  SocketPair sockets;
  // Fills the socket, so that the loop's next write finds no room.
  char block[4096] = {};
  std::size_t filled = 0;
  for (ssize_t n = 0; (n = ::write(sockets.ends[0], block, sizeof block)) > 0;)
    filled += static_cast<std::size_t>(n);
  FixedRateLoop loop(settings(), echo);
  loop.start();
  ASSERT_TRUE(loop.offer({sockets.ends[0], 1}));
  ASSERT_EQ(::write(sockets.ends[1], "x", 1), 1);
  ASSERT_TRUE(eventually([&] { return echo.drops > 0; }));
  const std::uint64_t steps = echo.steps;
  EXPECT_TRUE(eventually([&] { return echo.steps > steps + 10; }))
      << "the loop must not wait for the reader";
  EXPECT_EQ(echo.drops, 1) << "dropped output must not be dropped again";
  std::string taken;
  const auto take = [&] {
    const ssize_t n = ::read(sockets.ends[1], block, sizeof block);
    if (n > 0) taken.append(block, static_cast<std::size_t>(n));
    return n > 0;
  };
  while (take()) {
  }
  EXPECT_EQ(taken, std::string(filled, '\0'));
  taken.clear();
  ASSERT_EQ(::write(sockets.ends[1], "y", 1), 1);
  EXPECT_TRUE(eventually(take));
  EXPECT_EQ(taken, "y");
  LostPort lost;
  EXPECT_FALSE(loop.take_lost(lost));
}

TEST(FixedRateLoop, WindsUpAndThenEnds) {
  Echo echo;
  echo.shut_down_cycles = 5;
  FixedRateLoop loop(settings(), echo);
  loop.start();
  loop.request_stop();
  loop.join();
  EXPECT_EQ(echo.shut_downs, 5);
}

TEST(FixedRateLoop, EndsEvenIfWindingUpNeverSucceeds) {
  Echo echo;
  echo.shut_down_cycles = 1'000'000;
  FixedRateLoop loop(settings(), echo);
  loop.start();
  loop.request_stop();
  EXPECT_TRUE(eventually([&] { return loop.ended(); }));
}

TEST(FixedRateLoop, PacedByTheRobotEverySampleIsAnswered) {
  for (const bool prompt : {false, true}) {
    Echo echo;
    echo.prompt = prompt;
    SocketPair sockets;
    LoopSettings set = settings();
    set.robot_paced = true;
    FixedRateLoop loop(set, echo);
    loop.start();
    ASSERT_TRUE(loop.offer({sockets.ends[0], 1}));
    for (char sample = 0; sample < 50; ++sample) {
      ASSERT_EQ(::write(sockets.ends[1], &sample, 1), 1);
      char back = -1;
      ASSERT_TRUE(eventually([&] { return ::read(sockets.ends[1], &back, 1) == 1; }));
      EXPECT_EQ(back, sample);
      std::this_thread::sleep_for(2ms);
    }
    loop.request_stop();
    loop.join();
    EXPECT_GT(loop.statistics().cycles, loop.statistics().frame_timeouts.load());
    EXPECT_EQ(loop.statistics().work.count(), echo.steps);
    EXPECT_EQ(echo.after_write_too_late, 0u);
  }
}

TEST(FixedRateLoop, CountsTurnsThatTakeTooLong) {
  for (const bool robot_paced : {false, true}) {
    Echo echo;
    echo.takes_ms = 7;
    LoopSettings set = settings();
    set.robot_paced = robot_paced;
    FixedRateLoop loop(set, echo);
    loop.start();
    EXPECT_TRUE(eventually([&] { return loop.statistics().overruns >= 3; }));
    loop.request_stop();
    loop.join();
    EXPECT_GE(loop.statistics().missed, 3 * loop.statistics().overruns);
  }
}

// The peer sends without pause. The number of cycles and reads must be bounded by the elapsed time.
TEST(FixedRateLoop, AFloodingPeerDoesNotKeepItBusy) {
  for (const bool robot_paced : {false, true}) {
    Echo echo;
    echo.echo = false;
    SocketPair sockets;
    LoopSettings set = settings();
    set.period_ns = 5 * kNsPerMs;
    set.robot_paced = robot_paced;
    FixedRateLoop loop(set, echo);
    loop.start();
    ASSERT_TRUE(loop.offer({sockets.ends[0], 1}));
    std::vector<char> block(65536, 'U');
    const auto began = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - began < 300ms) {
      if (::write(sockets.ends[1], block.data(), block.size()) < 0)
        std::this_thread::sleep_for(100us);
    }
    loop.request_stop();
    loop.join();
    const auto elapsed = std::chrono::steady_clock::now() - began;
    EXPECT_GT(echo.received_bytes, 0u);
    EXPECT_LE(echo.largest_read, FixedRateLoop::kReadSize);
    const auto cycles = static_cast<std::uint64_t>(elapsed / 2500us) + 2;
    EXPECT_LE(loop.statistics().cycles, cycles);
    const auto reads = cycles + static_cast<std::uint64_t>(elapsed / 200us) + 2;
    EXPECT_LE(echo.received_bytes, reads * FixedRateLoop::kReadSize);
  }
}

}  // namespace
}  // namespace tp100::loop
