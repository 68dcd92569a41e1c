#include "camera/folder_source.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "camera/quiet.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "text/toml_document.h"

namespace tp100::camera {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTimes = "times.csv";
constexpr double kMaxTimeS = 1e7;
constexpr std::size_t kMostPictures = 1'000'000;

bool has_picture_name(const fs::path& path) {
  static constexpr std::array<std::string_view, 8> kEnds = {".png",  ".jpg", ".jpeg", ".bmp",
                                                            ".webp", ".pgm", ".tif",  ".tiff"};
  std::string end = path.extension().string();
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kEnds.begin(), kEnds.end(), end) != kEnds.end();
}

/// "a2" before "a10".
bool comes_before(const std::string& a, const std::string& b) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!digit(a[i]) || !digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    while (i < a.size() && a[i] == '0') ++i;
    while (j < b.size() && b[j] == '0') ++j;
    std::size_t m = i, n = j;
    while (m < a.size() && digit(a[m])) ++m;
    while (n < b.size() && digit(b[n])) ++n;
    if (m - i != n - j) return m - i < n - j;
    if (const int order = a.compare(i, m - i, b, j, n - j); order != 0) return order < 0;
    i = m, j = n;
  }
  return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

std::map<std::string, HostNs> read_times(const std::string& path) {
  std::istringstream text(course::read_text_file(path).text);
  std::map<std::string, HostNs> times;
  std::string row;
  double last_s = -kMaxTimeS;
  for (int line = 1; std::getline(text, row); ++line) {
    if (!row.empty() && row.back() == '\r') row.pop_back();
    if (row.empty() || (line == 1 && row.starts_with("file,"))) continue;
    const auto fail = [&](const std::string& what) -> SetupError {
      return SetupError(path + ":" + std::to_string(line) + ": " + what +
                        "; a line is FILE,SECONDS");
    };
    const std::size_t comma = row.rfind(',');
    if (comma == std::string::npos) throw fail("no comma");
    double t_s = 0.0;
    const char* end = row.data() + row.size();
    const auto [stop, error] = std::from_chars(row.data() + comma + 1, end, t_s);
    if (error != std::errc{} || stop != end || !(std::abs(t_s) < kMaxTimeS)) throw fail("no time");
    if (!(t_s > last_s)) throw fail("not later than the picture before");
    last_s = t_s;
    if (!times.emplace(row.substr(0, comma), from_s(t_s)).second) throw fail("named twice");
  }
  return times;
}

}  // namespace

std::vector<PictureFile> list_pictures(const std::string& folder, std::optional<double> fps) {
  std::vector<std::string> names;
  bool timed = false;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(".")) continue;
    if (name == kTimes) {
      timed = true;
    } else if (!has_picture_name(entry->path()) || !entry->is_regular_file()) {
      throw SetupError(text::one_line(entry->path().string(), 300) +
                       ": no picture; keep only pictures and times.csv in the folder");
    } else if (names.push_back(name); names.size() > kMostPictures) {
      throw SetupError(folder + ": too many pictures; split the folder");
    }
  }
  if (error) throw SetupError(folder + ": cannot be listed (" + error.message() + ")");
  if (names.empty()) throw SetupError(folder + ": no pictures in this folder");
  if (!timed && !fps)
    throw SetupError(folder + ": no times.csv; add it or give the rate with --fps");
  std::sort(names.begin(), names.end(), comes_before);

  const fs::path base(folder);
  std::vector<PictureFile> files;
  if (!timed) {
    for (std::size_t i = 0; i < names.size(); ++i)
      files.push_back({(base / names[i]).string(), from_s(static_cast<double>(i) / *fps)});
    return files;
  }
  const std::string times_path = (base / kTimes).string();
  const std::map<std::string, HostNs> times = read_times(times_path);
  for (const std::string& name : names) {
    const auto found = times.find(name);
    if (found == times.end())
      throw SetupError(times_path + ": no time for " + text::one_line(name, 200));
    files.push_back({(base / name).string(), found->second});
  }
  for (const auto& [name, taken_ns] : times)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw SetupError(times_path + ": " + text::one_line(name, 200) + " is not in the folder");
  std::sort(files.begin(), files.end(),
            [](const PictureFile& a, const PictureFile& b) { return a.taken_ns < b.taken_ns; });
  return files;
}

bool FolderSource::next(Picture& picture) {
  if (at_ == files_.size()) return false;
  const PictureFile& file = files_[at_++];
  try {
    const Quiet quiet;
    picture.grey = cv::imread(file.path, cv::IMREAD_GRAYSCALE);
  } catch (const cv::Exception&) {
    picture.grey.release();
  }
  if (picture.grey.empty())
    throw SetupError(text::one_line(file.path, 300) +
                     ": cannot be read as a picture; remove or repair it");
  picture.taken_ns = file.taken_ns;
  return true;
}

}  // namespace tp100::camera
