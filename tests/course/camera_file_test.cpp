#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/angle.h"
#include "core/error.h"
#include "course/camera.h"
#include "support/paths.h"

namespace tp100::course {
namespace {

// TP100_REWRITE_CONFIG=1 rewrites the bundled file from the key table.
TEST(CameraFile, TheBundledFileIsWhatTheKeyTableSays) {
  const std::string path = TP100_SOURCE_DIR "/config/cameras/overhead.toml";
  const std::string text = write_camera({});
  if (std::getenv("TP100_REWRITE_CONFIG") != nullptr) {
    std::ofstream(path, std::ios::binary) << text;
    return;
  }
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bundled;
  bundled << file.rdbuf();
  EXPECT_EQ(bundled.str(), text) << "config/cameras/overhead.toml differs from the key table";
}

TEST(CameraFile, ReadsBackWhatItWritesAndRefusesWhatItDoesNotKnow) {
  EmulatedCamera values;
  values.delay_s = 0.1;
  values.noise_rad = 1.5 * kRadPerDeg;
  values.outliers = 0.02;
  EXPECT_EQ(write_camera(parse_camera(write_camera(values), "f")), write_camera(values));
  EXPECT_THROW(parse_camera("rate_hz = 0.0\n", "f"), SetupError);
  EXPECT_THROW(parse_camera("hight_m = 2.0\n", "f"), SetupError);
}

}  // namespace
}  // namespace tp100::course
