#include "sim/study/drawn_robot.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace tp100::sim {
namespace {

// What a robot file can hold; motors this strong never get there.
constexpr double kMostCurrentLimitN = 100.0;

class Draw {
 public:
  explicit Draw(std::uint64_t number) {
    std::seed_seq sequence{static_cast<std::uint32_t>(number),
                           static_cast<std::uint32_t>(number >> 32), 0xD0B07u};
    random_.seed(sequence);
  }
  double share() { return static_cast<double>(random_()) / 4294967295.0; }
  double operator()(Drawn what) {
    const DrawnRange& range = kDrawnRanges.at(static_cast<std::size_t>(what));
    return range.low + (range.high - range.low) * share();
  }

 private:
  std::mt19937 random_;
};

}  // namespace

course::Robot drawn_robot(const course::Robot& end_loaded, std::uint64_t number) {
  Draw draw(number);
  course::Robot robot = end_loaded;
  robot.name = "drawn-" + std::to_string(number);
  robot.description = "drawn by the number " + std::to_string(number);
  robot.model = {};
  robot.origins.clear();

  const double size = draw(Drawn::kSize);
  course::ShapeValues& shape = robot.shape;
  for (double* length : {&shape.length_m, &shape.height_m, &shape.axle_spacing_m,
                         &shape.belt_radius_m, &shape.gauge_m})
    *length *= size;
  course::EmulatedBody& body = robot.emulated.body;
  for (double* length : {&body.length_m, &body.width_m, &body.height_m, &body.axle_spacing_m,
                         &body.belt_radius_m, &body.gauge_m, &body.belt_width_m})
    *length *= size;
  const double heavier = draw(Drawn::kMass) * size * size * size;
  body.mass_kg *= heavier;
  body.mid_lift_m = draw(Drawn::kMidLift) * 1e-3;
  body.friction = draw(Drawn::kFriction);
  const double creep = draw(Drawn::kCreep), uneven = draw(Drawn::kCreepUneven);
  body.creep_left = creep * (1.0 + uneven / 2.0);
  body.creep_right = creep * (1.0 - uneven / 2.0);
  const double deficit = draw(Drawn::kDeficit), apart = draw(Drawn::kDeficitUneven);
  body.belt_deficit_left = deficit + apart / 2.0;
  body.belt_deficit_right = deficit - apart / 2.0;
  body.com_forward_m = shape.com_forward_m = draw(Drawn::kForward) * body.axle_spacing_m;
  body.com_left_m = draw(Drawn::kLeft) * body.gauge_m;
  body.com_height_m = shape.com_height_m = draw(Drawn::kHeight) * 1e-3 * size;

  course::EmulatedMotor& motor = robot.emulated.motor;
  motor.stall_n_per_v *= heavier;
  motor.friction_n *= heavier;
  motor.current_limit_n = std::min(motor.current_limit_n * heavier, kMostCurrentLimitN);
  robot.emulated.battery.amps_per_n /= heavier;
  motor.left_gain = draw(Drawn::kMotor);
  motor.right_gain = draw(Drawn::kMotor);
  const DrawnRange& counts = kDrawnRanges.at(static_cast<std::size_t>(Drawn::kCounts));
  robot.emulated.encoder.counts_per_metre = robot.drive.counts_per_metre =
      std::round(counts.low * std::pow(counts.high / counts.low, draw.share()));
  robot.emulated.imu.gyro_scale_error = draw(Drawn::kGyroScale);
  return robot;
}

}  // namespace tp100::sim
