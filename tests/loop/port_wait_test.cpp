#include "loop/port_wait.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>

#include "core/clock.h"
#include "core/error.h"

namespace tp100::loop {
namespace {

constexpr HostNs kSpareNs = 500 * kNsPerUs;

class PortWaits : public ::testing::Test {
 protected:
  PortWaits() {
    EXPECT_EQ(::pipe(ends_.data()), 0);
    wait_.watch(ends_[0]);
  }
  ~PortWaits() override {
    ::close(ends_[0]);
    hang_up();
  }
  void send() { EXPECT_EQ(::write(ends_[1], "x", 1), 1); }
  void take() {
    char byte = 0;
    EXPECT_EQ(::read(ends_[0], &byte, 1), 1);
  }
  void hang_up() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }
  bool readable(HostNs until) { return wait_.readable(until); }
  /// Polls until the deadline, like the loop; returns the number of polls.
  int wait_out(HostNs until) {
    int asked = 0;
    for (; monotonic_now() < until; ++asked) EXPECT_FALSE(readable(until));
    return asked;
  }

  std::array<int, 2> ends_{-1, -1};
  PortWait wait_{kSpareNs};
};

TEST_F(PortWaits, BytesEndItWhateverTheDeadline) {
  send();
  EXPECT_TRUE(readable(monotonic_now() + 1000 * kNsPerS));
  EXPECT_TRUE(readable(monotonic_now() - kNsPerS));
  EXPECT_TRUE(readable(0));
}

TEST_F(PortWaits, AnEndOfThePortIsNoSilence) {
  hang_up();
  EXPECT_TRUE(readable(monotonic_now() + 1000 * kNsPerS));
}

TEST_F(PortWaits, SilenceEndsAtEachDeadlineHoweverTheyFollow) {
  // The deadlines are shorter and longer than the timer's period, and one has passed.
  for (const HostNs ahead : {3000, 100, 700, -200, 500, 2000, 1, 499}) {
    const HostNs until = monotonic_now() + ahead * kNsPerUs;
    wait_out(until);
    EXPECT_GE(monotonic_now(), until);
  }
}

TEST_F(PortWaits, ADeadlineBeforeTheOneThatIsSetIsKept) {
  send();
  EXPECT_TRUE(readable(monotonic_now() + 1000 * kNsPerS));
  take();
  for (int cycle = 0; cycle < 5; ++cycle) wait_out(monotonic_now() + kNsPerMs);
  send();
  EXPECT_TRUE(readable(monotonic_now() + 1000 * kNsPerS));
}

TEST_F(PortWaits, ATimerThatRanAlreadyCostsOneMoreLookAndNoBusyWait) {
  for (int cycle = 0; cycle < 20; ++cycle) EXPECT_LE(wait_out(monotonic_now() + 2 * kNsPerMs), 8);
}

TEST(PortWait, WithoutDescriptorsItSaysWhatToRaise) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs descriptors itself, of which there are none here";
#endif
  rlimit before{};
  ::getrlimit(RLIMIT_NOFILE, &before);
  const rlimit none{0, before.rlim_max};
  ::setrlimit(RLIMIT_NOFILE, &none);
  try {
    PortWait wait(kSpareNs);
    ADD_FAILURE() << "the timer was created without a descriptor";
  } catch (const UserError& error) {
    EXPECT_NE(std::string(error.what()).find("ulimit -n"), std::string::npos) << error.what();
  }
  ::setrlimit(RLIMIT_NOFILE, &before);
}

}  // namespace
}  // namespace tp100::loop
