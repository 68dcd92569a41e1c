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
  static const std::array<text::Key<T>, 17> kKeys = {{
      {"rate_hz", &T::rate_hz, {1, 500}, "Pictures per second"},
      {"delay_ms", &T::delay_s, {5, 400}, "From the picture to the arrival of its sample", kMs},
      {"delay_jitter_ms", &T::delay_jitter_s, {0, 100}, "Standard deviation of that delay", kMs},
      {"stamp_error_ms",
       &T::stamp_error_s,
       {0, 50},
       "Standard deviation of the time stamp of a picture",
       kMs},
      {"noise_m", &T::noise_m, {0, 0.1}, "Standard deviation of the place, per axis"},
      {"noise_deg", &T::noise_rad, {0, 20}, "Standard deviation of the direction", kDeg},
      {"bias_m",
       &T::bias_m,
       {0, 0.1},
       "Error of the place that stays for a run; the seed draws its direction"},
      {"dropped", &T::dropped, {0, 1}, "Share of the pictures without a detection"},
      {"blind_from_s",
       &T::blind_from_s,
       {0, 100000},
       "From here on, counted from the first picture, nothing is detected"},
      {"blind_s", &T::blind_s, {0, 100000}, "... for this long"},
      {"outliers", &T::outliers, {0, 1}, "Share of the pictures with a false detection"},
      {"outlier_m", &T::outlier_m, {0, 5}, "A false detection is off by this at most, per axis"},
      {"height_m", &T::height_m, {0.5, 20}, "Lens above the floor; it looks straight down"},
      {"offset_x_m",
       &T::offset_x_m,
       {-10, 10},
       "Lens from the middle of the course's fence, along the world's x"},
      {"offset_y_m", &T::offset_y_m, {-10, 10}, "Same along the world's y"},
      {"marker_height_m",
       &T::marker_height_m,
       {0, 0.4},
       "Marker above the reference point; the height of the plane that the camera measures in"},
      {"marker_size_m", &T::marker_size_m, {0.01, 0.5}, "Side of the marker"},
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

std::string write_camera(const EmulatedCamera& values) {
  return text::toml_comment(
             "An emulated overhead camera, with every key at its default. What the daemon believes "
             "of the camera is in the configuration's [camera], not here.") +
         "\n" + text::write_keys(keys(), values);
}

}  // namespace tp100::course
