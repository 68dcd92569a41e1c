// Tests the choice of manoeuvres by its properties, on drives that the extended model makes of the
// chosen courses.

#include "identify/next_manoeuvre.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <variant>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/path.h"
#include "model/track_model.h"
#include "simulated_drives.h"
#include "support/refusal.h"

namespace tp100::identify {
namespace {

using model::TrackParameters;
using testing::HasSubstr;

constexpr double kCountsPerMetre = 20000.0;

course::TextFile area(double half_m) {
  const std::string h = std::to_string(half_m);
  return {"room.toml", "[[segment]]\ntype = \"pivot\"\nangle_deg = 90.0\n[fence]\nmin_x_m = -" + h +
                           "\nmax_x_m = " + h + "\nmin_y_m = -" + h + "\nmax_y_m = " + h + "\n"};
}

Prior nothing_known() { return {.counts_per_metre = kCountsPerMetre}; }

TrackParameters robot() {
  TrackParameters tracks;
  tracks.slip_left = 0.13;
  tracks.slip_right = 0.15;
  tracks.slip_angle_straight_rad = tracks.slip_angle_turning_rad = 0.01;
  tracks.wheelbase_m = 0.24;
  tracks.wheelbase_medium_m = 0.245;
  tracks.wheelbase_tight_m = 0.25;
  tracks.wheelbase_spin_m = 0.26;
  tracks.x_icr_m = 0.01;
  tracks.turn_slip = 0.01;
  tracks.turn_loss = 0.03;
  tracks.gyro_scale = 1.01;
  return tracks;
}

/// The robot on this course: the tracks that its model needs to keep to the path exactly.
RecordedDrive drive(const course::OtherPath& manoeuvre, const TrackParameters& truth,
                    unsigned seed) {
  constexpr double kStepS = 0.01, kStandstillS = 1.0, kPivotRadps = 0.6;
  constexpr int kStepsPerImage = 3;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  RecordedDrive drive;
  drive.name = manoeuvre.name;
  Pose pose = manoeuvre.start;
  double left_m = 0.0, right_m = 0.0, t_s = 0.0;
  int steps = 0;
  const auto advance = [&](double mps, double radps, double duration_s) {
    double left = mps, right = mps;
    model::Turn turn;
    for (int i = 0; i < 10; ++i) {
      turn = model::turn_of(truth, model::Mode::kExtended, model::turn_shape(left, right));
      left = mps - radps * turn.wheelbase_m / 2.0;
      right = mps + radps * turn.wheelbase_m / 2.0;
    }
    left /= 1.0 - truth.slip_left - turn.slip;
    right /= 1.0 - truth.slip_right - turn.slip;
    const Twist twist = model::body_twist(truth, model::Mode::kExtended, left, right);
    const auto last = static_cast<int>(std::lround(duration_s / kStepS));
    for (int i = 0; i < last; ++i) {
      drive.samples.push_back({t_s, std::lround(left_m * kCountsPerMetre),
                               std::lround(right_m * kCountsPerMetre),
                               twist.yaw_rate_radps / truth.gyro_scale});
      if (steps++ % kStepsPerImage == 0)
        drive.camera.push_back({t_s, pose.x_m + 0.0015 * normal(random),
                                pose.y_m + 0.0015 * normal(random),
                                wrap_angle(pose.yaw_rad + 0.4 * kRadPerDeg * normal(random))});
      model::advance(pose, twist, kStepS);
      left_m += left * kStepS;
      right_m += right * kStepS;
      t_s += kStepS;
    }
  };
  advance(0.0, 0.0, kStandstillS);
  for (const course::Segment& segment : manoeuvre.path) {
    if (const auto* pivot = std::get_if<course::Pivot>(&segment)) {
      advance(0.0, std::copysign(kPivotRadps, pivot->angle_rad),
              std::abs(pivot->angle_rad) / kPivotRadps);
    } else if (const auto* arc = std::get_if<course::Arc>(&segment)) {
      advance(manoeuvre.speed_mps,
              std::copysign(manoeuvre.speed_mps / arc->radius_m, arc->angle_rad),
              arc->radius_m * std::abs(arc->angle_rad) / manoeuvre.speed_mps);
    } else {
      const double length_m = std::get<course::Line>(segment).length_m;
      advance(manoeuvre.speed_mps, 0.0, length_m / manoeuvre.speed_mps);
    }
  }
  advance(0.0, 0.0, kStandstillS);
  return drive;
}

/// Drives until it ends; returns what was chosen.
std::vector<course::OtherPath> drive_all(NextManoeuvre& next, const TrackParameters& truth,
                                         unsigned seed = 1) {
  std::vector<course::OtherPath> chosen;
  while (auto manoeuvre = next.choose()) {
    next.take(drive(*manoeuvre, truth, seed + static_cast<unsigned>(chosen.size())));
    chosen.push_back(std::move(*manoeuvre));
  }
  return chosen;
}

TEST(NextManoeuvre, StopsWhenAllIntervalsAreNarrowAndTheyHoldTheTruth) {
  NextManoeuvre next(nothing_known(), area(1.0));
  const std::vector<course::OtherPath> chosen = drive_all(next, robot());
  const AutoProgress end = next.progress();
  EXPECT_TRUE(end.narrow) << progress_line(end);
  EXPECT_LE(end.half_interval, end.goal);
  EXPECT_EQ(end.manoeuvres, chosen.size());
  EXPECT_LT(end.driving_s, 150.0);
  const Identification found = identify(next.drives(), nothing_known());
  const auto goals = interval_goals(found.prior.tracks, AutoSettings{}.narrow);
  int held = 0;
  for (std::size_t i = 0; i < model::kTrackParameters.size(); ++i) {
    SCOPED_TRACE(model::kTrackParameters[i].key);
    const ParameterEstimate& estimate = found.extended.estimates[i];
    EXPECT_TRUE(estimate.found);
    EXPECT_LE(estimate.half_interval, 1.001 * goals[i]);
    const double truth = robot().*model::kTrackParameters[i].value;
    if (std::abs(estimate.value - truth) <= estimate.half_interval) ++held;
  }
  EXPECT_GE(held, 12);
}

/// Expects that the course of this manoeuvre is not refused, as one that leaves the fence is.
void expect_inside(const NextManoeuvre& next, const course::OtherPath& manoeuvre) {
  const course::TextFile file = next.course_of(manoeuvre);
  EXPECT_NO_THROW(EXPECT_TRUE(course::parse_course(file.text, file.path).identifies))
      << manoeuvre.name;
}

TEST(NextManoeuvre, NeverLeavesTheFence) {
  // Not a rectangle, and with a keep-out area.
  const course::TextFile room{
      "room.toml",
      "[[segment]]\ntype = \"pivot\"\nangle_deg = 90.0\n[fence]\ncorners_m = [[-0.4, -0.4], "
      "[1.2, -0.4], [1.2, 0.3], [0.6, 1.0], [-0.4, 1.0]]\n[[keep_out]]\ncorners_m = [[0.5, -0.1], "
      "[0.7, -0.1], [0.7, 0.1], [0.5, 0.1]]\n"};
  for (unsigned seed = 1; seed <= 3; ++seed) {
    NextManoeuvre next(nothing_known(), room);
    const auto chosen = drive_all(next, robot(), 100 * seed);
    EXPECT_GT(chosen.size(), 3u);
    for (const course::OtherPath& manoeuvre : chosen) expect_inside(next, manoeuvre);
  }
}

TEST(NextManoeuvre, ThePathKeepsToTheFenceFromAnyPlaceNearItsEdge) {
  constexpr double kHalfM = 0.5;
  TrackParameters truth = robot();
  // Its track speeds lag behind the changes of the turn, so that it drives beside the path.
  truth.wheelbase_m = 0.2;
  truth.wheelbase_medium_m = 0.25;
  truth.wheelbase_tight_m = 0.3;
  truth.wheelbase_spin_m = 0.35;
  truth.turn_slip = 0.1;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> from_edge_m(0.0, 0.4), along_m(-kHalfM, kHalfM),
      yaw_rad(-kPi, kPi);
  course::OtherPath arrival;
  arrival.speed_mps = 0.15;
  arrival.path = {course::Line{0.3}, course::Arc{0.3, 1.0}, course::Pivot{1.0}};
  int chosen = 0;
  const SeenPose seen = drive(arrival, truth, 1).camera.back();
  const Pose end{.x_m = seen.x_m, .y_m = seen.y_m, .yaw_rad = seen.yaw_rad};
  for (int i = 0; i < 120; ++i) {
    SCOPED_TRACE(i);
    const Pose there{
        .x_m = along_m(random), .y_m = kHalfM - from_edge_m(random), .yaw_rad = yaw_rad(random)};
    arrival.start = Transform2d::between(end, there).of(Pose{});
    NextManoeuvre next(nothing_known(), area(kHalfM));
    next.take(drive(arrival, truth, 1));
    std::optional<course::OtherPath> manoeuvre;
    try {
      manoeuvre = next.choose();
    } catch (const UserError&) {
      continue;  // nothing fits from there
    }
    if (!manoeuvre) continue;
    ++chosen;
    expect_inside(next, *manoeuvre);
  }
  EXPECT_GT(chosen, 60);
}

/// Metres on lines.
double straight_m(const std::vector<course::OtherPath>& chosen) {
  double sum_m = 0.0;
  for (const course::OtherPath& manoeuvre : chosen)
    for (const course::Segment& segment : manoeuvre.path)
      if (const auto* line = std::get_if<course::Line>(&segment)) sum_m += line->length_m;
  return sum_m;
}

TEST(NextManoeuvre, WhatIsKnownAlreadyIsNotDrivenForAgain) {
  // Straight lines and spins first, more than enough of them.
  NextManoeuvre next(nothing_known(), area(1.5)), fresh(nothing_known(), area(1.5));
  course::OtherPath known;
  known.name = "known";
  known.speed_mps = 0.15;
  for (unsigned i = 0; i < 4; ++i) {
    known.path = {course::Line{1.2}};
    next.take(drive(known, robot(), 10 + i));
    known.path = {course::Pivot{i % 2 == 0 ? 2.0 * kPi : -2.0 * kPi}};
    next.take(drive(known, robot(), 20 + i));
  }
  EXPECT_EQ(straight_m({*next.choose()}), 0.0);
  EXPECT_LT(drive_all(next, robot()).size(), drive_all(fresh, robot()).size());
}

TEST(NextManoeuvre, RefusesAFenceInWhichNothingFitsByName) {
  // The robot stands on something that it may not enter.
  course::TextFile room = area(0.5);
  room.text += "[[keep_out]]\ncorners_m = [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]]\n";
  const std::string why = test::refusal([&] {
    const NextManoeuvre next(nothing_known(), room);
    next.choose();
  });
  EXPECT_THAT(why, HasSubstr("room"));
  EXPECT_THAT(why, HasSubstr("fence"));
}

TEST(NextManoeuvre, EndsWithoutAnAnswerThatTheFenceDoesNotAllow) {
  // Room for turns on the spot only.
  NextManoeuvre next(nothing_known(), area(0.1));
  const auto chosen = drive_all(next, robot());
  const AutoProgress end = next.progress();
  EXPECT_FALSE(end.narrow);
  EXPECT_LT(end.driving_s, 240.0 + 30.0);
  EXPECT_EQ(straight_m(chosen), 0.0);
}

TEST(NextManoeuvre, WithoutACameraEachStartsAtTheMark) {
  AutoSettings by_hand;
  by_hand.camera = false;
  by_hand.max_s = 60.0;
  NextManoeuvre next(nothing_known(), area(1.0), by_hand);
  const double at_first = next.progress().half_interval / next.progress().goal;
  for (unsigned i = 0; i < 4; ++i) {
    auto manoeuvre = next.choose();
    ASSERT_TRUE(manoeuvre);
    EXPECT_EQ(manoeuvre->start.x_m, 0.0);
    EXPECT_EQ(manoeuvre->start.yaw_rad, 0.0);
    RecordedDrive drive = identify::drive(*manoeuvre, robot(), i);
    measure_by_hand(drive);
    next.take(std::move(drive));
  }
  EXPECT_LT(next.progress().half_interval / next.progress().goal, 0.5 * at_first);
  EXPECT_GT(next.progress().driving_s, 4.0);
}

}  // namespace
}  // namespace tp100::identify
