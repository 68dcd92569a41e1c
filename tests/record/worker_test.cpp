#include "record/worker.h"

#include <gtest/gtest.h>

#include <future>
#include <vector>

namespace tp100::record {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

TEST(DiskWorker, RunsJobsInTheirOrder) {
  std::vector<int> ran;
  Worker worker;
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(worker.post([&ran, i] { ran.push_back(i); }));
  EXPECT_TRUE(worker.idle_by(Clock::time_point::max()));
  EXPECT_EQ(ran, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(DiskWorker, RefusesMoreThanItHoldsAndNeverWaits) {
  std::promise<void> disk, began;
  int ran = 0;
  {
    Worker worker(2);
    EXPECT_TRUE(worker.post([&] {
      began.set_value();
      disk.get_future().wait();
    }));
    began.get_future().wait();
    EXPECT_FALSE(worker.idle_by(Clock::now() + 1ms));
    EXPECT_TRUE(worker.post([&] { ++ran; }));
    EXPECT_TRUE(worker.post([&] { ++ran; }));
    EXPECT_FALSE(worker.post([&] { ++ran; }));
    EXPECT_EQ(ran, 0);
    disk.set_value();
  }
  EXPECT_EQ(ran, 2) << "waiting jobs must be done before the end";
}

}  // namespace
}  // namespace tp100::record
