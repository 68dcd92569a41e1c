#include <array>
#include <span>

#include "course/camera.h"
#include "text/key.h"

namespace tp100::course {
namespace {

constexpr double kDeg = kRadPerDeg;
constexpr double kMs = 1e-3;

std::span<const text::Key<EmulatedCamera>> keys() {
  using T = EmulatedCamera;
  static const auto mount = camera_mount_keys<T>();
  static const std::array<text::Key<T>, 20> kKeys = {{
      {"rate_hz", &T::rate_hz, {1, 500}, "Images per second"},
      {"delay_ms", &T::delay_s, {5, 400}, "Delay from an image to the arrival of its sample", kMs},
      {"delay_jitter_ms", &T::delay_jitter_s, {0, 100}, "Standard deviation of that delay", kMs},
      {"stamp_error_ms",
       &T::stamp_error_s,
       {0, 50},
       "Standard deviation of the time stamp of an image",
       kMs},
      {"stamp_lag_ms",
       &T::stamp_lag_s,
       {0, 100},
       "Constant part of that error: the time stamp is later than the image",
       kMs},
      {"noise_m", &T::noise_m, {0, 0.1}, "Standard deviation of the position, per axis"},
      {"noise_deg", &T::noise_rad, {0, 20}, "Standard deviation of the direction", kDeg},
      {"bias_m",
       &T::bias_m,
       {0, 0.1},
       "Constant error of the position during a run; the seed determines its direction"},
      {"dropped", &T::dropped, {0, 1}, "Share of the images without a detection"},
      {"blind_from_s",
       &T::blind_from_s,
       {0, 100000},
       "Time from the first image to the beginning of a period without detections"},
      {"blind_s", &T::blind_s, {0, 100000}, "Duration of that period"},
      {"outliers", &T::outliers, {0, 1}, "Share of the images with a false detection"},
      {"outlier_m", &T::outlier_m, {0, 5}, "Largest error of a false detection, per axis"},
      mount[0],
      mount[1],
      mount[2],
      mount[3],
      {"marker_size_m", &T::marker_size_m, {0.01, 0.5}, "Side of the marker"},
      {"distortion",
       &T::distortion,
       {-0.2, 0.2},
       "Radial lens error that the calibration left, in parts of the distance from the middle of "
       "the image; at a distance of height_m, and with its square"},
      {"view_m",
       &T::view_m,
       {0, 50},
       "Radius around the lens in which it sees the marker; 0: everywhere"},
  }};
  return kKeys;
}

}  // namespace

EmulatedCamera parse_camera(const std::string& text, const std::string& file) {
  const text::TomlDocument document(text, file);
  text::TomlTable root = document.root();
  EmulatedCamera values;
  text::read_keys(root, keys(), values);
  root.finish();
  return values;
}

std::string write_camera(const EmulatedCamera& values, const std::string& note) {
  return text::toml_comment(note) + "\n" + text::write_keys(keys(), values);
}

}  // namespace tp100::course
