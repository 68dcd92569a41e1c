// decode_bench ROUNDS: measures the time to decode a received frame. Prints rows of JSON.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "../link/scripted_robot.h"
#include "link/frame_reader.h"
#include "link/session.h"
#include "wire/frame.h"
#include "wire/messages.h"

namespace tp100 {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kFrames = 20'000;

struct Stream {
  std::vector<std::uint8_t> bytes;
  int frames = 0;
};

/// Samples of a moving robot: most of their bytes differ from frame to frame.
Stream samples() {
  std::mt19937 random(1);
  const auto noise = [&](int range) {
    return static_cast<int>(random() % static_cast<unsigned>(2 * range)) - range;
  };
  Stream stream;
  wire::Sample sample{};
  sample.battery_mv = 7900;
  sample.state = static_cast<std::uint8_t>(wire::State::kRunning);
  for (; stream.frames < kFrames; ++stream.frames) {
    ++sample.sequence;
    sample.device_us += wire::kSamplePeriodUs;
    sample.left_counts += 5 + noise(3);
    sample.right_counts += 5 + noise(3);
    for (auto& rate : sample.gyro) rate = static_cast<std::int16_t>(noise(2000));
    for (auto& force : sample.accel) force = static_cast<std::int16_t>(noise(8192));
    sample.left_duty = static_cast<std::int16_t>(400 + noise(100));
    sample.right_duty = static_cast<std::int16_t>(400 + noise(100));
    sample.last_command = sample.sequence;
    const auto frame = frame_of(sample);
    stream.bytes.insert(stream.bytes.end(), frame.begin(), frame.end());
  }
  return stream;
}

/// Random bytes with regular delimiters, as received at a wrong baud rate.
Stream garbage() {
  std::mt19937 random(2);
  Stream stream;
  stream.frames = kFrames;
  for (int i = 0; i < kFrames * 44; ++i) {
    stream.bytes.push_back(static_cast<std::uint8_t>(random()));
    if (i % 44 == 43) stream.bytes.back() = wire::kDelimiter;
  }
  return stream;
}

volatile std::uint64_t g_kept = 0;

std::uint64_t decode(const Stream& stream) {
  wire::FrameDecoder decoder;
  std::uint64_t kept = 0;
  for (const std::uint8_t byte : stream.bytes)
    if (decoder.push(byte) == wire::DecodeResult::kFrame) kept += decoder.size();
  return kept;
}

std::uint64_t decode_and_read(const Stream& stream) {
  LinkCounters counters{};
  link::FrameReader reader(counters);
  wire::Sample sample{};
  std::uint64_t kept = 0;
  for (const std::uint8_t byte : stream.bytes)
    if (reader.push(byte) && wire::read_payload(reader.payload(), reader.size(), sample))
      kept += sample.sequence;
  return kept;
}

template <class Receive>
void measure(const char* what, const Stream& stream, int rounds, Receive receive) {
  std::vector<double> ns;
  for (int i = 0; i < rounds + 1; ++i) {
    const Clock::time_point began = Clock::now();
    g_kept = g_kept + receive(stream);
    const std::chrono::duration<double, std::nano> took = Clock::now() - began;
    // The first round is a warm-up.
    if (i > 0) ns.push_back(took.count() / stream.frames);
  }
  std::sort(ns.begin(), ns.end());
  const double median = ns[ns.size() / 2];
  const double size = static_cast<double>(stream.bytes.size()) / stream.frames;
  std::printf(
      "{\"what\":\"%s\",\"frame_bytes\":%d,\"ns_per_frame\":%.2f,\"slowest_round_ns\":%.2f,"
      "\"mb_per_s\":%.2f,\"frames_per_s\":%.0f}\n",
      what, static_cast<int>(size + 0.5), median, ns.back(), size / median * 1e3, 1e9 / median);
}

void bench(int rounds) {
  const Stream good = samples();
  measure("frame: COBS and CRC", good, rounds, decode);
  measure("frame and fields of a sample", good, rounds, decode_and_read);
  measure("garbage between delimiters", garbage(), rounds, decode);
}

}  // namespace
}  // namespace tp100

int main(int argc, char** argv) {
  tp100::bench(argc > 1 ? std::max(1, std::atoi(argv[1])) : 50);
  return 0;
}
