#pragma once
// Poses as a TUM file: one line each, "t x y z qx qy qz qw", seconds and metres, for evo and
// others.

#include <cstdio>
#include <string>

#include "camera/marker_pose.h"
#include "core/time.h"

namespace tp100::camera {

/// Written under a temporary name beside `path`, and renamed by finish().
class TumFile {
 public:
  /// Throws SetupError.
  explicit TumFile(const std::string& path);
  ~TumFile();
  TumFile(const TumFile&) = delete;
  TumFile& operator=(const TumFile&) = delete;

  /// z is 0: the reference point stands on the floor.
  void add(const MarkerPose& pose, HostNs taken_ns);
  /// Throws SetupError if it could not be written as a whole.
  void finish();

 private:
  std::string path_, temporary_;
  std::FILE* file_ = nullptr;
};

}  // namespace tp100::camera
