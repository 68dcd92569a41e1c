#include "camera/video_source.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>

#include "camera/quiet.h"
#include "core/error.h"
#include "text/toml_document.h"

namespace tp100::camera {
namespace {

// Where a container does not say how many pictures it has, OpenCV guesses from its duration.
constexpr double kMissingShare = 0.03;
constexpr double kMissingCount = 3.0;

}  // namespace

VideoSource::VideoSource(const std::string& path) : path_(path) {
  // A file may name others: only files, and no chatter of the decoder besides our one line.
  ::setenv("OPENCV_FFMPEG_CAPTURE_OPTIONS", "protocol_whitelist;file", 1);
  ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 1);
  bool open = false;
  try {
    const Quiet quiet;
    open = capture_.open(path, cv::CAP_FFMPEG);
  } catch (const cv::Exception&) {
  }
  if (!open)
    throw SetupError(text::one_line(path, 300) +
                     ": cannot be read as a video; give a video file, a folder or a device");
  promised_ = capture_.get(cv::CAP_PROP_FRAME_COUNT);
  fps_ = capture_.get(cv::CAP_PROP_FPS);
}

void VideoSource::check_end() const {
  const double missing = promised_ - static_cast<double>(taken_);
  if (!(missing > std::max(kMissingCount, kMissingShare * promised_)) && taken_ > 0) return;
  throw SetupError(text::one_line(path_, 300) + ": ends after " + std::to_string(taken_) + " of " +
                   text::number_text(promised_) +
                   " pictures; the file is damaged, record or copy it again");
}

bool VideoSource::next(Picture& picture) {
  bool read = false;
  try {
    const Quiet quiet;
    read = capture_.read(frame_) && !frame_.empty();
    if (read && frame_.channels() != 1)
      cv::cvtColor(frame_, picture.grey, cv::COLOR_BGR2GRAY);
    else if (read)
      picture.grey = frame_;
  } catch (const cv::Exception&) {
    read = false;
  }
  if (!read) {
    check_end();
    return false;
  }
  const double ms = capture_.get(cv::CAP_PROP_POS_MSEC);
  if (taken_ == 0) first_ms_ = ms;
  picture.taken_ns = from_s((ms - first_ms_) * 1e-3);
  ++taken_;
  return true;
}

}  // namespace tp100::camera
