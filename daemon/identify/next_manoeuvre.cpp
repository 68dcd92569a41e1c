#include "identify/next_manoeuvre.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/course.h"
#include "course/path.h"
#include "identify/manoeuvres.h"
#include "model/track_model.h"
#include "text/format.h"

namespace tp100::identify {
namespace {

using course::OtherPath;
using model::kTrackParameters;
using model::TrackParameters;

constexpr std::size_t kRows = kTrackParameters.size();
constexpr auto kSlipLeft = static_cast<Eigen::Index>(model::row_of(&TrackParameters::slip_left));
constexpr auto kSlipRight = static_cast<Eigen::Index>(model::row_of(&TrackParameters::slip_right));

// Fixed cost of each manoeuvre in seconds, so that many short ones are not preferred.
constexpr double kUnderWayS = 1.0;
constexpr int kStepsPerImage = 5;

// The robot keeps this far from the fence, and farther the longer it drives with unknown slip.
constexpr double kMarginM = 0.05;
constexpr double kMaxSlipUnknown = 0.15;
constexpr double kRoomAtTheEndM = 0.2;
constexpr int kAround = 8;
// A gain that is not worth a manoeuvre, in parts of what is missing.
constexpr double kNoGain = 0.02;
constexpr std::size_t kLastImages = 5;

/// The track speeds at which the model moves like that.
TrackSpeeds tracks_of(const TrackParameters& tracks, const MotionStep& step) {
  double slip = 0.0, half_difference_mps = 0.0;
  // The wheelbase depends on the turn, and the turn's shape on the wheelbase.
  for (int i = 0; i < 4; ++i) {
    const model::TurnShape shape =
        model::turn_shape(step.mps - half_difference_mps, step.mps + half_difference_mps);
    const model::Turn turn = model::turn_of(tracks, model::Mode::kExtended, shape);
    half_difference_mps = step.radps * turn.wheelbase_m / 2.0;
    slip = turn.slip;
  }
  return {(step.mps - half_difference_mps) / std::max(1.0 - tracks.slip_left - slip, 0.1),
          (step.mps + half_difference_mps) / std::max(1.0 - tracks.slip_right - slip, 0.1)};
}

/// Whether the fence leaves this much room around a place.
bool clear(const course::Fence& fence, const Pose& at, double margin_m) {
  if (!course::contains(fence, at.x_m, at.y_m)) return false;
  for (int i = 0; i < kAround; ++i) {
    const double to = 2.0 * kPi * i / kAround;
    if (!course::contains(fence, at.x_m + margin_m * std::cos(to),
                          at.y_m + margin_m * std::sin(to)))
      return false;
  }
  return true;
}

/// How far the intervals are from their goals: 0 if all are within.
double excess(const Eigen::VectorXd& half, const std::array<double, kRows>& goals) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kRows; ++i)
    sum += std::log(std::max(1.0, half[static_cast<Eigen::Index>(i)] / goals[i]));
  return sum;
}

}  // namespace

std::array<double, kRows> interval_goals(const TrackParameters& tracks, double narrow) {
  std::array<double, kRows> goals{};
  for (std::size_t i = 0; i < kRows; ++i) {
    const model::ParameterRow& row = kTrackParameters[i];
    goals[i] = narrow * row.useful * (row.relative_to == nullptr ? 1.0 : tracks.*row.relative_to);
  }
  return goals;
}

struct NextManoeuvre::Prediction {
  RecordedDrive drive;
  std::vector<Pose> poses;  // in the fence's frame
  double moving_s;
};

NextManoeuvre::NextManoeuvre(const Prior& base, const course::TextFile& area,
                             const AutoSettings& settings)
    : base_(base),
      area_file_(area),
      area_(course::parse_course(area.text, area.path)),
      settings_(settings),
      fit_(fit_of_all(runs_, base_, settings_.fit)),
      intervals_(fit_.intervals()),
      here_(area_.start) {}

/// How far from the fence a manoeuvre stays.
struct NextManoeuvre::Clearance {
  double margin_m;      // everywhere
  double per_metre;     // farther with each metre driven
  double at_the_end_m;  // so that the next one has room to begin
};

std::optional<OtherPath> NextManoeuvre::choose() const {
  const AutoProgress so_far = progress();
  if (so_far.narrow || so_far.driving_s >= settings_.max_s) return std::nullopt;
  const Eigen::VectorXd half = intervals_.half();
  const double unknown = std::min(kMaxSlipUnknown, std::max(half[kSlipLeft], half[kSlipRight]));
  // It may stay as near to the fence as it is already.
  double margin_m = kMarginM;
  while (margin_m > 0.0 && !clear(area_.fence, here_, margin_m)) margin_m -= kMarginM / 5.0;
  margin_m = std::max(margin_m, 0.0);
  // In a small fence or near its edge, a smaller margin is accepted.
  bool any = false;
  std::optional<OtherPath> best;
  for (const Clearance& clearance : {Clearance{margin_m, unknown, kRoomAtTheEndM},
                                     Clearance{margin_m, unknown, 0.0}, Clearance{0.0, 0.0, 0.0}}) {
    best = best_within(clearance, any);
    if (any) break;
  }
  if (!any)
    throw UserError(text::format(
        "%s: no manoeuvre fits into its fence of %.2f m x %.2f m from (%.2f, %.2f) m; give a "
        "course with a larger fence, or put the robot farther from its edge",
        area_.name.c_str(), area_.fence.max_x_m - area_.fence.min_x_m,
        area_.fence.max_y_m - area_.fence.min_y_m, here_.x_m, here_.y_m));
  if (best) {
    best->description = "identification: " + best->name;
    best->name = text::format("%02zu-", so_far.manoeuvres + 1) + best->name;
  }
  return best;
}

std::optional<OtherPath> NextManoeuvre::best_within(const Clearance& clearance, bool& any) const {
  const TrackParameters& tracks = fit_.values().tracks;
  const std::array<double, kRows> goals = interval_goals(tracks, settings_.narrow);
  // Of Values the rows of the table come first, and all are free.
  const Eigen::VectorXd half = intervals_.half();
  const double now = excess(half, goals);
  std::optional<OtherPath> best;
  double best_rate = 0.0;
  course::Course driven = area_;
  driven.start = here_;
  for (OtherPath& manoeuvre : candidate_manoeuvres(tracks.wheelbase_m)) {
    // The prediction is some millimetres beside its path, and both have to be inside.
    driven.path = manoeuvre.path;
    if (first_point_outside(course::Path(driven), area_.fence)) continue;
    const Prediction prediction = predict(manoeuvre);
    if (!fits(prediction.poses, clearance)) continue;
    any = true;
    const Eigen::VectorXd by = intervals_.narrowed_by(
        fit_.sums_of(FittedRun(prediction.drive, base_.counts_per_metre, tracks.gyro_scale)));
    const double gain = now - excess(half.cwiseQuotient(by), goals);
    const double rate = gain / (prediction.moving_s + kUnderWayS);
    if (gain < kNoGain * now || rate <= best_rate) continue;
    best_rate = rate;
    manoeuvre.start = here_;
    best = std::move(manoeuvre);
  }
  return best;
}

NextManoeuvre::Prediction NextManoeuvre::predict(const OtherPath& manoeuvre) const {
  const TrackParameters& tracks = fit_.values().tracks;
  const ManoeuvreMotion motion(manoeuvre.speed_mps, manoeuvre.path);
  Prediction prediction{.drive = {}, .poses = {}, .moving_s = motion.moving_s()};
  RecordedDrive& drive = prediction.drive;
  const auto counts = [this](double metres) {
    return std::llround(metres * base_.counts_per_metre);
  };
  double left_m = 0.0, right_m = 0.0, t_s = 0.0;
  drive.samples.push_back({});
  for (const MotionStep& step : motion.steps()) {
    const TrackSpeeds speeds = tracks_of(tracks, step);
    left_m += speeds.left_mps * ManoeuvreMotion::kStepS;
    right_m += speeds.right_mps * ManoeuvreMotion::kStepS;
    t_s += ManoeuvreMotion::kStepS;
    drive.samples.push_back({t_s, counts(left_m), counts(right_m), step.radps / tracks.gyro_scale});
  }
  const std::vector<Pose> own =
      DriveMotion(drive, base_.counts_per_metre).poses(model::kExtendedForm, tracks);
  const Transform2d to_fence{here_.x_m, here_.y_m, here_.yaw_rad};
  for (const Pose& pose : own) prediction.poses.push_back(to_fence.of(pose));
  if (settings_.camera) {
    for (std::size_t i = 0; i < own.size(); i += kStepsPerImage) {
      const Pose& at = prediction.poses[i];
      drive.camera.push_back({drive.samples[i].t_s, at.x_m, at.y_m, at.yaw_rad});
    }
  } else {
    const Pose& end = own.back();
    drive.measured.ahead_m = end.x_m;
    drive.measured.left_m = end.y_m;
    drive.measured.turned_rad = end.yaw_rad;
  }
  return prediction;
}

bool NextManoeuvre::fits(const std::vector<Pose>& poses, const Clearance& clearance) const {
  if (!clear(area_.fence, poses.back(), clearance.at_the_end_m)) return false;
  double driven_m = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    driven_m += magnitude(poses[i].x_m - poses[i - 1].x_m, poses[i].y_m - poses[i - 1].y_m);
    if (!clear(area_.fence, poses[i], clearance.margin_m + clearance.per_metre * driven_m))
      return false;
  }
  return true;
}

void NextManoeuvre::take(RecordedDrive drive) {
  FittedRun run = fitted_run(drive, base_);
  driving_s_ += run.motion.stops_s() - run.motion.moves_s();
  runs_.push_back(std::move(run));
  drives_.push_back(std::move(drive));
  fit_ = fit_of_all(runs_, base_, settings_.fit);
  intervals_ = fit_.intervals();
  const std::vector<SeenPose>& seen = drives_.back().camera;
  if (seen.empty()) return;
  here_ = median_of(std::span(seen).last(std::min(seen.size(), kLastImages)));
}

AutoProgress NextManoeuvre::progress() const {
  AutoProgress progress{.manoeuvres = drives_.size(), .driving_s = driving_s_};
  const std::array<double, kRows> goals = interval_goals(fit_.values().tracks, settings_.narrow);
  const Eigen::VectorXd half = intervals_.half();
  double most = 0.0;
  for (std::size_t i = 0; i < kRows; ++i) {
    const double here = half[static_cast<Eigen::Index>(i)];
    if (here / goals[i] <= most) continue;
    most = here / goals[i];
    progress.widest = i;
    progress.half_interval = here;
  }
  progress.goal = goals[progress.widest];
  progress.narrow = progress.half_interval <= progress.goal;
  return progress;
}

TrackParameters NextManoeuvre::tracks() const {
  TrackParameters tracks = fit_.values().tracks;
  for (const model::ParameterRow& row : kTrackParameters)
    tracks.*row.value = std::clamp(tracks.*row.value, row.least * row.si, row.most * row.si);
  return tracks;
}

namespace {

std::string widest(const AutoProgress& progress) {
  const model::ParameterRow& row = kTrackParameters[progress.widest];
  return text::format("%s +- %.4f, goal %.4f", row.key, progress.half_interval / row.si,
                      progress.goal / row.si);
}

}  // namespace

std::string progress_line(const AutoProgress& progress) {
  return text::format("manoeuvre %zu, %.1f s of driving; widest interval: ", progress.manoeuvres,
                      progress.driving_s) +
         widest(progress);
}

std::string end_line(const AutoProgress& progress) {
  const std::string took =
      text::format("%zu manoeuvres, %.1f s of driving", progress.manoeuvres, progress.driving_s);
  if (progress.narrow) return "all intervals are narrow enough after " + took;
  return "not narrow enough after " + took + ": " + widest(progress) +
         "; a larger fence or better measurements would help, or a wider --narrow";
}

}  // namespace tp100::identify
