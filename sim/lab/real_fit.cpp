#include "sim/lab/real_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "core/statistics.h"
#include "identify/least_squares.h"

namespace tp100::sim {
namespace {

using identify::RunSums;
using identify::Summed;

constexpr double kMaxExponent = 30.0;
constexpr double kMinScaleMps = 0.02;  // shorter than the step between measured speeds
constexpr double kFirstSd = 0.05;      // of a residual, before the first rescale()
constexpr double kDifference = 1e-4;   // step of the derivatives, in the unit of each
constexpr int kRounds = 100, kAttempts = 12;
constexpr double kConverged = 1e-9;  // of the cost
constexpr double kUnseen = 0.5;      // as in identify: share of the prior's standard deviation

struct OwnConstant {
  SlipConstant value;
  const char* name;
  double prior_sd;
};
constexpr OwnConstant kOwnConstants[] = {
    {&SlipConstants::turning_centre_left_m, "turning_centre_left_m", 0.1},
    {&SlipConstants::slip_by_difference_spm, "slip_by_difference_spm", 0.5},
    {&SlipConstants::wheelbase_opposed_shift_m, "wheelbase_opposed_shift_m", 0.25},
    {&SlipConstants::break_away_mps, "break_away_mps", 0.3},
    {&SlipConstants::break_away_scale_mps, "break_away_scale_mps", 0.05},
};

const model::ParameterRow* row_of(SlipConstant constant) {
  for (const model::ParameterRow& row : model::kTrackParameters)
    if (static_cast<SlipConstant>(row.value) == constant) return &row;
  return nullptr;
}

double prior_sd(SlipConstant constant, const SlipConstants& start) {
  if (const model::ParameterRow* row = row_of(constant))
    return row->prior_sd * (row->relative_to == nullptr ? 1.0 : start.*row->relative_to);
  return std::find_if(std::begin(kOwnConstants), std::end(kOwnConstants),
                      [&](const OwnConstant& own) { return own.value == constant; })
      ->prior_sd;
}

/// Lever by which an error of the yaw is weighted: half the gauge, at which a track is, or half the
/// mean path of the windows.
double lever_m(const std::vector<RealMotion>& motions, double gauge_m) {
  double path_m = 0.0;
  for (const RealMotion& motion : motions) path_m += motion.path_m;
  return (path_m == 0.0 ? gauge_m : path_m / static_cast<double>(motions.size())) / 2.0;
}

/// Half widths of 95 % intervals of what very many motions would find together, the wider of two:
/// from the weights, and from the contradictions between motions (clustered by motion, each one's
/// score scaled up as if it had been left out; Student's t with as many degrees of freedom as
/// motions that really inform the constant). identify's intervals are for few, long runs.
Eigen::VectorXd half_intervals(const std::vector<RunSums>& sums,
                               const Eigen::MatrixXd& covariance) {
  constexpr double kTail = 0.025;
  const Eigen::Index size = covariance.rows();
  Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(size);
  for (const RunSums& one : sums) {
    const Eigen::MatrixXd others =
        Eigen::MatrixXd::Identity(size, size) - one.information() * covariance;
    const Eigen::VectorXd score = others.lu().solve(one.score());
    scatter += score * score.transpose();
    const Eigen::MatrixXd by_one = covariance * one.information() * covariance;
    shares += by_one.diagonal().cwiseQuotient(covariance.diagonal()).cwiseAbs2();
  }
  const Eigen::MatrixXd clustered = covariance * scatter * covariance;
  Eigen::VectorXd half(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    half[i] = kNormal95 * std::sqrt(covariance(i, i));
    const double informing = shares[i] > 0.0 ? 1.0 / shares[i] : 1.0;
    if (sums.size() < 2 || informing < 1.5 || !std::isfinite(clustered(i, i))) continue;
    const double student = student_t(kTail, std::max(1.0, informing - 1.0));
    half[i] = std::max(half[i], student * std::sqrt(clustered(i, i)));
  }
  return half;
}

class Fitting {
 public:
  Fitting(const SlipForm& form, const std::vector<RealMotion>& motions, double gauge_m,
          const SlipConstants& start)
      : form_(form),
        motions_(motions),
        unit_{1.0, 1.0, lever_m(motions, gauge_m)},
        start_(start),
        at_(start) {}

  void solve() {
    double damping = 1e-3, before = cost(at_);
    for (int round = 0; round < kRounds; ++round) {
      const std::vector<RunSums> sums = linearised();
      const Summed summed = sum(sums);
      const SlipConstants from = at_;
      double now = before;
      for (int attempt = 0; attempt < kAttempts; ++attempt, damping *= 4.0) {
        at_ = stepped(from, summed.step(damping));
        now = cost(at_);
        if (now < before) break;
        at_ = from;
      }
      damping = std::max(damping / 10.0, 1e-9);
      if (!(before - now > kConverged * before)) break;
      before = now;
    }
  }

  /// Weights the residuals by their scatter, which has the model's error as well as noise.
  void rescale() {
    const auto residuals = static_cast<double>(3 * motions_.size());
    sd_ = std::sqrt(squares(at_) / residuals);
  }

  SlipFit result() const {
    SlipFit fit{.constants = at_, .fitted = {}};
    const std::vector<RunSums> sums = linearised();
    const Summed summed = sum(sums);
    const Eigen::VectorXd half = half_intervals(sums, summed.covariance());
    for (Eigen::Index k = 0; k < size(); ++k) {
      const double unseen = kNormal95 * kUnseen * prior_sd(constant(k), start_);
      fit.fitted.push_back({constant(k), half[k], half[k] < unseen});
    }
    return fit;
  }

 private:
  Eigen::Index size() const { return static_cast<Eigen::Index>(form_.free.size()); }
  SlipConstant constant(Eigen::Index k) const { return form_.free[static_cast<std::size_t>(k)]; }

  SlipConstants stepped(SlipConstants constants, const Eigen::VectorXd& step) const {
    for (Eigen::Index k = 0; k < size(); ++k) constants.*constant(k) += step[k];
    return constants;
  }

  double squares(const SlipConstants& constants) const {
    double sum = 0.0;
    for (const RealMotion& motion : motions_) {
      const std::array<double, 3> here = predicted(constants, form_, motion);
      for (std::size_t i = 0; i < here.size(); ++i)
        sum += std::pow((motion.truth[i] - here[i]) * unit_[i], 2);
    }
    return sum;
  }

  double cost(const SlipConstants& constants) const {
    double sum = squares(constants) / (sd_ * sd_);
    for (const SlipConstant c : form_.free)
      sum += std::pow((constants.*c - start_.*c) / prior_sd(c, start_), 2);
    return sum;
  }

  std::vector<RunSums> linearised() const {
    std::vector<RunSums> sums;
    for (const RealMotion& motion : motions_) {
      const std::array<double, 3> here = predicted(at_, form_, motion);
      std::array<Eigen::VectorXd, 3> by;
      by.fill(Eigen::VectorXd(size()));
      for (Eigen::Index k = 0; k < size(); ++k) {
        SlipConstants changed = at_;
        changed.*constant(k) += kDifference;
        const std::array<double, 3> there = predicted(changed, form_, motion);
        for (std::size_t i = 0; i < by.size(); ++i) by[i][k] = (there[i] - here[i]) / kDifference;
      }
      // A motion begins at its true pose: it has no parameters of its own to fit.
      RunSums& of_motion = sums.emplace_back(size(), 1);
      for (std::size_t i = 0; i < by.size(); ++i)
        of_motion.add(by[i], Eigen::VectorXd::Zero(1), motion.truth[i] - here[i],
                      std::pow(unit_[i] / sd_, 2));
      of_motion.eliminate();
    }
    return sums;
  }

  Summed sum(const std::vector<RunSums>& sums) const {
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size(), size());
    Eigen::VectorXd score(size());
    for (Eigen::Index k = 0; k < size(); ++k) {
      const SlipConstant c = constant(k);
      information(k, k) = std::pow(prior_sd(c, start_), -2);
      score[k] = (start_.*c - at_.*c) * information(k, k);
    }
    return {sums, {information, score}};
  }

  const SlipForm& form_;
  const std::vector<RealMotion>& motions_;
  std::array<double, 3> unit_;
  SlipConstants start_, at_;
  double sd_ = kFirstSd;
};

}  // namespace

std::string name_of(SlipConstant constant) {
  for (const OwnConstant& own : kOwnConstants)
    if (own.value == constant) return own.name;
  const std::string key = row_of(constant)->key;
  return key.ends_with("_deg") ? key.substr(0, key.size() - 3) + "rad" : key;
}

Twist twist_of(const SlipConstants& constants, const SlipForm& form, const SensedSpeeds& speeds) {
  const double difference_mps = speeds.right_mps - speeds.left_mps;
  model::TrackParameters tracks = constants;
  if (speeds.left_mps * speeds.right_mps < 0.0)
    tracks.wheelbase_m += constants.wheelbase_opposed_shift_m;
  Twist twist = model::body_twist(tracks, form.mode, speeds.left_mps, speeds.right_mps);
  twist.vx_mps *= 1.0 - constants.slip_by_difference_spm * std::abs(difference_mps);
  const double exponent = (-difference_mps - constants.break_away_mps) /
                          std::max(constants.break_away_scale_mps, kMinScaleMps);
  const double lost_radps = std::exp(std::min(exponent, kMaxExponent));
  twist.yaw_rate_radps += lost_radps;
  if (form.mode == model::Mode::kExtended) twist.vy_mps -= tracks.x_icr_m * lost_radps;
  if (form.gyro) twist.yaw_rate_radps = speeds.gyro_radps;
  twist.vx_mps -= constants.turning_centre_left_m * twist.yaw_rate_radps;
  return twist;
}

std::array<double, 3> predicted(const SlipConstants& constants, const SlipForm& form,
                                const RealMotion& motion) {
  if (motion.dt_s == 0.0) {
    const Twist twist = twist_of(constants, form, motion.speeds.front());
    return {twist.vx_mps, twist.vy_mps, twist.yaw_rate_radps};
  }
  Pose pose;
  for (const SensedSpeeds& speeds : motion.speeds)
    model::advance(pose, twist_of(constants, form, speeds), motion.dt_s);
  return {pose.x_m, pose.y_m, pose.yaw_rad};
}

SlipFit fit(const SlipForm& form, const std::vector<RealMotion>& motions, double gauge_m,
            const SlipConstants& start) {
  if (form.free.empty()) return {.constants = start, .fitted = {}};
  Fitting fitting(form, motions, gauge_m, start);
  fitting.solve();
  fitting.rescale();
  fitting.solve();
  return fitting.result();
}

}  // namespace tp100::sim
