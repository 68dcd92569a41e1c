#pragma once
// Where pictures come from: a folder, a video file, a device.

#include <memory>
#include <optional>
#include <string>

#include "camera/picture.h"

namespace tp100::camera {

struct SourceOptions {
  std::optional<double> fps;  ///< folders without times: pictures per second; devices: ask for it
  int width_px = 0;           ///< devices: ask for it; 0: their own choice
  int height_px = 0;
  double delay_s = 0.0;  ///< devices: from the exposure to the driver's stamp
};

class Source {
 public:
  Source() = default;
  virtual ~Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  /// The next picture; false at the end. Throws SetupError for what cannot be read.
  virtual bool next(Picture& picture) = 0;
  /// Pictures come when they are taken, not when they are asked for.
  virtual bool live() const { return false; }
};

/// Opens `name`: a folder of pictures (folder_source.h), a device (/dev/video0, or 0 for short), or
/// else a video file. Throws SetupError.
std::unique_ptr<Source> open_source(const std::string& name, const SourceOptions& options);

}  // namespace tp100::camera
