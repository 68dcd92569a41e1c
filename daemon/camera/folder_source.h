#pragma once
// Pictures in a folder, in the order of their names, with the times in times.csv or at a fixed
// rate.

#include <string>
#include <vector>

#include "camera/source.h"

namespace tp100::camera {

/// A picture file and its time.
struct PictureFile {
  std::string path;
  HostNs taken_ns = 0;
};

/// Lists a folder. Numbers in names count as numbers: 2 comes before 10. times.csv has lines
/// FILE,SECONDS (a header file,t_s may stand first), strictly later from line to line; pictures
/// that it does not name are an error, and so is anything in the folder that is neither picture,
/// times.csv nor hidden. Without it `fps` gives the times. Throws SetupError.
std::vector<PictureFile> list_pictures(const std::string& folder, std::optional<double> fps);

class FolderSource : public Source {
 public:
  FolderSource(const std::string& folder, std::optional<double> fps)
      : files_(list_pictures(folder, fps)) {}
  bool next(Picture& picture) override;

 private:
  std::vector<PictureFile> files_;
  std::size_t at_ = 0;
};

}  // namespace tp100::camera
