#include "camera/tum_file.h"

#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>

#include "core/error.h"

namespace tp100::camera {

TumFile::TumFile(const std::string& path)
    : path_(path), temporary_(path + "." + std::to_string(::getpid()) + ".tmp") {
  file_ = std::fopen(temporary_.c_str(), "we");
  if (file_ == nullptr)
    throw SetupError(path + ": cannot be written (" + std::strerror(errno) +
                     "); choose another file for --tum");
  std::fprintf(file_, "# t_s x_m y_m z_m qx qy qz qw\n");
}

TumFile::~TumFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::remove(temporary_.c_str());
}

void TumFile::add(const MarkerPose& pose, HostNs taken_ns) {
  const double half = pose.yaw_rad / 2.0;
  std::fprintf(file_, "%.6f %.6f %.6f 0 0 0 %.9f %.9f\n", to_s(taken_ns), pose.x_m, pose.y_m,
               std::sin(half), std::cos(half));
}

void TumFile::finish() {
  const bool good = std::ferror(file_) == 0;
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  if (good && closed && std::rename(temporary_.c_str(), path_.c_str()) == 0) return;
  const int error = errno;
  std::remove(temporary_.c_str());
  throw SetupError(path_ + ": cannot be written (" + std::strerror(error) +
                   "); choose another file for --tum");
}

}  // namespace tp100::camera
