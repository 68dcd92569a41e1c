#include "model/model_form.h"

namespace tp100::model {

TrackParameters ModelForm::only(TrackParameters parameters) const {
  for (std::size_t i = 0; i < kTrackParameters.size(); ++i) {
    const TrackParameter value = kTrackParameters[i].value;
    const bool has_no_zero =
        value == &TrackParameters::wheelbase_m || value == &TrackParameters::gyro_scale;
    if (!fitted[i] && !has_no_zero) parameters.*value = 0.0;
  }
  return parameters;
}

TrackParameters without_slip(double gauge_m) {
  TrackParameters parameters = ModelForm{}.only({});
  parameters.wheelbase_m = gauge_m;
  return parameters;
}

TrackParameters as_printed(double /*gauge_m*/) { return {}; }

DeadReckoning::DeadReckoning(const ModelForm& form, const TrackParameters& parameters,
                             const Pose& start, double turn_lag_s)
    : parameters_([&] {
        TrackParameters own = parameters;
        if (form.one_slip) own.slip_right = own.slip_left;
        return own;
      }()),
      yaw_from_gyro_(form.yaw_from_gyro),
      tracks_(parameters_, Mode::kExtended, turn_lag_s),
      pose_(start) {
  tracks_.begin(start);
}

void DeadReckoning::advance(double left_mps, double right_mps, double gyro_radps, double dt_s) {
  if (!yaw_from_gyro_) {
    tracks_.advance(left_mps, right_mps, dt_s);
    pose_ = tracks_.pose();
    return;
  }
  Twist twist = body_twist(parameters_, Mode::kExtended, left_mps, right_mps);
  twist.yaw_rate_radps = parameters_.gyro_scale * gyro_radps;
  model::advance(pose_, twist, dt_s);
}

}  // namespace tp100::model
