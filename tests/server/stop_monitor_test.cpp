#include <gtest/gtest.h>

#include "server/publisher.h"

namespace tp100::server {
namespace {

using Status = messages::StopFigures::Status;
constexpr HostNs kMs = kNsPerMs;

TEST(StopMonitor, TellsHowLongTheRobotTookAndAfter200MsThatItHasNotAcknowledged) {
  StopMonitor stop;
  EXPECT_EQ(stop.figures().status, Status::kNone);
  stop.press("keyboard", 1000 * kMs);
  // The answer to an earlier STOP.
  stop.answered(999 * kMs);
  EXPECT_FALSE(stop.tick(1199 * kMs));
  EXPECT_EQ(stop.figures().status, Status::kPending);
  EXPECT_TRUE(stop.tick(1200 * kMs));
  EXPECT_EQ(stop.figures().status, Status::kNotAcknowledged);
  EXPECT_FALSE(stop.tick(1300 * kMs)) << "said once";
  // The acknowledgement may still arrive after a reconnect.
  stop.answered(6000 * kMs);
  EXPECT_EQ(stop.figures().status, Status::kAcknowledged);
  EXPECT_DOUBLE_EQ(stop.figures().acknowledged_ms, 5000.0);
}

TEST(StopMonitor, PressingAgainDoesNotMakeItLookFaster) {
  StopMonitor stop;
  stop.press("viewer 1", 1000 * kMs);
  stop.press("viewer 2", 1100 * kMs);
  EXPECT_EQ(stop.figures().by, "viewer 2");
  EXPECT_TRUE(stop.tick(1200 * kMs));
  stop.answered(1300 * kMs);
  EXPECT_DOUBLE_EQ(stop.figures().acknowledged_ms, 300.0);
}

TEST(StopMonitor, OnlyAStartEndsTheLatch) {
  StopMonitor stop;
  stop.press("viewer 1", 1000 * kMs);
  stop.answered(1010 * kMs);
  EXPECT_TRUE(stop.figures().latched);
  // A step that was measured at the time of the press does not include the STOP yet.
  stop.under_way(1005 * kMs, false);
  EXPECT_TRUE(stop.figures().latched);
  // This report is late: it is about a run that began earlier.
  stop.under_way(999 * kMs, true);
  EXPECT_TRUE(stop.figures().latched);
  stop.under_way(1100 * kMs, true);
  EXPECT_FALSE(stop.figures().latched);
  EXPECT_EQ(stop.figures().status, Status::kAcknowledged);
  stop.press("viewer 1", 2000 * kMs);
  stop.under_way(2300 * kMs, false);
  EXPECT_FALSE(stop.figures().latched);
}

}  // namespace
}  // namespace tp100::server
