#include "scene.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <stdexcept>

namespace tp100::test {
namespace {

constexpr int kGrid = 4;  // rays per pixel in each direction
constexpr int kRays = kGrid * kGrid;
// Width of the white rim around the black square, as a share of the square: 1.5 of the 6 modules of
// a 4x4 marker.
constexpr double kRim = 1.5 / 6.0;

/// Grey value of the decal where the ray from `eye` meets it; negative if it does not.
double seen(const Decal& decal, const Vec3& eye, const Vec3& direction) {
  const Vec3 normal = decal.across_m.cross(decal.down_m);
  const double towards = normal.dot(direction);
  if (std::abs(towards) < 1e-12) return -1.0;
  const double along = normal.dot(decal.corner_m - eye) / towards;
  if (along <= 0.0) return -1.0;
  const Vec3 at = eye + along * direction - decal.corner_m;
  const double column = at.dot(decal.across_m) / decal.across_m.dot(decal.across_m);
  const double row = at.dot(decal.down_m) / decal.down_m.dot(decal.down_m);
  if (column < 0.0 || column >= 1.0 || row < 0.0 || row >= 1.0) return -1.0;
  return decal.bits.at<unsigned char>(static_cast<int>(row * decal.bits.rows),
                                      static_cast<int>(column * decal.bits.cols));
}

/// Body axes in the world: yaw, pitch, roll.
std::array<Vec3, 3> body_axes(const Pose& pose) {
  const double cy = std::cos(pose.yaw_rad), sy = std::sin(pose.yaw_rad);
  const double cp = std::cos(pose.pitch_rad), sp = std::sin(pose.pitch_rad);
  const double cr = std::cos(pose.roll_rad), sr = std::sin(pose.roll_rad);
  return {Vec3{cy * cp, sy * cp, -sp},
          Vec3{cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr},
          Vec3{cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr}};
}

/// A square whose top edge points along `ahead` and whose left edge is on the side of `left`.
Decal square(const cv::Mat& bits, const Vec3& middle, const Vec3& ahead, const Vec3& left,
             double size_m) {
  return {bits, middle + size_m / 2 * (ahead + left), -size_m * left, -size_m * ahead};
}

/// The marker's bits with their white rim; `size_m` is enlarged accordingly.
cv::Mat with_rim(const cv::Mat& bits, double& size_m) {
  const int rim = static_cast<int>(std::lround(bits.cols * kRim));
  cv::Mat out(bits.rows + 2 * rim, bits.cols + 2 * rim, CV_8U, cv::Scalar(225));
  out(cv::Rect(rim, rim, bits.cols, bits.rows)).setTo(30, bits == 0);
  size_m *= static_cast<double>(out.cols) / bits.cols;
  return out;
}

}  // namespace

std::array<Vec3, 3> SceneCamera::axes() const {
  // The camera looks straight down, with the image's right along the world's x; then it is tilted
  // and turned.
  const double cx = std::cos(tilt_x_rad), sx = std::sin(tilt_x_rad);
  const double cy = std::cos(tilt_y_rad), sy = std::sin(tilt_y_rad);
  const double ct = std::cos(turned_rad), st = std::sin(turned_rad);
  const Vec3 view = {sy, sx * cy, -cx * cy};
  const Vec3 right = {cy, -sx * sy, cx * sy};
  const Vec3 down = view.cross(right);
  return {ct * right + st * down, ct * down - st * right, view};
}

std::array<double, 2> SceneCamera::pixel(const Vec3& world_m) const {
  const std::array<Vec3, 3> frame = axes();
  const Vec3 from = world_m - place_m;
  const double depth = frame[2].dot(from);
  const double x = frame[0].dot(from) / depth, y = frame[1].dot(from) / depth;
  const double r2 = x * x + y * y;
  const double stretch = 1.0 + k1 * r2 + k2 * r2 * r2;
  return {centre_x_px + focal_px * (x * stretch + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)),
          centre_y_px + focal_px * (y * stretch + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y)};
}

Vec3 SceneCamera::direction(double u_px, double v_px, const std::array<Vec3, 3>& frame) const {
  const double want_x = (u_px - centre_x_px) / focal_px, want_y = (v_px - centre_y_px) / focal_px;
  double x = want_x, y = want_y, off = 1.0;
  for (int i = 0; i < 200 && off > 1e-12; ++i) {
    const double r2 = x * x + y * y;
    const double stretch = 1.0 + k1 * r2 + k2 * r2 * r2;
    const double next_x = (want_x - 2 * p1 * x * y - p2 * (r2 + 2 * x * x)) / stretch;
    const double next_y = (want_y - p1 * (r2 + 2 * y * y) - 2 * p2 * x * y) / stretch;
    off = std::abs(next_x - x) + std::abs(next_y - y);
    x = next_x;
    y = next_y;
  }
  if (off > 1e-6) throw std::logic_error("scene: no ray for this pixel");
  return frame[2] + x * frame[0] + y * frame[1];
}

Scene::Scene(const SceneCamera& camera, std::uint64_t seed)
    : camera_(camera), random_(seed), clutter_(seed) {}

void Scene::lay(const cv::Mat& bits, double size_m, double x_m, double y_m, double yaw_rad) {
  const cv::Mat rimmed = with_rim(bits, size_m);
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  show(square(rimmed, {x_m, y_m, 0.0}, {c, s, 0.0}, {-s, c, 0.0}, size_m));
}

void Scene::carry(const cv::Mat& bits, double size_m, double height_m) {
  marker_size_m_ = size_m;
  marker_height_m_ = height_m;
  marker_ = with_rim(bits, marker_size_m_);
}

std::vector<Decal> Scene::robot_at(const Pose& pose) const {
  const std::array<Vec3, 3> axes = body_axes(pose);
  const Vec3 top = Vec3(pose.x_m, pose.y_m, pose.z_m) + marker_height_m_ * axes[2];
  // The robot itself is a dark square slightly below its marker.
  const Vec3 deck = top - 0.002 * axes[2];
  const cv::Mat dark(1, 1, CV_8U, cv::Scalar(55));
  return {square(dark, deck, axes[0], axes[1], std::max(0.19, marker_size_m_ * 1.05)),
          square(marker_, top, axes[0], axes[1], marker_size_m_)};
}

cv::Mat Scene::background() const {
  cv::Mat grey(camera_.height_px, camera_.width_px, CV_32F);
  std::mt19937_64 random(clutter_);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double a = 6.0 * share(random), b = 6.0 * share(random);
  for (int v = 0; v < grey.rows; ++v) {
    float* row = grey.ptr<float>(v);
    for (int u = 0; u < grey.cols; ++u) {
      const double x = static_cast<double>(u) / grey.cols, y = static_cast<double>(v) / grey.rows;
      // The light is uneven, and the floor has boards with joints.
      const double light = 0.85 + 0.25 * std::sin(2.0 * x + a) * std::cos(1.7 * y + b);
      const bool joint = std::fmod(x * 19.0 + a, 1.0) < 0.01;
      row[u] = static_cast<float>(light * (joint ? 110.0 : 165.0));
    }
  }
  for (int i = 0; i < 40; ++i) {
    const int width = 4 + static_cast<int>(60 * share(random));
    const int height = 4 + static_cast<int>(60 * share(random));
    const cv::Rect box(static_cast<int>(share(random) * grey.cols),
                       static_cast<int>(share(random) * grey.rows), width, height);
    grey(box & cv::Rect(0, 0, grey.cols, grey.rows)) = 40.0 + 180.0 * share(random);
  }
  return grey;
}

/// Draws the decals over each other at the instants of the exposure; each ray of a pixel belongs to
/// one instant.
void Scene::draw(cv::Mat& grey, const std::vector<std::vector<Decal>>& instants) const {
  std::vector<cv::Point2f> corners;
  for (const auto& decals : instants) {
    for (const Decal& decal : decals) {
      for (int k = 0; k < 4; ++k) {
        const auto at =
            camera_.pixel(decal.corner_m + (k & 1) * decal.across_m + (k >> 1) * decal.down_m);
        corners.emplace_back(static_cast<float>(at[0]), static_cast<float>(at[1]));
      }
    }
  }
  // Distortion bends edges slightly beyond their ends.
  const cv::Rect hull = cv::boundingRect(corners);
  const cv::Rect box = cv::Rect(hull.x - 6, hull.y - 6, hull.width + 12, hull.height + 12) &
                       cv::Rect(0, 0, grey.cols, grey.rows);
  const std::array<Vec3, 3> frame = camera_.axes();
  for (int v = box.y; v < box.br().y; ++v) {
    float* row = grey.ptr<float>(v);
    for (int u = box.x; u < box.br().x; ++u) {
      double sum = 0.0;
      for (int ray = 0; ray < kRays; ++ray) {
        const double du = (ray % kGrid + 0.5) / kGrid - 0.5;
        const double dv = (static_cast<double>(ray / kGrid) + 0.5) / kGrid - 0.5;
        const Vec3 direction = camera_.direction(u + du, v + dv, frame);
        // Seven has no common factor with the number of rays, so that instants and places mix.
        const auto& decals = instants[static_cast<std::size_t>(ray * 7 % kRays) % instants.size()];
        double value = row[u];
        for (const Decal& decal : decals)
          if (const double found = seen(decal, camera_.place_m, direction); found >= 0.0)
            value = found;
        sum += value;
      }
      row[u] = static_cast<float>(sum / kRays);
    }
  }
}

void Scene::show(const Decal& decal) {
  decals_.push_back(decal);
  still_.release();
}

const cv::Mat& Scene::still() {
  if (still_.empty()) {
    still_ = background();
    for (const Decal& decal : decals_) draw(still_, {{decal}});
  }
  return still_;
}

cv::Mat Scene::finish(cv::Mat grey, const SceneNoise& noise) {
  if (noise.blur_px > 0.0)
    cv::GaussianBlur(grey, grey, {}, noise.blur_px, noise.blur_px, cv::BORDER_REPLICATE);
  cv::Mat errors(grey.size(), CV_32F);
  random_.fill(errors, cv::RNG::NORMAL, 0.0, noise.grey_sd);
  cv::Mat out;
  cv::Mat(grey + errors).convertTo(out, CV_8U);
  return out;
}

cv::Mat Scene::empty_floor(const SceneNoise& noise) { return finish(still().clone(), noise); }

cv::Mat Scene::image(const Pose& pose, const Twist& twist, const SceneNoise& noise) {
  cv::Mat grey = still().clone();
  std::vector<std::vector<Decal>> instants;
  const int count = noise.exposure_s > 0.0 ? kRays : 1;
  for (int i = 0; i < count; ++i) {
    const double t = noise.exposure_s * ((i + 0.5) / count - 0.5);
    Pose moved = pose;
    const double yaw = pose.yaw_rad + twist.yaw_rate_radps * t / 2;
    moved.x_m += (twist.vx_mps * std::cos(yaw) - twist.vy_mps * std::sin(yaw)) * t;
    moved.y_m += (twist.vx_mps * std::sin(yaw) + twist.vy_mps * std::cos(yaw)) * t;
    moved.yaw_rad += twist.yaw_rate_radps * t;
    instants.push_back(robot_at(moved));
  }
  draw(grey, instants);
  return finish(grey, noise);
}

}  // namespace tp100::test
