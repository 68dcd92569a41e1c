#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "course/camera.h"
#include "course/robot_file.h"
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

// `scripts/test --accept` rewrites the bundled files from the key table.
TEST(CameraFile, TheBundledFilesAreWhatTheKeyTableSays) {
  for (const char* name : {"overhead", "rough"}) {
    const std::string path = source_path("config/cameras/" + std::string(name) + ".toml");
    const std::string bundled = read_text_file(path).text;
    const bool is_rough = std::string(name) == "rough";
    const std::string text =
        write_camera(is_rough ? rough() : EmulatedCamera{}, head_note(bundled));
    if (std::getenv("TP100_ACCEPT") != nullptr)
      std::ofstream(path, std::ios::binary) << text;
    else
      EXPECT_EQ(bundled, text) << path << " differs from the key table";
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
