#include "camera/image_pipe.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <exception>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "core/clock.h"
#include "core/error.h"
#include "text/format.h"

namespace tp100::camera {
namespace {

constexpr std::size_t kMaxHeader = 1024;
constexpr int kMaxSide = 16384;
constexpr std::size_t kMaxPixels = 64'000'000;
constexpr double kMaxStampS = 1e9;
constexpr std::string_view kStamp = "taken_s";

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Thrown if stop_fd can be read during a wait.
class Stopped : public std::exception {};

class PipeSource : public Source {
 public:
  PipeSource(int descriptor, const std::string& name, const SourceOptions& options)
      : descriptor_(descriptor),
        stop_fd_(options.stop_fd),
        name_(one_line(name, 300)),
        delay_ns_(from_s(options.delay_s)) {}
  ~PipeSource() override {
    if (descriptor_ != STDIN_FILENO) ::close(descriptor_);
  }
  bool next(Image& image) override;
  bool live() const override { return true; }
  bool ends() const override { return true; }

 private:
  struct Header {
    bool colour = false;
    std::optional<double> taken_s;
    std::array<int, 3> numbers{};  ///< width, height, largest value
  };
  Header header();
  std::string word(Header& header);
  void comment(Header& header);
  char one();
  bool fill();
  void read(std::span<unsigned char> bytes);
  UserError fault(const std::string& what) const {
    return UserError(name_ + ": image " + std::to_string(images_ + 1) + ": " + what);
  }

  int descriptor_;
  int stop_fd_;
  std::string name_;
  HostNs delay_ns_;
  std::array<char, 65536> buffer_{};
  std::size_t begin_ = 0, end_ = 0;
  std::size_t header_size_ = 0;
  std::size_t images_ = 0;
};

/// Waits for bytes. False: no more come. Throws Stopped.
bool PipeSource::fill() {
  std::array<pollfd, 2> waiting{{{descriptor_, POLLIN, 0}, {stop_fd_, POLLIN, 0}}};
  ssize_t got = 0;
  do {
    got = ::poll(waiting.data(), waiting.size(), -1);
  } while (got < 0 && errno == EINTR);
  if (waiting[1].revents != 0) throw Stopped();
  if (got > 0) got = ::read(descriptor_, buffer_.data(), buffer_.size());
  if (got < 0) throw UserError(name_ + ": cannot be read (" + std::strerror(errno) + ")");
  if (got == 0) return false;
  begin_ = 0;
  end_ = static_cast<std::size_t>(got);
  return true;
}

char PipeSource::one() {
  if (++header_size_ > kMaxHeader) throw fault("its header does not end; write P5 or P6");
  if (begin_ == end_ && !fill()) throw fault("the pipe ends within its header");
  return buffer_[begin_++];
}

void PipeSource::read(std::span<unsigned char> bytes) {
  while (!bytes.empty()) {
    if (begin_ == end_ && !fill()) throw fault("the pipe ends within its pixels");
    const std::size_t count = std::min(bytes.size(), end_ - begin_);
    std::memcpy(bytes.data(), buffer_.data() + begin_, count);
    begin_ += count;
    bytes = bytes.subspan(count);
  }
}

/// Reads a comment, after its '#', to the end of the line.
void PipeSource::comment(Header& header) {
  std::string text;
  for (char c = one(); c != '\n'; c = one()) text += c;
  std::string_view rest = text;
  while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
  if (!rest.starts_with(kStamp)) return;
  rest.remove_prefix(kStamp.size());
  while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
  header.taken_s = text::number_in<double>(rest);
  if (!header.taken_s || !(std::abs(*header.taken_s) < kMaxStampS))
    throw fault("no time after taken_s; write seconds");
}

/// The next word of the header, and the one white space that ends it.
std::string PipeSource::word(Header& header) {
  std::string text;
  for (char c = one();; c = one()) {
    if (c == '#' && text.empty()) {
      comment(header);
    } else if (!is_space(c)) {
      text += c;
    } else if (!text.empty()) {
      return text;
    }
  }
}

PipeSource::Header PipeSource::header() {
  Header header;
  header_size_ = 0;
  const std::string magic = word(header);
  if (magic != "P5" && magic != "P6")
    throw fault("not a netpbm image (P5 or P6); ffmpeg makes them with -f image2pipe -c:v pgm");
  header.colour = magic == "P6";
  for (int& number : header.numbers) {
    const std::string digits = word(header);
    const std::optional<int> value = text::number_in<int>(digits);
    const bool side = &number != &header.numbers.back();  // the largest value is checked below
    if (!value || *value < 1 || (side && *value > kMaxSide))
      throw fault(one_line(digits, 40) + " is not a number from 1 to " + std::to_string(kMaxSide));
    number = *value;
  }
  const auto [width, height, most] = header.numbers;
  if (most != 255) throw fault("its largest value is not 255; write 8 bits");
  if (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > kMaxPixels)
    throw fault("too large; write at most " + std::to_string(kMaxPixels) + " pixels");
  return header;
}

bool PipeSource::next(Image& image) try {
  if (begin_ == end_ && !fill()) return false;
  const Header found = header();
  // A matrix of its own for every image: the last one may still be in use.
  cv::Mat pixels(found.numbers[1], found.numbers[0], found.colour ? CV_8UC3 : CV_8U);
  read({pixels.data, pixels.total() * pixels.elemSize()});
  const HostNs arrived = monotonic_now();
  if (found.colour) {
    cv::cvtColor(pixels, image.grey, cv::COLOR_RGB2GRAY);
    cv::cvtColor(pixels, pixels, cv::COLOR_RGB2BGR);
  } else {
    image.grey = pixels;
  }
  image.shown = pixels;
  image.taken_ns = found.taken_s ? from_s(*found.taken_s) : arrived - delay_ns_;
  ++images_;
  return true;
} catch (const Stopped&) {
  return false;
}

}  // namespace

std::unique_ptr<Source> open_image_pipe(int descriptor, const std::string& name,
                                        const SourceOptions& options) {
  return std::make_unique<PipeSource>(descriptor, name, options);
}

}  // namespace tp100::camera
