#pragma once
// A body with another contact law than OdeBody's: shear stress that builds up under each shoe on
// its way from the front of the track to the rear. It shares no code and no equation with OdeBody
// or with the model under test, so that figures that hold on both bodies are not due to either law.
//
// Sources: Janosi and Hanamoto 1961 for the law; Wong, Theory of Ground Vehicles, and Wong and
// Chiang 2001 (Proc. IMechE D 215, 343) for tracks as rows of shoes and for pressure that is uneven
// and follows the load; Dahl 1968 for the rate form.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/pose.h"
#include "course/robot_file.h"
#include "course/terrain.h"
#include "sim/body/body.h"
#include "sim/body/uneven_floor.h"

namespace tp100::sim {

/// A rigid body that moves in the plane (x, y, yaw) on level ground; its weight is distributed over
/// the shoes by the balance of moments, without pitch and roll.
///
/// Under a shoe with the normal force N and the area A that has slid by the path j, the ground
/// resists with (c A + N tan(phi)) (1 - exp(-j / K)) (Janosi and Hanamoto). For a sliding velocity
/// v that changes direction, the rate form of the same law is used: K ds/dt = v - |v| s, where the
/// vector s is the share of the limit. For a constant direction its solution is the law above; the
/// magnitude of s never exceeds 1 in any direction (isotropic friction); after a reversal the
/// stress falls from where it was and is not recovered. A shoe that enters the contact starts with
/// s = 0.
class ShearBody final : public Body {
 public:
  /// Parameters as for make_body. Of surfaces and of an uneven floor, only the friction is used.
  /// Throws UserError for ramps and blocks.
  ShearBody(const course::Emulated& values, const Pose& start, bool on_stand,
            const course::Terrain& terrain = {}, const UnevenFloor& floor = {});

  void step(double left_track_mps, double right_track_mps) override;
  void turn_tracks(double left_m, double right_m) override;
  void disturbance(double sideways_m, double yaw_rad, double duration_s) override;
  bool disturbed() const override { return disturbance_steps_ > 0; }
  const BodyState& state() const override { return state_; }

 private:
  /// Shoe i is at i * pitch - travel_m ahead of the middle, modulo the track's length.
  struct Track {
    double y_m;                           // of the centre line, from the reference point
    double travel_m = 0.0;                // since the start
    double wear_m = 0.0;                  // where the worn stretch begins, along the track
    std::vector<Eigen::Vector2d> stress;  // of each shoe, as share of its limit, world frame
    double load_n = 0.0;                  // force by the ground, forward positive
  };
  struct Reaction {
    Eigen::Vector2d force_n = Eigen::Vector2d::Zero();  // world frame
    double moment_nm = 0.0;                             // about the centre of mass
    double traction_n = 0.0;                            // along the track
  };
  /// One shoe in contact: its position and its share of the track's load.
  struct ShoeContact {
    std::size_t shoe;
    double x_m, share, overlap;
  };

  /// Moves the body by the ground's forces.
  void advance(double left_mps, double right_mps);
  /// Finds the shoes in contact and distributes the load among them, so that its centre lies
  /// `centre_m` ahead of the middle.
  void distribute(const Track& track, double centre_m);
  Reaction shear(Track& track, double track_mps, double load_n);
  double friction_at(const Track& track, std::size_t shoe, const Eigen::Vector2d& ground_m) const;
  Eigen::Vector2d forward() const;
  void observe(const Eigen::Vector2d& velocity_before);

  course::EmulatedBody body_;
  course::EmulatedShear shear_;
  bool on_stand_;
  course::Terrain terrain_;
  UnevenFloor floor_;
  double inertia_kgm2_;
  double pitch_m_;  // distance from shoe to shoe
  Track left_, right_;
  std::vector<ShoeContact> contacts_;  // of the track being computed
  Eigen::Vector2d position_m_;         // of the centre of mass
  double yaw_rad_;
  Eigen::Vector2d velocity_mps_ = Eigen::Vector2d::Zero();
  double rate_radps_ = 0.0;
  Eigen::Vector2d acceleration_mps2_ = Eigen::Vector2d::Zero();  // body frame
  double disturbance_per_step_m_ = 0.0, disturbance_yaw_per_step_ = 0.0;
  int disturbance_steps_ = 0;  // remaining
  bool disturbed_ = false;     // in this step
  BodyState state_{};
};

}  // namespace tp100::sim
