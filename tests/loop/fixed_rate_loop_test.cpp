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
#include "../support/eventually.h"

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
using test::eventually;

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

LoopSettings settings(bool robot_paced = false) {
  LoopSettings settings;
  settings.period_ns = 2 * kNsPerMs;
  settings.spin_ns = 0;
  settings.robot_paced = robot_paced;
  settings.thread.priority = 0;
  return settings;
}

/// A loop whose client is an Echo, with a port whose far end the test holds.
class LoopRig {
 public:
  explicit LoopRig(const LoopSettings& with = settings()) : loop(with, echo) {}

  void start() {
    loop.start();
    ASSERT_TRUE(loop.offer({sockets.ends[0], 7}));
  }
  void end() {
    loop.request_stop();
    loop.join();
    EXPECT_EQ(echo.after_write_too_early, 0u);
    EXPECT_EQ(echo.after_write_too_late, 0u);
    const LoopStatistics& counted = loop.statistics();
    EXPECT_EQ(counted.compute.count(), counted.cycles);
    EXPECT_LE(counted.overruns, counted.missed) << "each skips at least one";
    // The cycle that ends the loop is late or on time, too.
    EXPECT_LE(counted.frame_timeouts, counted.lateness.count());
    EXPECT_LE(counted.lateness.count(), counted.cycles + 1);
  }
  void send(std::string_view text) const {
    ASSERT_EQ(::write(sockets.ends[1], text.data(), text.size()),
              static_cast<ssize_t>(text.size()));
  }
  /// Appends what has come back to `text`; false: nothing has.
  bool receive(std::string& text) const {
    char buffer[4096];
    const ssize_t n = ::read(sockets.ends[1], buffer, sizeof buffer);
    if (n > 0) text.append(buffer, static_cast<std::size_t>(n));
    return n > 0;
  }

  Echo echo;
  SocketPair sockets;
  FixedRateLoop loop;
};

class Paced : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(ByTheRobot, Paced, testing::Bool());

TEST_P(Paced, ReadsStepsAndWritesAndPacedByTheRobotAnswersEverySample) {
  LoopRig rig(settings(GetParam()));
  rig.echo.prompt = true;
  rig.start();
  for (char sample = 0; sample < 50; ++sample) {
    rig.send({&sample, 1});
    std::string back;
    ASSERT_TRUE(eventually([&] { return rig.receive(back); }));
    EXPECT_EQ(back, std::string(1, sample));
    std::this_thread::sleep_for(2ms);
  }
  EXPECT_EQ(rig.echo.openings, 1);
  rig.end();
  EXPECT_TRUE(rig.loop.ended());
  EXPECT_EQ(rig.echo.closings, 1);
  EXPECT_EQ(rig.echo.done_after_write, rig.echo.steps);
  if (GetParam()) {
    EXPECT_GT(rig.loop.statistics().cycles, rig.loop.statistics().frame_timeouts.load());
    EXPECT_EQ(rig.loop.statistics().work.count(), rig.echo.steps);
  }
}

TEST_P(Paced, GivesALostPortBackAndTakesTheNext) {
  LoopRig rig(settings(GetParam()));
  SocketPair second;
  rig.start();
  EXPECT_TRUE(eventually([&] { return rig.echo.openings == 1; }));
  rig.sockets.close_far();
  LostPort lost;
  ASSERT_TRUE(eventually([&] { return rig.loop.take_lost(lost); }));
  EXPECT_EQ(lost.id, 7u);
  EXPECT_EQ(lost.end, PortEnd::kHungUp);
  ASSERT_TRUE(rig.loop.offer({second.ends[0], 2}));
  EXPECT_TRUE(eventually([&] { return rig.echo.openings == 2; }));
  rig.echo.hang_up = true;
  ASSERT_TRUE(eventually([&] { return rig.loop.take_lost(lost); }));
  EXPECT_EQ(lost.id, 2u);
  EXPECT_EQ(lost.end, PortEnd::kSilent);
  rig.end();
}

// Both calls would wait for a kernel worker that runs at ordinary priority.
TEST_P(Paced, NeitherReadsAnEmptyTerminalNorPollsIt) {
  for (const bool prompt : {false, true}) {
    Echo echo;
    echo.prompt = prompt;
    PtyPair pty;
    const int near = ::open(pty.near().c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(near, 0);
    FixedRateLoop loop(settings(GetParam()), echo);
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

TEST(FixedRateLoop, DropsOutputThatNobodyTakesAndGoesOnOnceItIsTaken) {
  LoopRig rig;
  // Fills the socket, so that the loop's next write finds no room.
  char block[4096] = {};
  std::size_t filled = 0;
  for (ssize_t n = 0; (n = ::write(rig.sockets.ends[0], block, sizeof block)) > 0;)
    filled += static_cast<std::size_t>(n);
  rig.start();
  rig.send("x");
  ASSERT_TRUE(eventually([&] { return rig.echo.drops > 0; }));
  const std::uint64_t steps = rig.echo.steps;
  EXPECT_TRUE(eventually([&] { return rig.echo.steps > steps + 10; }))
      << "the loop must not wait for the reader";
  EXPECT_EQ(rig.echo.drops, 1) << "dropped output must not be dropped again";
  std::string taken;
  while (rig.receive(taken)) {
  }
  EXPECT_EQ(taken, std::string(filled, '\0'));
  taken.clear();
  rig.send("y");
  EXPECT_TRUE(eventually([&] { return rig.receive(taken); }));
  EXPECT_EQ(taken, "y");
  LostPort lost;
  EXPECT_FALSE(rig.loop.take_lost(lost));
}

TEST(FixedRateLoop, WindsUpBeforeItEndsButNotForever) {
  for (const int cycles : {5, 1'000'000}) {
    LoopRig rig;
    rig.echo.shut_down_cycles = cycles;
    rig.loop.start();
    EXPECT_TRUE(eventually([&] { return rig.echo.steps > 5; })) << "it needs no port";
    rig.loop.request_stop();
    EXPECT_TRUE(eventually([&] { return rig.loop.ended(); }));
    rig.loop.join();
    if (cycles == 5) {
      EXPECT_EQ(rig.echo.shut_downs, 5);
    }
  }
}

TEST_P(Paced, CountsTurnsThatTakeTooLong) {
  LoopRig rig(settings(GetParam()));
  rig.echo.takes_ms = 7;
  rig.loop.start();
  EXPECT_TRUE(eventually([&] { return rig.loop.statistics().overruns >= 3; }));
  rig.end();
  EXPECT_GE(rig.loop.statistics().missed, 3 * rig.loop.statistics().overruns);
  EXPECT_EQ(rig.loop.statistics().lateness.count(), rig.loop.statistics().cycles + 1)
      << "no sample began a cycle";
}

// The peer sends without pause. The number of cycles and reads must be bounded by the elapsed time.
TEST_P(Paced, AFloodingPeerDoesNotKeepItBusy) {
  LoopSettings set = settings(GetParam());
  set.period_ns = 5 * kNsPerMs;
  LoopRig rig(set);
  rig.echo.echo = false;
  rig.start();
  std::vector<char> block(65536, 'U');
  const auto began = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - began < 300ms) {
    if (::write(rig.sockets.ends[1], block.data(), block.size()) < 0)
      std::this_thread::sleep_for(100us);
  }
  rig.end();
  const auto elapsed = std::chrono::steady_clock::now() - began;
  EXPECT_GT(rig.echo.received_bytes, 0u);
  EXPECT_LE(rig.echo.largest_read, FixedRateLoop::kReadSize);
  const auto cycles = static_cast<std::uint64_t>(elapsed / 2500us) + 2;
  EXPECT_LE(rig.loop.statistics().cycles, cycles);
  const auto reads = cycles + static_cast<std::uint64_t>(elapsed / 200us) + 2;
  EXPECT_LE(rig.echo.received_bytes, reads * FixedRateLoop::kReadSize);
}

}  // namespace
}  // namespace tp100::loop
