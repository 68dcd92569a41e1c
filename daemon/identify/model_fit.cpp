#include "identify/model_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "core/statistics.h"

namespace tp100::identify {
namespace {

using model::kTrackParameters;
using model::TrackParameters;

struct Scale {
  double prior_sd;  // around the assumed value: wider than for any robot
  double useful;    // a harmless error
};
constexpr Scale kDelayScale = {0.02, 0.02};
Scale scale_of(std::size_t i) {
  if (i == kDelay) return kDelayScale;
  return {kTrackParameters[i].prior_sd, kTrackParameters[i].useful};
}
// Step of the derivatives, in the unit of each.
constexpr double kDifference = 1e-4;

constexpr int kRounds = 60;
constexpr int kRoundsBeforeRejecting = 4;
constexpr int kAttempts = 12;
constexpr double kConverged = 1e-5;  // of a useful accuracy
constexpr double kReject = 6.0;
constexpr double kNoDirectionM = 0.05;  // a shorter distance between start and end has no direction
// Medians of a normal distribution's absolute value in two dimensions and in one.
constexpr double kMedianOfTwo = 1.1774, kMedianOfOne = 0.6745;
// Relative to the largest component of a confused direction: smaller ones are not named.
constexpr double kPart = 0.25;

constexpr std::size_t kGyroScale = model::row_of(&TrackParameters::gyro_scale);

/// The parameter near which this one is expected, if it is not itself.
model::TrackParameter neighbour(std::size_t i) {
  if (i == kDelay || kTrackParameters[i].relative_to == kTrackParameters[i].value) return nullptr;
  return kTrackParameters[i].relative_to;
}

bool false_detection(const FittedRun& run, const Residual& off) {
  return off.off_m() > kReject * run.usual_m || off.off_rad() > kReject * run.usual_rad;
}

}  // namespace

ModelFit::ModelFit(const model::ModelForm& form, std::vector<FittedRun> runs, const Values& start,
                   const Values& prior, const Free& free, const IdentifySettings& settings)
    : form_(&form),
      runs_(std::move(runs)),
      values_(start),
      prior_(prior),
      settings_(settings),
      correlated_s_(settings.correlated_s),
      sd_m_(settings.camera_sd_m),
      sd_rad_(settings.camera_sd_rad),
      sd_gyro_rad_(settings.camera_sd_rad) {
  for (std::size_t i = 0; i < kShared; ++i)
    if (free[i]) free_.push_back(i);
}

double ModelFit::prior_sd(std::size_t i) const {
  const model::TrackParameter unit = i == kDelay ? nullptr : kTrackParameters[i].relative_to;
  return scale_of(i).prior_sd * (unit == nullptr ? 1.0 : prior_.tracks.*unit);
}

double ModelFit::prior_off(std::size_t i) const {
  const model::TrackParameter near = neighbour(i);
  return (near == nullptr ? prior_[i] : values_.tracks.*near) - values_[i];
}

double ModelFit::useful(std::size_t i) const {
  const Scale scale = scale_of(i);
  return scale.useful * prior_sd(i) / scale.prior_sd;
}

PriorSums ModelFit::prior() const {
  PriorSums sums{Eigen::MatrixXd::Zero(size(), size()), Eigen::VectorXd::Zero(size())};
  for (Eigen::Index k = 0; k < size(); ++k) {
    const std::size_t i = shared_index(k);
    const double weight = 1.0 / (prior_sd(i) * prior_sd(i));
    const model::TrackParameter near = neighbour(i);
    const double off = prior_off(i);
    sums.information(k, k) += weight;
    sums.score[k] += weight * off;
    for (Eigen::Index j = 0; near != nullptr && j < size(); ++j) {
      if (shared_index(j) != model::row_of(near)) continue;
      sums.information(j, j) += weight;
      sums.information(j, k) -= weight;
      sums.information(k, j) -= weight;
      sums.score[j] -= weight * off;
    }
  }
  return sums;
}

double ModelFit::cost() const {
  double cost = linearise(nullptr);
  for (const std::size_t i : free_) cost += std::pow(prior_off(i) / prior_sd(i), 2);
  return cost;
}

// poses[0] belongs to the present values, poses[k + 1] to a change of the k-th free one.
double ModelFit::take_images(const FittedRun& run, const Poses& poses, RunSums* sums) const {
  const double together = std::max(1.0, run.images_per_s * correlated_s_);
  const double gyro_scale = values_.tracks.gyro_scale;
  const double turned_x = std::cos(run.own[2]), turned_y = std::sin(run.own[2]);
  double cost = 0.0;
  Eigen::VectorXd by_x(size()), by_y(size()), by_yaw(size()), by_gyro(size());
  for (const SeenPose& seen : run.images) {
    const double t_s = seen.t_s - values_.delay_s;
    const DriveMotion::Place now = run.motion.place(t_s);
    const DriveMotion::Place before = run.motion.place(t_s - kDifference);
    const Pose driven = DriveMotion::at(poses[0], now), here = run.predicted(driven);
    const Residual off = FittedRun::residual(seen, here);
    const double turned = run.motion.gyro_rad(t_s);
    const double gyro = seen.yaw_rad - (run.own[3] + gyro_scale * turned);
    const double off_m = off.off_m() / sd_m_, off_rad = off.off_rad() / sd_rad_;
    const double off_gyro = run.motion.has_bias() ? std::abs(gyro) / sd_gyro_rad_ : 0.0;
    if (rejecting_ && false_detection(run, off)) {
      cost += huber_cost(kReject) / together;
      continue;
    }
    cost += (huber_cost(off_m) + huber_cost(off_rad) + huber_cost(off_gyro)) / together;
    if (sums == nullptr) continue;
    by_gyro.setZero();
    for (Eigen::Index k = 0; k < size(); ++k) {
      const std::size_t i = shared_index(k);
      const bool delay = i == kDelay;
      const Pose there = delay ? DriveMotion::at(poses[0], before)
                               : DriveMotion::at(poses[static_cast<std::size_t>(k) + 1], now);
      const double dx_m = there.x_m - driven.x_m, dy_m = there.y_m - driven.y_m;
      by_x[k] = (turned_x * dx_m - turned_y * dy_m) / kDifference;
      by_y[k] = (turned_y * dx_m + turned_x * dy_m) / kDifference;
      by_yaw[k] = (there.yaw_rad - driven.yaw_rad) / kDifference;
      if (i == kGyroScale) by_gyro[k] = turned;
      if (delay)
        by_gyro[k] = gyro_scale * (run.motion.gyro_rad(t_s - kDifference) - turned) / kDifference;
    }
    const double weight_m = huber_weight(off_m) / (sd_m_ * sd_m_ * together);
    const double weight_rad = huber_weight(off_rad) / (sd_rad_ * sd_rad_ * together);
    sums->add(by_x, Eigen::Vector4d(1.0, 0.0, run.own[1] - here.y_m, 0.0), off.x_m, weight_m);
    sums->add(by_y, Eigen::Vector4d(0.0, 1.0, here.x_m - run.own[0], 0.0), off.y_m, weight_m);
    sums->add(by_yaw, Eigen::Vector4d(0.0, 0.0, 1.0, 0.0), off.yaw_rad, weight_rad);
    if (!run.motion.has_bias()) continue;
    const double weight_gyro = huber_weight(off_gyro) / (sd_gyro_rad_ * sd_gyro_rad_ * together);
    sums->add(by_gyro, Eigen::Vector4d(0.0, 0.0, 0.0, 1.0), gyro, weight_gyro);
  }
  return cost;
}

double ModelFit::take_measured(const FittedRun& run, const Poses& poses, RunSums* sums) const {
  double cost = 0.0;
  Eigen::VectorXd by(size());
  const auto take = [&](double measured, double sd, const auto& of) {
    const double here = of(poses[0].back());
    const double off = measured - here;
    cost += off * off / (sd * sd);
    if (sums == nullptr) return;
    for (Eigen::Index k = 0; k < size(); ++k)
      by[k] = (of(poses[static_cast<std::size_t>(k) + 1].back()) - here) / kDifference;
    sums->add(by, Eigen::VectorXd::Zero(FittedRun::kOwn), off, 1.0 / (sd * sd));
  };
  const HandMeasured& m = run.measured;
  const double tape = settings_.tape_sd_m, protractor = settings_.protractor_sd_rad;
  if (m.distance_m && *m.distance_m > kNoDirectionM)
    take(*m.distance_m, tape, [](const Pose& end) { return magnitude(end.x_m, end.y_m); });
  if (m.ahead_m) take(*m.ahead_m, tape, [](const Pose& end) { return end.x_m; });
  if (m.left_m) take(*m.left_m, tape, [](const Pose& end) { return end.y_m; });
  if (!m.turned_rad) return cost;
  take(*m.turned_rad, protractor, [](const Pose& end) { return end.yaw_rad; });
  if (!run.motion.has_bias()) return cost;
  const double turned = run.motion.gyro_rad(run.motion.end_s());
  const double off = *m.turned_rad - values_.tracks.gyro_scale * turned;
  cost += off * off / (protractor * protractor);
  if (sums == nullptr) return cost;
  for (Eigen::Index k = 0; k < size(); ++k) by[k] = shared_index(k) == kGyroScale ? turned : 0.0;
  sums->add(by, Eigen::VectorXd::Zero(FittedRun::kOwn), off, 1.0 / (protractor * protractor));
  return cost;
}

double ModelFit::linearise(const FittedRun& run, RunSums* sums) const {
  Poses& poses = kept_poses_;
  poses.resize(free_.size() + 1);
  run.motion.replace_poses(*form_, values_.tracks, poses[0]);
  for (std::size_t k = 0; sums != nullptr && k < free_.size(); ++k) {
    Values changed = values_;
    changed[free_[k]] += kDifference;
    if (free_[k] != kDelay && (free_[k] != kGyroScale || form_->yaw_from_gyro))
      run.motion.replace_poses(*form_, changed.tracks, poses[k + 1]);
    else
      poses[k + 1] = poses[0];
  }
  const double cost = take_images(run, poses, sums) + take_measured(run, poses, sums);
  if (sums != nullptr) sums->eliminate();
  return cost;
}

double ModelFit::linearise(std::vector<RunSums>* sums) const {
  double cost = 0.0;
  if (sums != nullptr) sums->clear();
  for (const FittedRun& run : runs_)
    cost +=
        linearise(run, sums == nullptr ? nullptr : &sums->emplace_back(size(), FittedRun::kOwn));
  return cost;
}

void ModelFit::rescale() {
  std::vector<double> off_m, off_rad, off_gyro;
  for (FittedRun& run : runs_) {
    std::vector<double> run_m, run_rad;
    const std::vector<Pose> poses = this->poses(run, values_);
    for (const SeenPose& seen : run.images) {
      const Residual off = run.residual(poses, seen, values_.delay_s);
      run_m.push_back(off.off_m());
      run_rad.push_back(off.off_rad());
      off_gyro.push_back(
          std::abs(seen.yaw_rad - run.own[3] -
                   values_.tracks.gyro_scale * run.motion.gyro_rad(seen.t_s - values_.delay_s)));
    }
    off_m.insert(off_m.end(), run_m.begin(), run_m.end());
    off_rad.insert(off_rad.end(), run_rad.begin(), run_rad.end());
    run.usual_m = std::max(settings_.camera_sd_m, median(std::move(run_m)) / kMedianOfTwo);
    run.usual_rad = std::max(settings_.camera_sd_rad, median(std::move(run_rad)) / kMedianOfOne);
  }
  sd_m_ = std::max(settings_.camera_sd_m, median(std::move(off_m)) / kMedianOfTwo);
  sd_rad_ = std::max(settings_.camera_sd_rad, median(std::move(off_rad)) / kMedianOfOne);
  sd_gyro_rad_ = std::max(settings_.camera_sd_rad, median(std::move(off_gyro)) / kMedianOfOne);
}

// Effects outside the model, such as a worn stretch of a track, shift all images of some seconds
// together.
void ModelFit::correlate() {
  for (const FittedRun& run : runs_) {
    const std::vector<Pose> poses = this->poses(run, values_);
    std::vector<double> x, y, yaw;
    for (const SeenPose& seen : run.images) {
      const Residual off = run.residual(poses, seen, values_.delay_s);
      if (false_detection(run, off)) continue;
      x.push_back(off.x_m);
      y.push_back(off.y_m);
      yaw.push_back(off.yaw_rad);
    }
    for (const std::vector<double>* residuals : {&x, &y, &yaw})
      correlated_s_ = std::max(correlated_s_, samples_together(*residuals) / run.images_per_s);
  }
}

bool ModelFit::improve(double& damping, double& moved) {
  const double before = cost();
  linearise(&sums_);
  const Summed sums(sums_, prior());
  const Values values = values_;
  const std::vector<FittedRun::Own> own = [this] {
    std::vector<FittedRun::Own> all;
    for (const FittedRun& run : runs_) all.push_back(run.own);
    return all;
  }();
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Eigen::VectorXd step = sums.step(damping);
    moved = 0.0;
    for (Eigen::Index k = 0; k < size(); ++k) {
      const std::size_t i = shared_index(k);
      values_[i] = values[i] + step[k];
      moved = std::max(moved, std::abs(step[k]) / scale_of(i).useful);
    }
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      const Eigen::VectorXd own_step = sums_[r].own_step(step);
      for (std::size_t j = 0; j < FittedRun::kOwn; ++j)
        runs_[r].own[j] = own[r][j] + own_step[static_cast<Eigen::Index>(j)];
    }
    const auto possible_wheelbase = [&](const model::ParameterRow& row) {
      return row.relative_to == nullptr || values_.tracks.*row.value >= 0.0;
    };
    const bool possible = values_.tracks.wheelbase_m > 0.01 &&
                          std::ranges::all_of(kTrackParameters, possible_wheelbase);
    if (possible && cost() <= before) {
      damping = std::max(damping / 10.0, 1e-9);
      return true;
    }
    damping *= 10.0;
  }
  values_ = values;
  for (std::size_t r = 0; r < runs_.size(); ++r) runs_[r].own = own[r];
  return false;
}

void ModelFit::solve() {
  double damping = 1e-4;
  for (int round = 0; round < kRounds; ++round) {
    rejecting_ = round >= kRoundsBeforeRejecting;
    rescale();
    double moved = 0.0;
    const bool better = improve(damping, moved);
    if (round > kRoundsBeforeRejecting && (!better || moved < kConverged)) break;
    if (!better) damping = 1e-4;
  }
  rescale();
  correlate();
  linearise(&sums_);
}

std::array<double, kShared> ModelFit::uncertainty_left() const {
  std::array<double, kShared> left{};
  const Summed sums(sums_, prior());
  for (Eigen::Index k = 0; k < size(); ++k)
    left[shared_index(k)] = std::sqrt(sums.covariance()(k, k)) / prior_sd(shared_index(k));
  return left;
}

Intervals ModelFit::intervals() const {
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(size());
  for (Eigen::Index k = 0; k < size(); ++k)
    if (shared_index(k) != kDelay && shared_index(k) != kGyroScale)
      unit[k] = useful(shared_index(k));
  return {sums_, prior(), unit};
}

RunSums ModelFit::sums_of(const FittedRun& run) const {
  RunSums sums(size(), FittedRun::kOwn);
  linearise(run, &sums);
  return sums;
}

void ModelFit::find_confused(Fit& fit, const Summed& sums) const {
  Eigen::VectorXd useful(size());
  for (Eigen::Index k = 0; k < size(); ++k) useful[k] = this->useful(shared_index(k));
  const Eigen::VectorXd inverse = useful.cwiseInverse();
  const Eigen::MatrixXd scaled = inverse.asDiagonal() * sums.covariance() * inverse.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
  for (Eigen::Index e = 0; e < size(); ++e) {
    // In this direction the runs do not reach useful accuracy.
    if (solver.eigenvalues()[e] < 1.0) continue;
    std::vector<std::pair<double, std::size_t>> parts;
    for (Eigen::Index k = 0; k < size(); ++k) {
      if (shared_index(k) == kDelay) continue;
      parts.emplace_back(std::abs(solver.eigenvectors()(k, e)), shared_index(k));
    }
    std::sort(parts.rbegin(), parts.rend());
    if (parts.size() < 2 || parts[1].first < kPart * parts[0].first) continue;
    const auto [a, b] = std::minmax(parts[0].second, parts[1].second);
    fit.confused.emplace_back(a, b);
  }
}

void ModelFit::describe_runs(Fit& fit) const {
  double squares = 0.0, squares_rad = 0.0;
  std::size_t images = 0;
  for (const FittedRun& run : runs_) {
    RunFit& of = fit.runs.emplace_back();
    of.name = run.name;
    const std::vector<Pose> poses = this->poses(run, values_);
    const Pose& end = poses.back();
    if (const auto& by_hand = run.measured.distance_m)
      of.distance_off_m = *by_hand - magnitude(end.x_m, end.y_m);
    if (const auto& by_hand = run.measured.turned_rad) of.turned_off_rad = *by_hand - end.yaw_rad;
    double run_squares = 0.0, run_squares_rad = 0.0;
    for (const SeenPose& seen : run.images) {
      const Residual off = run.residual(poses, seen, values_.delay_s);
      if (false_detection(run, off)) {
        ++of.rejected;
        continue;
      }
      ++of.images;
      run_squares += off.off_m() * off.off_m();
      run_squares_rad += off.yaw_rad * off.yaw_rad;
      of.max_m = std::max(of.max_m, off.off_m());
    }
    const auto count = static_cast<double>(std::max<std::size_t>(of.images, 1));
    of.rms_m = std::sqrt(run_squares / count);
    of.rms_rad = std::sqrt(run_squares_rad / count);
    squares += run_squares;
    squares_rad += run_squares_rad;
    images += of.images;
    fit.max_m = std::max(fit.max_m, of.max_m);
  }
  const auto count = static_cast<double>(std::max<std::size_t>(images, 1));
  fit.rms_m = std::sqrt(squares / count);
  fit.rms_rad = std::sqrt(squares_rad / count);
}

Fit ModelFit::fit() const {
  Fit fit;
  const Summed sums(sums_, prior());
  fit.condition = sums.condition();
  fit.camera_late_s = values_.delay_s;
  for (std::size_t i = 0; i < kTrackParameters.size(); ++i) fit.estimates[i].value = values_[i];
  const Eigen::VectorXd half = intervals().half();
  for (Eigen::Index k = 0; k < size(); ++k) {
    const std::size_t i = shared_index(k);
    if (i < kTrackParameters.size()) fit.estimates[i] = {values_[i], half[k], true};
  }
  find_confused(fit, sums);
  describe_runs(fit);
  return fit;
}

}  // namespace tp100::identify
