#pragma once
// The best fit of a form of the model to several runs: robust batch least squares
// (Levenberg-Marquardt, Huber weights, far outliers excluded) of images minus predicted poses.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "identify/fitted_run.h"
#include "identify/least_squares.h"
#include "model/model_form.h"
#include "model/track_parameters.h"

namespace tp100::identify {

/// Noise of the reference measurements. The camera's own residuals widen the first two.
struct IdentifySettings {
  double camera_sd_m = 0.002;
  double camera_sd_rad = 0.5 * kRadPerDeg;
  double correlated_s = 0.1;  ///< camera residuals within this time count as one, or within their
                              ///< correlation time if that is longer
  double tape_sd_m = 0.002;
  double protractor_sd_rad = 1.0 * kRadPerDeg;
};

/// One parameter. SI units.
struct ParameterEstimate {
  double value = 0.0;
  double half_interval = 0.0;  ///< of the 95 % interval, to either side
  bool found = false;          ///< false: the runs do not determine it; `value` is the previous one
};

/// How well the fitted model reproduces a run.
struct RunFit {
  std::string name;
  std::size_t images = 0;                          ///< images used
  std::size_t rejected = 0;                        ///< false detections, far from all predictions
  double rms_m = 0.0, max_m = 0.0, rms_rad = 0.0;  ///< against the camera, its noise included
  std::optional<double> distance_off_m, turned_off_rad;  ///< measured by hand - predicted
};

/// The best fit of one form of the model.
struct Fit {
  std::array<ParameterEstimate, model::kTrackParameters.size()> estimates{};  ///< as in the table
  std::vector<RunFit> runs;
  double rms_m = 0.0, max_m = 0.0, rms_rad = 0.0;  ///< over all runs
  double condition = 0.0;                          ///< of the scaled Jacobian; 1 is best
  double camera_late_s = 0.0;                      ///< of the camera's time stamps
  /// Pairs that the runs cannot separate: both may change together without an effect on the
  /// residuals. Rows of the table, ascending.
  std::vector<std::pair<std::size_t, std::size_t>> confused;
  const ParameterEstimate& operator[](model::TrackParameter p) const {
    return estimates[model::row_of(p)];
  }
};

/// Unknowns shared by all runs: the parameters in the order of their table, then the delay of the
/// camera's time stamps.
inline constexpr std::size_t kDelay = model::kTrackParameters.size();
inline constexpr std::size_t kShared = kDelay + 1;
struct Values {
  model::TrackParameters tracks{};
  double delay_s = 0.0;
  double& operator[](std::size_t i) {
    return i == kDelay ? delay_s : tracks.*model::kTrackParameters[i].value;
  }
  double operator[](std::size_t i) const {
    return i == kDelay ? delay_s : tracks.*model::kTrackParameters[i].value;
  }
};
using Free = std::array<bool, kShared>;

class ModelFit {
 public:
  /// Fits the `free` parameters of `start`; the others stay. `prior` is the centre of a weak prior.
  /// `form` must outlive it.
  ModelFit(const model::ModelForm& form, std::vector<FittedRun> runs, const Values& start,
           const Values& prior, const Free& free, const IdentifySettings& settings);

  void solve();
  const Values& values() const { return values_; }
  /// Standard deviation after the runs relative to the prior's; 0 for parameters that were not
  /// free.
  std::array<double, kShared> uncertainty_left() const;
  Fit fit() const;

  /// Of the free ones, in the order of Values.
  Intervals intervals() const;
  /// What this run would say, with the present values and noise.
  RunSums sums_of(const FittedRun& run) const;

 private:
  using Poses = std::vector<std::vector<Pose>>;

  Eigen::Index size() const { return static_cast<Eigen::Index>(free_.size()); }
  std::size_t shared_index(Eigen::Index k) const { return free_[static_cast<std::size_t>(k)]; }
  double prior_sd(std::size_t i) const;
  double prior_off(std::size_t i) const;
  double useful(std::size_t i) const;
  PriorSums prior() const;
  std::vector<Pose> poses(const FittedRun& run, const Values& values) const {
    return run.motion.poses(*form_, values.tracks);
  }
  double cost() const;
  double linearise(std::vector<RunSums>* sums) const;
  double linearise(const FittedRun& run, RunSums* sums) const;
  double take_images(const FittedRun& run, const Poses& poses, RunSums* sums) const;
  double take_measured(const FittedRun& run, const Poses& poses, RunSums* sums) const;
  bool improve(double& damping, double& moved);
  void rescale();
  void correlate();
  void find_confused(Fit& fit, const Summed& sums) const;
  void describe_runs(Fit& fit) const;

  const model::ModelForm* form_;
  std::vector<FittedRun> runs_;
  Values values_, prior_;
  std::vector<std::size_t> free_;  // indices
  IdentifySettings settings_;
  std::vector<RunSums> sums_;
  double correlated_s_;
  double sd_m_, sd_rad_, sd_gyro_rad_;
  bool rejecting_ = false;
  mutable Poses kept_poses_;  // of linearise(), which would allocate them anew in each call
};

}  // namespace tp100::identify
