// Golden trace of the datagrams of cameras with other clocks, delays, gaps and restarts.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "jpeg.h"
#include "link/camera_intake.h"
#include "numbers.h"
#include "support/golden_trace.h"

namespace tp100::link {
namespace {

std::vector<std::string> columns() {
  return {"used",  "measured_us", "sequence", "x",         "y",
          "yaw",   "received",    "accepted", "malformed", "late",
          "early", "foreign",     "missing",  "dropped",   "streams"};
}

std::vector<double> row(const CameraCounters& counters, double used, double measured_us,
                        double sequence, double x, double y, double yaw) {
  return {used,
          measured_us,
          sequence,
          x,
          y,
          yaw,
          static_cast<double>(counters.received),
          static_cast<double>(counters.accepted),
          static_cast<double>(counters.malformed),
          static_cast<double>(counters.late),
          static_cast<double>(counters.early),
          static_cast<double>(counters.foreign),
          static_cast<double>(counters.missing),
          static_cast<double>(counters.dropped),
          static_cast<double>(counters.streams)};
}

TEST(CameraTrace, DetectionsOfTwoCamerasOnThreeClocks) {
  test::GoldenTrace trace("link/camera.csv", columns());
  CameraIntake intake("here", 300 * kNsPerMs);
  Numbers numbers(99);
  HostNs now = 100 * kNsPerS;
  std::uint32_t sequence = 40;
  for (int i = 0; i < 600; ++i) {
    const bool quiet = i % 50 == 49;
    now += quiet ? (i % 100 == 49 ? 950 * kNsPerMs : 5200 * kNsPerMs)
                 : 23 * kNsPerMs + numbers.below(9000) * kNsPerUs;
    if (i == 333) now += 11 * kNsPerS;
    const HostNs ahead_ns = i < 200 ? 0 : (7000 + i / 300) * kNsPerS + i * 11 * kNsPerUs;
    const HostNs age_ns =
        (HostNs{30} + numbers.below(60) + (i % 29 == 7 ? 200 + i / 5 : 0)) * kNsPerMs;
    const HostNs delay_ns = (i % 8 == 3 ? 15'000 : 300) * kNsPerUs + numbers.below(2000) * kNsPerUs;
    const HostNs early_ns = i % 37 == 12 ? age_ns + delay_ns + (7 + i / 37) * kNsPerMs : 0;
    sequence += 1 + (i % 11 == 5 ? 3U : 0U);
    CameraMessage message;
    message.stream = i % 13 == 8 || (i > 260 && i < 290) ? 8U : 5U;
    message.clock = i < 200 ? "here" : i < 450 ? "there" : i % 90 == 17 ? "elsewhere" : "there";
    message.sequence = i % 17 == 9 ? sequence - 2 : i == 555 ? sequence + 9000 : sequence;
    message.stamp_us = (now - age_ns - delay_ns + ahead_ns + early_ns) / kNsPerUs;
    message.age_us = age_ns / kNsPerUs;
    message.x_m = std::sin(i * 0.1);
    message.y_m = 2.0 * std::cos(i * 0.07) - 0.4;
    message.yaw_rad = 0.01 * i - 2.0;
    const std::string datagram = i % 43 == 20 ? "rubbish" : encode(message);
    const auto sample = intake.receive(datagram, now);
    if (sample && i % 21 == 4) intake.count_dropped();
    if (i % 50 > 12 && i % 50 < 46 && sample && i % 3 != 0) continue;
    trace.row(sample
                  ? row(intake.counters(), 1, static_cast<double>(now - sample->measured_ns) * 1e-3,
                        static_cast<double>(sample->sequence), sample->x_m, sample->y_m,
                        sample->yaw_rad)
                  : row(intake.counters(), 0, 0, 0, 0, 0, 0));
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(CameraTrace, ImagesMoreOftenAndLessOftenThanAskedFor) {
  test::GoldenTrace trace("link/camera_images.csv", columns());
  CameraIntake intake("here", 500 * kNsPerMs);
  Numbers numbers(99);
  HostNs now = 100 * kNsPerS;
  const std::string jpeg = test::jpeg(640, 480);
  for (int i = 0; i < 400; ++i) {
    now += (i / 100 % 2 == 0 ? 30 : 110) * kNsPerMs + numbers.below(20) * kNsPerMs;
    if (i % 90 == 80) now += 1500 * kNsPerMs;
    ImageMessage message;
    message.stream = i % 70 == 33 ? 2 : 1;
    message.clock = "here";
    message.sequence = static_cast<std::uint32_t>(i + i / 9);
    message.stamp_us = (now - (40 + numbers.below(40)) * kNsPerMs) / kNsPerUs;
    message.jpeg = jpeg;
    const HostNs interval_ns = (i < 200 ? 100 : 70) * kNsPerMs;
    const auto image = intake.receive_image(encode(message), interval_ns, now);
    trace.row(row(intake.counters(), image.has_value(),
                  image ? static_cast<double>(now - image->taken_ns) * 1e-3 : 0.0,
                  image ? static_cast<double>(image->jpeg.size()) : 0.0, 0, 0, 0));
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(CameraTrace, TheOffsetOfAClockThatDriftsAndWasDelayed) {
  test::GoldenTrace trace("link/clock_offset.csv", {"offset_us"});
  const auto offset_at = std::make_unique<ClockOffset>();
  ClockOffset& offset = *offset_at;
  Numbers numbers(99);
  HostNs now = 50 * kNsPerS;
  trace.row({static_cast<double>(offset.offset_ns())});
  for (int i = 0; i < 500; ++i) {
    now += 90 * kNsPerMs + numbers.below(30) * kNsPerMs;
    if (i % 120 == 100) now += (i < 240 ? 4 : i < 360 ? 6 : 11) * kNsPerS;
    if (i == 450) offset.reset();
    if (i == 450) trace.row({static_cast<double>(offset.offset_ns())});
    const HostNs drift_ns = (i < 250 ? i : 500 - i) * 70 * kNsPerUs;
    offset.add(now + drift_ns - 3 * kNsPerS, now + numbers.below(4000) * kNsPerUs);
    trace.row({static_cast<double>(offset.offset_ns() - 3 * kNsPerS) * 1e-3});
  }
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::link
