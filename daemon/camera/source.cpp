#include "camera/source.h"

#include <algorithm>
#include <filesystem>

#include "camera/device_source.h"
#include "camera/folder_source.h"
#include "camera/video_source.h"
#include "core/error.h"
#include "text/toml_document.h"

namespace tp100::camera {

namespace fs = std::filesystem;

std::unique_ptr<Source> open_source(const std::string& name, const SourceOptions& options) {
  const bool number =
      !name.empty() && name.size() <= 3 &&
      std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
  std::error_code error;
  const std::string path = number && !fs::exists(name, error) ? "/dev/video" + name : name;
  const fs::file_status status = fs::status(path, error);
  switch (status.type()) {
    case fs::file_type::directory:
      return std::make_unique<FolderSource>(path, options.fps);
    case fs::file_type::character:
      return std::make_unique<DeviceSource>(path, options);
    case fs::file_type::regular:
      return std::make_unique<VideoSource>(path);
    default:
      throw SetupError(text::one_line(path, 300) +
                       ": no such video, folder or device; check the name");
  }
}

}  // namespace tp100::camera
