// The thread that waits for disks: it refuses what it cannot hold, and no job ends the program.

#include "core/worker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <future>
#include <new>
#include <stdexcept>
#include <vector>

#include "core/error.h"

namespace tp100 {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const Worker::Failed kNever = [](const std::string& why) { ADD_FAILURE() << why; };

TEST(DiskWorker, RefusesMoreThanItHoldsAndNeverWaits) {
  std::promise<void> disk, began;
  std::vector<int> ran;
  {
    Worker worker("test", 2);
    EXPECT_TRUE(worker.post(
        [&] {
          began.set_value();
          disk.get_future().wait();
        },
        kNever));
    began.get_future().wait();
    EXPECT_FALSE(worker.idle_by(Clock::now() + 1ms));
    for (int i = 1; i <= 3; ++i)
      EXPECT_EQ(worker.post([&ran, i] { ran.push_back(i); }, kNever), i <= 2);
    EXPECT_TRUE(ran.empty());
    disk.set_value();
  }
  EXPECT_EQ(ran, (std::vector<int>{1, 2})) << "waiting jobs must be done, in order, before the end";
}

/// Why a job failed that calls `action`.
std::string why_not(const std::function<void()>& action) {
  std::string why;
  Worker worker("test");
  worker.ask([&](const std::string& told, const std::string&) { why = told; },
             [&] {
               action();
               return "{}";
             });
  EXPECT_TRUE(worker.idle_by(Clock::time_point::max()));
  return why;
}

// A damaged disk, or a lack of memory, would end the daemon in the middle of a run.
TEST(DiskWorker, WhateverAJobThrowsIsItsAnswer) {
  EXPECT_EQ(why_not([] {}), "");
  EXPECT_EQ(why_not([] { throw UserError("no such run"); }), "no such run");
  EXPECT_EQ(why_not([] {
              throw std::filesystem::filesystem_error("status", "/home/me/runs/a\nb",
                                                      std::make_error_code(std::errc::io_error));
            }),
            "a?b: Input/output error; check folder, permission and disk");
  EXPECT_THAT(why_not([] { std::filesystem::remove_all(std::string(300, 'a')); }),
              HasSubstr("aaa...: File name too long"));
  EXPECT_THAT(why_not([] { throw std::bad_alloc(); }), HasSubstr("memory is used up"));
  EXPECT_THAT(why_not([] { throw std::length_error("too\nlong"); }),
              AllOf(HasSubstr("too?long"), HasSubstr("report it")));
  EXPECT_THAT(why_not([] { throw 1; }), HasSubstr("report it"));
}

TEST(DiskWorker, AnErrorOfAnAnswerEndsNothing) {
  Worker worker("test");
  int answered = 0;
  const auto answer = [&](const std::string&, const std::string&) {
    ++answered;
    throw std::bad_alloc();
  };
  for (int i = 0; i < 3; ++i) worker.ask(answer, [] { return "{}"; });
  EXPECT_TRUE(worker.post([] { throw 1; }, [](const std::string&) { throw 2; }));
  EXPECT_TRUE(worker.idle_by(Clock::time_point::max()));
  EXPECT_EQ(answered, 3) << "each request is answered once";
}

TEST(DiskWorker, ARequestThatFindsTooManyOthersIsAnswered) {
  std::promise<void> disk;
  std::vector<std::string> whys;
  {
    Worker worker("test", 1);
    worker.post([&] { disk.get_future().wait(); }, kNever);
    const auto answer = [&](const std::string& why, const std::string&) { whys.push_back(why); };
    // One of these begins at once if the first has not been taken up yet.
    for (int i = 0; i < 3; ++i) worker.ask(answer, [] { return "{}"; });
    EXPECT_THAT(whys, Not(::testing::IsEmpty()));
    for (const std::string& why : whys) EXPECT_EQ(why, Worker::kBusy);
    disk.set_value();
  }
  EXPECT_EQ(whys.size(), 3U);
}

}  // namespace
}  // namespace tp100
