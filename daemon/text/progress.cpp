#include "text/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "text/format.h"

namespace tp100::text {
namespace {

constexpr double kShortS = 2.0;

std::string duration_text(double seconds) {
  const auto whole_s = static_cast<long long>(std::ceil(seconds));
  if (whole_s < 60) return format("%lld s", whole_s);
  if (whole_s < 3600) return format("%lld min %02lld s", whole_s / 60, whole_s % 60);
  return format("%lld h %02lld min", whole_s / 3600, whole_s % 3600 / 60);
}

}  // namespace

std::string progress_text(std::string_view noun, std::uint64_t done, std::uint64_t all,
                          double elapsed_s) {
  const std::string text = std::to_string(done) + " of " + counted(all, noun);
  if (done == 0) return text;
  const double left_s = elapsed_s * static_cast<double>(all - done) / static_cast<double>(done);
  return text + ", " + duration_text(left_s) + " left";
}

Progress::Progress(std::string noun, std::uint64_t all)
    : noun_(std::move(noun)), all_(all), terminal_(::isatty(STDERR_FILENO) == 1) {}

void Progress::step() {
  ++done_;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - began_;
  if (!terminal_ || done_ > all_ || elapsed.count() < kShortS) return;
  std::fprintf(stderr, "\r\x1b[K%s", progress_text(noun_, done_, all_, elapsed.count()).c_str());
  shown_ = true;
}

void Progress::clear() {
  if (std::exchange(shown_, false)) std::fputs("\r\x1b[K", stderr);
}

}  // namespace tp100::text
