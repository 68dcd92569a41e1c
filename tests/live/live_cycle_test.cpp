#include "live/live_cycle.h"

#include <gtest/gtest.h>

#include "course/course.h"
#include "live_rig.h"

namespace tp100::live {
namespace {

std::shared_ptr<const course::Course> line() {
  return std::make_shared<const course::Course>(
      course::parse_course("speed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 1.0\n"
                           "[fence]\nmin_x_m = -1\nmax_x_m = 2\nmin_y_m = -1\nmax_y_m = 1\n",
                           "line.toml"));
}

// Whatever the robot does: its handshake, a reboot, a silence; and whatever people ask for.
TEST(LiveCycle, ATurnNeitherCallsTheSystemNorLocksNorAllocates) {
  LiveRig rig(line());
  loop::SlotRing<StepRecord> first(8);
  rig.cycle.record_first(first);
  rig.watched = rig.robot.drives = true;
  for (int i = 0; i < 1600; ++i) {
    if (i < 700 && i % 50 == 20) rig.cycle.request(OperatorRequest::kHold);
    if (i == 800) rig.start();
    if (i == 900) rig.cycle.request(OperatorRequest::kPause);
    if (i == 950) rig.start(false, OperatorRequest::kResume);
    if (i == 1200) rig.start(false, OperatorRequest::kDrive);
    if (i > 1200) {
      rig.cycle.velocity({.at_ns = rig.now, .speed_mps = 0.05});
      rig.cycle.camera({.measured_ns = rig.now});
      rig.cycle.world({.answered_ns = rig.now});
      rig.cycle.change({LiveParameter::kAcceleration, 0.05});
    }
    if (i == 1400) rig.cycle.stop();
    if (i == 1000 || i == 1400) rig.cycle.request(OperatorRequest::kHold);
    if (i == 100) rig.robot.reboot(rig.now);
    rig.robot.silent = i > 200 && i < 260;
    rig.step();
    while (rig.cycle.front_record() != nullptr) rig.cycle.release_record();
    // Full for most of the time.
    if (i % 50 == 0 && first.front() != nullptr) first.release();
  }
  EXPECT_NE(first.front(), nullptr);
  EXPECT_EQ(rig.arms(), 2u) << "it runs, and is driven";
  EXPECT_EQ(rig.robot.received.stops.size(), 1u) << "a hold in the same step does not undo it";
  EXPECT_EQ(rig.duty.heap, 0u);
  EXPECT_EQ(rig.duty.locks, 0u);
  EXPECT_EQ(rig.duty.first_system_call, -1);
  if (!test::watches_system_calls())
    GTEST_SKIP() << "this kernel does not tell of system calls; heap and locks: none";
}

TEST(LiveCycle, HandsOutEveryStepInOrderAndASlowReaderMissesStepsAndNothingElse) {
  LiveRig rig;
  for (std::uint64_t step = 1; step <= 2000; ++step) {
    rig.step();
    ASSERT_EQ(rig.front(), step);
    rig.cycle.release_record();
    ASSERT_EQ(rig.front(), 0u);
  }
  EXPECT_EQ(rig.cycle.lost_records(), 0u);
  const std::size_t commands = rig.robot.received.commands.size();
  for (std::size_t i = 0; i < LiveCycle::kWaitingRecords + 30; ++i) rig.step();
  EXPECT_EQ(rig.cycle.lost_records(), 30u);
  EXPECT_GE(rig.robot.received.commands.size(), commands + LiveCycle::kWaitingRecords);
  EXPECT_EQ(rig.front(), 2001u);
  while (rig.front() != 0) rig.cycle.release_record();
  rig.step();
  EXPECT_EQ(rig.front(), 2000 + LiveCycle::kWaitingRecords + 31);
}

TEST(LiveCycle, TheFirstReaderHasAStepBeforeTheOtherOneAndMayMissSome) {
  LiveRig rig;
  loop::SlotRing<StepRecord> first(4);
  rig.cycle.record_first(first);
  for (int i = 0; i < 10; ++i) rig.step();
  rig.cycle.step(rig.now + 1);
  for (std::uint64_t step = 1; step <= 4; ++step, first.release())
    ASSERT_EQ(first.front()->step, step);
  EXPECT_EQ(first.front(), nullptr);
  rig.cycle.wrote(rig.now + 1);
  ASSERT_NE(first.front(), nullptr);
  EXPECT_EQ(first.front()->step, 11u);
  EXPECT_EQ(rig.cycle.lost_records(), 0u);
  for (std::uint64_t step = 1; step <= 10; ++step, rig.cycle.release_record())
    ASSERT_EQ(rig.front(), step);
  EXPECT_EQ(rig.front(), 0u);
}

/// A request to change to that course within a second.
struct CourseChange : SetupRequest {
  CourseChange(const LiveRig& rig, std::shared_ptr<const course::Course> to) {
    until_ns = rig.now + kNsPerS;
    change.step.emplace(bridge::Parameters{}, std::move(to));
  }
};

TEST(LiveCycle, AChangeOfTheCourseNeitherLocksNorAllocates) {
  LiveRig rig(line());
  rig.steps(400);
  for (int i = 0; i < 4; ++i) {
    // A sanitizer makes system calls when it meets a type for the first time.
    rig.watched = i > 0;
    CourseChange request(rig, line());
    request.change.parameters = bridge::session_settings({}).parameters;
    rig.cycle.offer_setup(request);
    rig.steps(300);
    ASSERT_EQ(rig.cycle.setup_done(), &request);
    EXPECT_TRUE(request.made);
    rig.cycle.release_setup();
  }
  EXPECT_EQ(rig.duty.heap, 0u);
  EXPECT_EQ(rig.duty.locks, 0u);
  EXPECT_EQ(rig.duty.first_system_call, -1);
}

TEST(LiveCycle, AChangeIsReturnedBeforeTheRecordOfItsFirstStep) {
  LiveRig rig(line());
  rig.steps(400);
  CourseChange request(rig, line());
  rig.cycle.offer_setup(request);
  rig.step();
  ASSERT_EQ(rig.cycle.setup_done(), &request);
  const StepRecord* record = rig.cycle.front_record();
  ASSERT_NE(record, nullptr);
  EXPECT_EQ(record->step, request.step);
  EXPECT_EQ(record->inputs.restart.size(), 1u);
}

// A start that was pressed for the old course must not begin the new one.
TEST(LiveCycle, AStartBeforeAChangeBeginsTheOldCourseAndTheChangeIsNotMade) {
  LiveRig rig(line());
  rig.steps(400);
  CourseChange request(rig, nullptr);
  rig.start();
  rig.cycle.offer_setup(request);
  rig.steps(100);
  EXPECT_EQ(rig.cycle.setup_done(), &request);
  EXPECT_FALSE(request.made);
  EXPECT_EQ(rig.arms(), 1u);
}

TEST(LiveCycle, AChangeIsGivenUpIfTheRobotDoesNotComeToRest) {
  LiveRig rig(line());
  rig.steps(400);
  rig.robot.metres_per_s = 0.1;
  rig.steps(100);
  SetupRequest request{.until_ns = rig.now + kNsPerS};
  request.change.place = Pose{};
  rig.cycle.offer_setup(request);
  rig.steps(150);
  EXPECT_EQ(rig.cycle.setup_done(), nullptr);
  rig.steps(100);
  EXPECT_EQ(rig.cycle.setup_done(), &request);
  EXPECT_FALSE(request.made);
}

TEST(LiveCycle, GivesUpThePortOfARobotAtRestAndNothingStartsByItselfAfterwards) {
  LiveRig rig(line());
  rig.steps(400);
  EXPECT_FALSE(rig.cycle.take_port_drop());
  rig.cycle.give_up_port();
  EXPECT_TRUE(rig.cycle.take_port_drop());
  EXPECT_FALSE(rig.cycle.take_port_drop()) << "once";
  rig.start(true);
  rig.steps(200);
  EXPECT_EQ(rig.arms(), 0u);
  rig.start();
  rig.steps(20);
  ASSERT_EQ(rig.arms(), 1u);
  rig.cycle.give_up_port();
  EXPECT_FALSE(rig.cycle.take_port_drop()) << "a run is under way";
  rig.cycle.request(OperatorRequest::kHold);
  rig.steps(400);
  EXPECT_FALSE(rig.cycle.take_port_drop()) << "what was refused is not kept";
}

}  // namespace
}  // namespace tp100::live
