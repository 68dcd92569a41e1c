#pragma once
// The best fit of the model to several runs: robust batch least squares (Levenberg-Marquardt, Huber
// weights, far outliers left out) of pictures minus predicted poses.

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "identify/fitted_run.h"
#include "identify/least_squares.h"
#include "identify/parameter.h"

namespace tp100::identify {

/// Noise of what the runs are compared with. The camera's own residuals widen the first two.
struct IdentifySettings {
  double camera_sd_m = 0.002;
  double camera_sd_rad = 0.5 * kRadPerDeg;
  double correlated_s = 1.0;  ///< camera residuals within this time count as one, or within the
                              ///< time in which they turn out to hang together, if that is longer
  double tape_sd_m = 0.002;
  double protractor_sd_rad = 1.0 * kRadPerDeg;
};

/// One parameter. SI units.
struct Estimate {
  double value = 0.0;
  double half_interval = 0.0;  ///< of the 95 % interval, to either side
  bool found = false;          ///< false: the runs do not say; `value` is what was believed before
};

/// How well the fitted model repeats a run.
struct RunFit {
  std::string name;
  std::size_t pictures = 0;                        ///< that count
  std::size_t rejected = 0;                        ///< far from everything: false detections
  double rms_m = 0.0, max_m = 0.0, rms_rad = 0.0;  ///< against the camera, its noise included
};

/// The best fit of one form of the model.
struct Fit {
  std::array<Estimate, kParameters> estimates{};
  std::vector<RunFit> runs;
  double rms_m = 0.0, max_m = 0.0, rms_rad = 0.0;  ///< over all runs
  double condition = 0.0;                          ///< of the scaled Jacobian; 1 is best
  double camera_late_s = 0.0;                      ///< of the camera's time stamps
  /// Pairs that the runs cannot separate: both may change together without a trace.
  std::vector<std::pair<Parameter, Parameter>> confused;
  const Estimate& operator[](Parameter p) const { return estimates[index(p)]; }
};

/// Unknowns that all runs share: the parameters, then how late the camera's time stamps are.
inline constexpr std::size_t kDelay = kParameters;
inline constexpr std::size_t kShared = kParameters + 1;
using Values = std::array<double, kShared>;
using Free = std::array<bool, kShared>;

class ModelFit {
 public:
  /// Looks for the `free` ones of `start`; the others stay. `believed` is what a weak prior pulls
  /// to. `settings` must outlive it.
  ModelFit(std::vector<FittedRun> runs, const Values& start, const Values& believed,
           const Free& free, double turning_threshold_radps, const IdentifySettings& settings);

  void solve();
  const Values& values() const { return values_; }
  /// Standard deviation after the runs in parts of the one before; 0 of what was not free.
  std::array<double, kShared> uncertainty_left() const;
  Fit fit() const;

 private:
  using Poses = std::vector<std::vector<Pose>>;

  Eigen::Index size() const { return static_cast<Eigen::Index>(free_.size()); }
  std::size_t shared_index(Eigen::Index k) const { return free_[static_cast<std::size_t>(k)]; }
  double prior_sd(std::size_t i) const;
  model::TrackParameters tracks(const Values& values) const;
  double prior(Eigen::MatrixXd& information, Eigen::VectorXd& score) const;
  Summed sum() const;
  double cost() const;
  double linearise(std::vector<RunSums>* sums) const;
  double take_pictures(const FittedRun& run, const Poses& poses, RunSums* sums) const;
  double take_measured(const FittedRun& run, const Poses& poses, RunSums* sums) const;
  bool improve(double& damping, double& moved);
  void rescale();
  void correlate();
  void find_confused(Fit& fit, const Summed& sums) const;
  void describe_runs(Fit& fit) const;

  std::vector<FittedRun> runs_;
  Values values_, believed_;
  std::vector<std::size_t> free_;  // indices
  double threshold_radps_;
  const IdentifySettings& settings_;
  std::vector<RunSums> sums_;
  double correlated_s_;
  double sd_m_ = 1.0, sd_rad_ = 1.0, sd_gyro_rad_ = 1.0;
  bool rejecting_ = false;
};

}  // namespace tp100::identify
