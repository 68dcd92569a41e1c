#pragma once
// A video file. Times are the pictures' own presentation times, from 0 at the first.

#include <opencv2/videoio.hpp>
#include <string>

#include "camera/source.h"

namespace tp100::camera {

class VideoSource : public Source {
 public:
  /// Throws SetupError.
  explicit VideoSource(const std::string& path);
  /// Throws SetupError at the end of a file that promised more pictures.
  bool next(Picture& picture) override;

 private:
  void check_end() const;

  std::string path_;
  cv::VideoCapture capture_;
  cv::Mat frame_;
  double promised_ = 0.0;
  double fps_ = 0.0;
  std::int64_t taken_ = 0;
  double first_ms_ = 0.0;
};

}  // namespace tp100::camera
