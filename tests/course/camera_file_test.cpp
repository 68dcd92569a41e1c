#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/camera.h"
#include "support/paths.h"

namespace tp100::course {
namespace {

EmulatedCamera rough() {
  EmulatedCamera values;
  values.delay_s = 0.12;
  values.delay_jitter_s = 0.02;
  values.stamp_error_s = 0.004;
  values.stamp_lag_s = 0.008;
  values.bias_m = 0.004;
  values.dropped = 0.1;
  values.outliers = 0.02;
  values.distortion = 0.02;
  values.view_m = 1.5;
  return values;
}

struct BundledCamera {
  const char* name;
  EmulatedCamera values;
  const char* note;
};

// TP100_REWRITE_CONFIG=1 rewrites the bundled files from the key table.
TEST(CameraFile, TheBundledFilesAreWhatTheKeyTableSays) {
  for (const BundledCamera& camera :
       {BundledCamera{"overhead",
                      {},
                      "An emulated overhead camera, with every key at its default. The daemon's "
                      "settings for the camera are in the configuration's [camera], not here."},
        BundledCamera{
            "rough", rough(),
            "An emulated overhead camera whose errors are not those that the "
            "configuration's [camera] assumes: a lens with distortion left, a lag that no "
            "time stamp shows, a floor seen in part, false detections."}}) {
    const std::string path = source_path("config/cameras/" + std::string(camera.name) + ".toml");
    const std::string text = write_camera(camera.values, camera.note);
    if (std::getenv("TP100_REWRITE_CONFIG") != nullptr) {
      std::ofstream(path, std::ios::binary) << text;
      continue;
    }
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bundled;
    bundled << file.rdbuf();
    EXPECT_EQ(bundled.str(), text) << path << " differs from the key table";
  }
}

TEST(CameraFile, ReadsBackWhatItWritesAndRefusesWhatItDoesNotKnow) {
  EmulatedCamera values;
  values.delay_s = 0.1;
  values.noise_rad = 1.5 * kRadPerDeg;
  values.outliers = 0.02;
  EXPECT_EQ(write_camera(parse_camera(write_camera(values, ""), "f"), ""),
            write_camera(values, ""));
  EXPECT_THROW(parse_camera("rate_hz = 0.0\n", "f"), SetupError);
  EXPECT_THROW(parse_camera("hight_m = 2.0\n", "f"), SetupError);
}

}  // namespace
}  // namespace tp100::course
