#pragma once
// A recorded drive as input of the model: track speeds in, poses out.

#include <cstddef>
#include <vector>

#include "core/pose.h"
#include "identify/drive.h"
#include "model/model_form.h"

namespace tp100::identify {

class DriveMotion {
 public:
  /// `counts_per_metre` of the tracks; it is known, never fitted. At least two samples.
  DriveMotion(const RecordedDrive& drive, double counts_per_metre);

  /// Poses by dead reckoning in this form at the samples, from the origin heading +x.
  std::vector<Pose> poses(const model::ModelForm& form,
                          const model::TrackParameters& parameters) const {
    std::vector<Pose> all;
    replace_poses(form, parameters, all);
    return all;
  }
  /// The same in place of `all`, whose memory stays: its allocation takes a third of the time.
  void replace_poses(const model::ModelForm& form, const model::TrackParameters& parameters,
                     std::vector<Pose>& all) const;
  /// A time between two samples.
  struct Place {
    std::size_t index;  ///< of the sample before
    double share;       ///< of the interval
  };
  /// The first and the last sample hold outside.
  Place place(double t_s) const;
  /// Between two of `poses`, linear.
  static Pose at(const std::vector<Pose>& poses, const Place& place);
  /// Integral of the gyro minus its bias up to `t_s`, nominal scale. [rad]
  double gyro_rad(double t_s) const;

  double begin_s() const { return times_s_.front(); }
  double end_s() const { return times_s_.back(); }
  /// Time of the tracks' first motion.
  double moves_s() const { return moves_s_; }
  /// Time of their last one.
  double stops_s() const { return stops_s_; }
  /// True if the bias is known: the tracks stood still long enough before it.
  bool has_bias() const { return has_bias_; }
  double left_m() const { return left_m_; }  ///< travel of the left track, forward minus backward
  double right_m() const { return right_m_; }

 private:
  struct Interval {
    double dt_s, left_mps, right_mps;
  };

  std::vector<double> times_s_;
  std::vector<Interval> intervals_;
  std::vector<double> gyro_rad_;  // at the samples
  double moves_s_ = 0.0, stops_s_ = 0.0;
  double left_m_ = 0.0, right_m_ = 0.0;
  bool has_bias_ = false;
};

}  // namespace tp100::identify
