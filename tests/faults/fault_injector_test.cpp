// Tests that faults occur at their times, in their direction and as often as planned.

#include "sim/faults/fault_injector.h"

#include <gtest/gtest.h>

#include "core/time.h"

namespace tp100::sim {
namespace {

constexpr std::int64_t kBeginNs = 5 * kNsPerS;

/// The injector of these faults, whose port was opened at 5 s.
FaultInjector opened(const std::vector<std::string>& faults) {
  FaultInjector injector(parse_faults(faults), 0, 1);
  injector.begin(kBeginNs);
  return injector;
}

TEST(FaultInjector, CutsBytesInItsDirectionAtItsTimeSinceThePortWasOpened) {
  FaultInjector injector = opened({"cut:to-host@1+1"});
  for (const double at_s : {0.5, 1.5, 2.5}) {
    const std::int64_t at_ns = kBeginNs + from_s(at_s);
    const std::vector<TimedByte> bytes{{at_ns, 7}};
    EXPECT_EQ(injector.to_host(bytes, at_ns).size(), at_s == 1.5 ? 0u : 1u) << at_s;
    const std::vector<TimedByte> arrived = injector.to_robot(bytes, at_ns);
    ASSERT_EQ(arrived.size(), 1u) << at_s;
    EXPECT_EQ(arrived[0].at_ns, at_ns);
  }
  FaultInjector not_opened(parse_faults({"cut", "battery"}), 0, 1);
  const std::vector<TimedByte> bytes{{1, 7}};
  EXPECT_EQ(not_opened.to_host(bytes, 1).size(), 1u);
  EXPECT_EQ(not_opened.battery(8.0, 1), 8.0);
}

TEST(FaultInjector, ChangesVoltageAndEdgesWhileItLasts) {
  FaultInjector injector = opened({"battery:5@1+1", "encoder-stuck:left@1+1", "imu-missing@1+1"});
  for (const double at_s : {0.9, 1.0, 1.9, 2.0}) {
    const std::int64_t at_ns = kBeginNs + from_s(at_s);
    const bool lasts = at_s >= 1.0 && at_s < 2.0;
    EXPECT_EQ(injector.battery(8.0, at_ns), lasts ? 5.0 : 8.0) << at_s;
    EXPECT_EQ(injector.active(FaultKind::kImuMissing, at_ns), lasts) << at_s;
    EXPECT_FALSE(injector.active(FaultKind::kImuFrozen, at_ns));
    std::vector<EncoderEdge> edges{{at_ns, 0, true}, {at_ns, 2, true}};
    injector.edges(edges, at_ns);
    EXPECT_EQ(edges.size(), lasts ? 1u : 2u) << at_s;
  }
}

TEST(FaultInjector, WhatHappensAtOnceIsTakenOnceAndWhatRepeatsOnceAPeriod) {
  FaultInjector injector = opened({"unplug:3@1", "reboot-loop:0.5@1+1.2"});
  std::vector<int> unplugged_ms, rebooted_ms;
  for (int ms = 0; ms < 4000; ms += 10) {
    const std::int64_t at_ns = kBeginNs + ms * kNsPerMs;
    if (const auto seconds = injector.take(FaultKind::kUnplug, at_ns)) {
      EXPECT_EQ(*seconds, 3.0);
      unplugged_ms.push_back(ms);
    }
    if (injector.take(FaultKind::kRebootLoop, at_ns)) rebooted_ms.push_back(ms);
    EXPECT_FALSE(injector.take(FaultKind::kHang, at_ns));
  }
  EXPECT_EQ(unplugged_ms, (std::vector{1000}));
  EXPECT_EQ(rebooted_ms, (std::vector{1000, 1500, 2000}));
}

}  // namespace
}  // namespace tp100::sim
