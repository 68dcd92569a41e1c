#include "camera/source.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "camera/image_pipe.h"
#include "core/clock.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "text/csv_reader.h"
#include "text/format.h"

namespace tp100::camera {
namespace {

/// Silences libraries that always print on standard error (libpng, libjpeg): the program reports
/// errors in one line of its own. Discards standard error while an object exists. For one thread.
class Quiet {
 public:
  Quiet() {
    std::fflush(stderr);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0) return;
    kept_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
    if (kept_ >= 0) ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
  }
  ~Quiet() {
    if (kept_ < 0) return;
    std::fflush(stderr);
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  int kept_ = -1;
};

namespace fs = std::filesystem;

constexpr const char* kTimes = "times.csv";
constexpr double kMaxTimeS = 1e7;
constexpr std::size_t kMaxImages = 1'000'000;

bool has_image_name(const fs::path& path) {
  static constexpr std::array<std::string_view, 8> kEnds = {".png",  ".jpg", ".jpeg", ".bmp",
                                                            ".webp", ".pgm", ".tif",  ".tiff"};
  std::string end = path.extension().string();
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kEnds.begin(), kEnds.end(), end) != kEnds.end();
}

std::map<std::string, HostNs> read_times(const std::string& path) {
  const text::CsvTable table = text::parse_csv(
      course::read_text_file(path).text, path,
      {.required = {"file", "t_s"}, .by_time = false, .header = false, .texts = {"file"}});
  std::map<std::string, HostNs> times;
  double last_s = -kMaxTimeS;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double t_s = table["t_s"][i];
    const auto fail = [&](const std::string& what) -> UserError {
      return UserError(table.where(i) + ": " + what + "; a line is FILE,SECONDS");
    };
    if (!(std::abs(t_s) < kMaxTimeS)) throw fail("more than 1e7 s");
    if (!(t_s > last_s)) throw fail("not later than the image before");
    last_s = t_s;
    if (!times.emplace(table.texts("file")[i], from_s(t_s)).second) throw fail("named twice");
  }
  return times;
}

void set(Image& image, const cv::Mat& shown) {
  image.shown = shown;
  if (shown.channels() > 1)
    cv::cvtColor(shown, image.grey, cv::COLOR_BGR2GRAY);
  else
    image.grey = shown;
}

/// Images in a folder, in the order of their names, with the times in times.csv or at a fixed rate.
class FolderSource : public Source {
 public:
  FolderSource(const std::string& folder, std::optional<double> fps)
      : files_(list_images(folder, fps)) {}
  bool next(Image& image) override {
    if (at_ == files_.size()) return false;
    const ImageFile& file = files_[at_++];
    try {
      const Quiet quiet;
      set(image, cv::imread(file.path, cv::IMREAD_ANYCOLOR));
    } catch (const cv::Exception&) {
      image.grey.release();
    }
    if (image.grey.empty())
      throw UserError(one_line(file.path, 300) +
                      ": cannot be read as an image; remove or repair it");
    image.taken_ns = file.taken_ns;
    return true;
  }

 private:
  std::vector<ImageFile> files_;
  std::size_t at_ = 0;
};

/// A video file. Times are the images' own presentation times, from 0 at the first.
class VideoSource : public Source {
 public:
  /// Throws UserError.
  explicit VideoSource(const std::string& path);
  /// Throws UserError if the file ends before its declared number of images.
  bool next(Image& image) override;

 private:
  void check_end() const;

  std::string path_;
  cv::VideoCapture capture_;
  cv::Mat frame_;
  double promised_ = 0.0;
  std::int64_t taken_ = 0;
  double first_ms_ = 0.0;
};

// If a container does not store its number of images, OpenCV estimates it from the duration.
constexpr double kMissingShare = 0.03;
constexpr double kMissingCount = 3.0;

VideoSource::VideoSource(const std::string& path) : path_(path) {
  // A file may refer to others: allow files only, and no decoder messages besides our one line.
  ::setenv("OPENCV_FFMPEG_CAPTURE_OPTIONS", "protocol_whitelist;file", 1);
  ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 1);
  bool open = false;
  try {
    const Quiet quiet;
    open = capture_.open(path, cv::CAP_FFMPEG);
  } catch (const cv::Exception&) {
  }
  if (!open)
    throw UserError(one_line(path, 300) +
                    ": cannot be read as a video; give a video file, a folder or a device");
  promised_ = capture_.get(cv::CAP_PROP_FRAME_COUNT);
}

void VideoSource::check_end() const {
  const double missing = promised_ - static_cast<double>(taken_);
  if (!(missing > std::max(kMissingCount, kMissingShare * promised_)) && taken_ > 0) return;
  throw UserError(one_line(path_, 300) + ": ends after " + std::to_string(taken_) + " of " +
                  text::number_text(promised_) +
                  " images; the file is corrupted, record or copy it again");
}

bool VideoSource::next(Image& image) {
  bool read = false;
  try {
    const Quiet quiet;
    read = capture_.read(frame_) && !frame_.empty();
    if (read) set(image, frame_);
  } catch (const cv::Exception&) {
    read = false;
  }
  if (!read) {
    check_end();
    return false;
  }
  const double ms = capture_.get(cv::CAP_PROP_POS_MSEC);
  if (taken_ == 0) first_ms_ = ms;
  image.taken_ns = from_s((ms - first_ms_) * 1e-3);
  ++taken_;
  return true;
}

/// A camera device (Video4Linux).
class DeviceSource : public Source {
 public:
  /// Throws UserError: device missing or busy, or size not supported.
  DeviceSource(const std::string& device, const SourceOptions& options);
  /// False: the device is gone.
  bool next(Image& image) override;
  bool live() const override { return true; }
  bool ends() const override { return false; }

 private:
  cv::VideoCapture capture_;
  cv::Mat frame_;
  HostNs delay_ns_;
};

DeviceSource::DeviceSource(const std::string& device, const SourceOptions& options)
    : delay_ns_(from_s(options.delay_s)) {
  bool open = false;
  try {
    const Quiet quiet;
    open = capture_.open(device, cv::CAP_V4L2);
  } catch (const cv::Exception&) {
  }
  if (!open)
    throw UserError(device +
                    ": cannot be opened as a camera; check that it is there, that you may read it "
                    "(group video) and that no other program has it");
  // USB 2 cannot transfer uncompressed images of this size at 30 per second.
  capture_.set(cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'));
  if (options.width_px > 0) {
    capture_.set(cv::CAP_PROP_FRAME_WIDTH, options.width_px);
    capture_.set(cv::CAP_PROP_FRAME_HEIGHT, options.height_px);
  }
  if (options.fps) capture_.set(cv::CAP_PROP_FPS, *options.fps);
}

bool DeviceSource::next(Image& image) {
  try {
    if (!capture_.grab()) return false;
    const HostNs grabbed_ns = monotonic_now();
    const double driver_ms = capture_.get(cv::CAP_PROP_POS_MSEC);
    if (!capture_.retrieve(frame_) || frame_.empty()) return false;
    set(image, frame_);
    image.taken_ns = image_time(driver_ms, grabbed_ns, delay_ns_);
  } catch (const cv::Exception&) {
    return false;
  }
  return true;
}

std::unique_ptr<Source> open_fifo(const std::string& path, const SourceOptions& options) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    throw UserError(one_line(path, 300) + ": cannot be opened (" + std::strerror(errno) +
                    "); check that you may read it");
  return open_image_pipe(descriptor, path, options);
}

}  // namespace

std::vector<ImageFile> list_images(const std::string& folder, std::optional<double> fps) {
  std::vector<std::string> names;
  bool timed = false;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(".")) continue;
    if (name == kTimes) {
      timed = true;
    } else if (!has_image_name(entry->path()) || !entry->is_regular_file()) {
      throw UserError(one_line(entry->path().string(), 300) +
                      ": no image; keep only images and times.csv in the folder");
    } else if (names.push_back(name); names.size() > kMaxImages) {
      throw UserError(folder + ": too many images; split the folder");
    }
  }
  if (error) throw UserError(folder + ": cannot be listed (" + error.message() + ")");
  if (names.empty()) throw UserError(folder + ": no images in this folder");
  if (!timed && !fps)
    throw UserError(folder + ": no times.csv; add it or give the rate with --fps");
  std::sort(names.begin(), names.end(), [](const std::string& a, const std::string& b) {
    return ::strverscmp(a.c_str(), b.c_str()) < 0;
  });

  const fs::path base(folder);
  std::vector<ImageFile> files;
  if (!timed) {
    for (std::size_t i = 0; i < names.size(); ++i)
      files.push_back({(base / names[i]).string(), from_s(static_cast<double>(i) / *fps)});
    return files;
  }
  const std::string times_path = (base / kTimes).string();
  const std::map<std::string, HostNs> times = read_times(times_path);
  for (const std::string& name : names) {
    const auto found = times.find(name);
    if (found == times.end()) throw UserError(times_path + ": no time for " + one_line(name, 200));
    files.push_back({(base / name).string(), found->second});
  }
  for (const auto& [name, taken_ns] : times)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw UserError(times_path + ": " + one_line(name, 200) + " is not in the folder");
  std::sort(files.begin(), files.end(),
            [](const ImageFile& a, const ImageFile& b) { return a.taken_ns < b.taken_ns; });
  return files;
}

HostNs image_time(double driver_ms, HostNs grabbed_ns, HostNs delay_ns) {
  const double age_ms = static_cast<double>(grabbed_ns) * 1e-6 - driver_ms;
  const bool plausible = driver_ms > 0.0 && age_ms >= 0.0 && age_ms < 1000.0;
  return (plausible ? from_s(driver_ms * 1e-3) : grabbed_ns) - delay_ns;
}

std::unique_ptr<Source> open_source(const std::string& name, const SourceOptions& options) {
  if (name == "-") return open_image_pipe(STDIN_FILENO, "standard input", options);
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
    case fs::file_type::fifo:
      return open_fifo(path, options);
    case fs::file_type::regular:
      return std::make_unique<VideoSource>(path);
    default:
      throw UserError(one_line(path, 300) +
                      ": no such video, folder, device or pipe; check the name");
  }
}

}  // namespace tp100::camera
