// The drives by which another firmware can be compared with this one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "../support/paths.h"
#include "rig.h"

namespace tp100::firmware {
namespace {

/// One line of monitor_drives.txt.
struct Part {
  std::string drive, found;
  double seconds, speed_mps, turn_radps, left_mps, right_mps, gyro_radps, accel_g;
};

std::vector<Part> parts() {
  std::vector<Part> all;
  std::ifstream file(source_path("tests/firmware/monitor_drives.txt"));
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream fields(line);
    Part part;
    char bar = 0;
    std::getline(fields, part.drive, '|');
    fields >> part.seconds >> bar >> part.speed_mps >> part.turn_radps >> bar >> part.left_mps >>
        part.right_mps >> bar >> part.gyro_radps >> bar >> part.accel_g >> bar;
    EXPECT_TRUE(fields) << line;
    std::getline(fields >> std::ws, part.found);
    part.drive.erase(part.drive.find_last_not_of(' ') + 1);
    all.push_back(part);
  }
  return all;
}

/// A robot whose encoders and IMU say what a part says, whatever its motors do.
class DriveRig : public Rig {
 public:
  DriveRig() {
    parameters.counts_per_metre = 10'000.0f;
    parameters.wheelbase_m = 0.25f;
    parameters.wheelbase_tight_m = 0.28f;
    parameters.wheelbase_spin_m = 0.3f;
    parameters.slip_left = parameters.slip_right = 0.0f;
    parameters.turn_slip_share = 0.05f;
    parameters.max_track_mps2 = 20.0f;
    parameters.stall_duty = 500;
    parameters.yaw_kp = parameters.speed_kp = parameters.speed_ki = 0.0f;
    drive(0.0f);
    run(500);
  }
  /// Drives a part and returns the faults that were found; none: "nothing".
  std::vector<std::string> found(const Part& part) {
    speed_mps = static_cast<float>(part.speed_mps);
    yaw_rate_radps = static_cast<float>(part.turn_radps);
    hal.gyro_z = static_cast<std::int16_t>(
        std::lround(part.gyro_radps / static_cast<double>(test::kGyroRadpsPerLsb)));
    hal.accel_x = static_cast<std::int16_t>(
        std::lround(part.accel_g * static_cast<double>(wire::kAccelLsbPerG)));
    const int all_ms = static_cast<int>(std::lround(part.seconds * 1e3));
    for (int ms = 0; ms < all_ms; ++ms) {
      left_edges_ += part.left_mps * 10.0;
      right_edges_ += part.right_mps * 10.0;
      hal.left_counts = static_cast<std::int32_t>(std::floor(left_edges_));
      hal.right_counts = static_cast<std::int32_t>(std::floor(right_edges_));
      run(1);
      if (program.faults() == 0) continue;
      after_s = ms * 1e-3;
      std::vector<std::string> names;
#define TP100_ADD(bit, name, cause, fix) \
  if (has(wire::Fault::name)) names.emplace_back(#name);
      TP100_ROBOT_FAULTS(TP100_ADD)
#undef TP100_ADD
      return names;
    }
    return {"nothing"};
  }
  double after_s = 0.0;

 private:
  double left_edges_ = 0.0, right_edges_ = 0.0;
};

// The text and the drives are all that the author of another firmware has.
TEST(MonitorDrives, EndAsTheTableSays) {
  const std::vector<Part> all = parts();
  ASSERT_GT(all.size(), 40u);
  auto part = all.begin();
  while (part != all.end()) {
    DriveRig rig;
    for (const std::string drive = part->drive; part != all.end() && part->drive == drive; ++part) {
      const std::string expected = part->found.empty() ? "nothing" : part->found;
      const std::size_t after = expected.find(" after ");
      for (const std::string& found : rig.found(*part))
        EXPECT_THAT(expected.substr(0, after), testing::HasSubstr(found))
            << drive << ", after " << rig.after_s << " s";
      if (after != std::string::npos) {
        EXPECT_NEAR(rig.after_s, std::stod(expected.substr(after + 7)), 0.1) << drive;
      }
    }
  }
}

}  // namespace
}  // namespace tp100::firmware
