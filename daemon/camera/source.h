#pragma once
// Sources of images: a folder, a video file, a device, a pipe.

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/time.h"

namespace tp100::camera {

/// One image and the time it was taken.
struct Image {
  cv::Mat grey;         ///< 8 bits
  cv::Mat shown;        ///< the same as it was taken, grey or in colour (BGR), 8 bits
  HostNs taken_ns = 0;  ///< recordings: since their beginning; live ones: monotonic clock
};

struct SourceOptions {
  std::optional<double> fps;  ///< folders without times: images per second; devices: requested rate
  int width_px = 0;           ///< devices: requested width; 0: their default
  int height_px = 0;
  double delay_s = 0.0;  ///< devices: from the exposure to the driver's stamp; pipes without
                         ///< stamps: to the arrival
  int stop_fd = -1;      ///< a pipe ends as soon as this descriptor can be read; -1: none
};

class Source {
 public:
  Source() = default;
  virtual ~Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  /// Gets the next image; false at the end. Throws UserError for unreadable input.
  virtual bool next(Image& image) = 0;
  /// Whether images arrive as they are taken, not on request.
  virtual bool live() const { return false; }
  /// Whether the source has an end, as recordings have; if a device ends, it is gone.
  virtual bool ends() const { return true; }
};

/// Opens `name`: a folder of images (list_images()), a device (/dev/video0, or 0 for short), a pipe
/// (camera/image_pipe.h; - is standard input), or else a video file. Throws UserError.
std::unique_ptr<Source> open_source(const std::string& name, const SourceOptions& options);

/// An image file and its time.
struct ImageFile {
  std::string path;
  HostNs taken_ns = 0;
};

/// Lists a folder. Names are in the order of strverscmp(3): 2 comes before 10, 09 before 10.
/// times.csv has lines FILE,SECONDS (optionally after a header file,t_s), strictly later from line
/// to line; images that it does not name are an error, and so is anything in the folder that is
/// neither image, times.csv nor hidden. Without it `fps` gives the times. Throws UserError.
std::vector<ImageFile> list_images(const std::string& folder, std::optional<double> fps);

/// Time of an image, monotonic clock: the driver's stamp if it is valid (a monotonic time within
/// the last second before `grabbed_ns`), else the time at which it was grabbed; minus the
/// configured delay. Pure.
HostNs image_time(double driver_ms, HostNs grabbed_ns, HostNs delay_ns);

}  // namespace tp100::camera
