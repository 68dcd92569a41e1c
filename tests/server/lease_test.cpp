// Who drives by hand, and how old what a person asks for counts.
#include "server/lease.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tp100::server {
namespace {

const std::string kA = "viewer 1", kB = "viewer 2";

class LeaseTest : public testing::Test {
 protected:
  std::optional<VelocityInput> drive(const std::string& token, double input_ms) {
    why_.clear();
    return lease_.drive({token, 0.1, 0.2, input_ms}, now_, why_);
  }
  void pass(double ms) { now_ += from_s(ms * 1e-3); }

  Lease lease_;
  HostNs now_ = 10 * kNsPerS;
  std::string why_;
};

TEST_F(LeaseTest, OnlyTheTokenOfTheLastTakeDrives) {
  EXPECT_FALSE(drive("", 0.0));
  const std::string first = lease_.take(kA, now_).value();
  EXPECT_GE(first.size(), 16U);
  const std::string again = lease_.take(kA, now_).value();
  EXPECT_NE(first, again);
  EXPECT_FALSE(drive(first, 0.0));
  const auto input = drive(again, 0.0);
  ASSERT_TRUE(input);
  EXPECT_EQ(input->speed_mps, 0.1);
  EXPECT_EQ(input->yaw_rate_radps, 0.2);
  EXPECT_EQ(input->at_ns, now_);
}

TEST_F(LeaseTest, IsNotGivenAwayWhileTheDriversInputIsFresh) {
  const std::string token = lease_.take(kA, now_).value();
  for (double ms = 0.0; ms < 2000.0; ms += 50.0) {
    pass(50.0);
    ASSERT_TRUE(drive(token, ms));
    EXPECT_FALSE(lease_.take(kB, now_));
  }
  EXPECT_EQ(lease_.figures(now_).by, "viewer 1");
  EXPECT_EQ(lease_.figures(now_).asked_by, "viewer 2");
  pass(151.0);
  const auto taken = lease_.take(kB, now_);
  ASSERT_TRUE(taken);
  EXPECT_FALSE(drive(token, 3000.0)) << "two drivers must never mix";
  EXPECT_EQ(lease_.figures(now_).by, "viewer 2");
  EXPECT_EQ(lease_.figures(now_).asked_by, "");
}

TEST_F(LeaseTest, AnInputThatIsDelayedOrWhoseTimeStandsStillIsAsOldAsThePersonsInput) {
  std::string token = lease_.take(kA, now_).value();
  const HostNs begin_ns = now_;
  ASSERT_TRUE(drive(token, 1000.0));
  pass(800.0);
  const auto late = drive(token, 1100.0);
  ASSERT_TRUE(late);
  EXPECT_NEAR(to_s(late->at_ns - begin_ns), 0.1, 0.002);
  token = lease_.take(kA, now_).value();
  const HostNs given_ns = now_;
  for (int i = 0; i < 100; ++i, pass(20.0)) {
    const auto input = drive(token, 500.0);
    ASSERT_TRUE(input);
    EXPECT_LE(input->at_ns, given_ns + 2 * kNsPerMs);
  }
  EXPECT_FALSE(lease_.figures(now_).fresh);
  EXPECT_TRUE(lease_.take(kB, now_));
}

// A first input that the client gave long before it had the lease says nothing about its clock.
TEST_F(LeaseTest, AnOldFirstInputDoesNotHideTheDelayOfThePath) {
  for (const double old_ms : {0.0, 50.0, 500.0, 1e4}) {
    const std::string token = lease_.take(kA, now_).value();
    pass(280.0);
    ASSERT_TRUE(drive(token, 1e5 - old_ms));
    for (double ms = 1e5 + 40.0; ms < 1.01e5; ms += 40.0) {
      pass(40.0);
      const auto input = drive(token, ms);
      ASSERT_TRUE(input);
      EXPECT_GE(now_ - input->at_ns, from_s(0.13));
    }
    lease_.clear();
  }
}

TEST_F(LeaseTest, ClocksThatDriftApartStayTogether) {
  for (const double rate : {0.9995, 1.0005}) {
    const std::string token = lease_.take(kA, now_).value();
    for (double ms = 0.0; ms < 3600e3; ms += 20.0) {
      pass(20.0);
      const auto input = drive(token, ms * rate);
      ASSERT_TRUE(input);
      ASSERT_LE(now_ - input->at_ns, 5 * kNsPerMs);
      ASSERT_LE(input->at_ns, now_);
    }
  }
}

TEST_F(LeaseTest, AClientsClockNeverDatesAnInputIntoTheFuture) {
  const std::string token = lease_.take(kA, now_).value();
  for (const double ms : {0.0, 1e15, -1e15, 5.0, 1e15}) {
    pass(20.0);
    const auto input = drive(token, ms);
    ASSERT_TRUE(input);
    EXPECT_LE(input->at_ns, now_);
  }
}

TEST_F(LeaseTest, AReleaseOrALostClientLeavesItToNobody) {
  const std::string token = lease_.take(kA, now_).value();
  EXPECT_FALSE(lease_.release("other"));
  EXPECT_TRUE(lease_.release(token));
  EXPECT_FALSE(lease_.release(token));
  EXPECT_FALSE(drive(token, 0.0));
  EXPECT_EQ(lease_.figures(now_).by, "");
  const std::string next = lease_.take(kB, now_).value();
  EXPECT_FALSE(lease_.lose(kA));
  EXPECT_TRUE(drive(next, 0.0));
  EXPECT_TRUE(lease_.lose(kB));
  EXPECT_FALSE(drive(next, 1.0));
}

TEST_F(LeaseTest, ARefusedClientAsksForAWhileOrUntilItIsGone) {
  const std::string token = lease_.take(kA, now_).value();
  for (const bool leaves : {false, true}) {
    ASSERT_TRUE(drive(token, to_s(now_) * 1e3));
    EXPECT_FALSE(lease_.take(kB, now_));
    pass(100.0);
    EXPECT_EQ(lease_.figures(now_).asked_by, "viewer 2");
    EXPECT_FALSE(leaves && lease_.lose(kB)) << "it had no lease to lose";
    if (!leaves) pass(5000.0);
    EXPECT_EQ(lease_.figures(now_).asked_by, "");
  }
}

}  // namespace
}  // namespace tp100::server
