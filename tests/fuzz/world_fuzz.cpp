// Fuzzes the input from an external world, as datagrams and as the paper's text file.

#include <cmath>
#include <memory>

#include "byte_source.h"
#include "worlds/peer.h"
#include "worlds/text_files.h"

namespace tp100 {
namespace {

using fuzz::require;

bool finite(const Pose& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.z_m) &&
         std::isfinite(pose.roll_rad) && std::isfinite(pose.pitch_rad) &&
         std::isfinite(pose.yaw_rad);
}

constexpr std::uint32_t kSession = 7;
constexpr std::uint16_t kPort = 40000;

// The bridge has been welcomed and has sent a pose; the input is what the world sends next, one
// datagram per line.
void converse(std::string_view text) {
  worlds::PeerSettings settings;
  settings.hello.session = kSession;
  settings.surfaces = {{"sand", 0.2}};
  worlds::Peer peer(settings);
  const auto record = std::make_unique<StepRecord>();
  HostNs now = kNsPerS;
  const auto step = [&] {
    now += 10 * kNsPerMs;
    record->now_ns = now;
    peer.step(*record, now);
  };
  const auto say = [&](std::string_view datagram) {
    const auto sample = peer.receive(datagram, kPort, now);
    if (sample)
      require(std::isfinite(sample->height_m) && std::isfinite(sample->pitch_rad) &&
                  std::isfinite(sample->slip_offset) && finite(sample->pose),
              "a sample is finite");
    peer.take_reply();
    peer.take_note();
  };
  step();
  say(R"({"v":1,"type":"welcome","session":7})");
  step();
  std::uint64_t datagrams = 1;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    say(text.substr(0, end));
    ++datagrams;
    step();
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  const worlds::PeerCounters& counters = peer.counters();
  require(counters.received == datagrams, "every datagram is counted");
  require(counters.accepted + counters.malformed + counters.wrong_version + counters.foreign +
                  counters.reordered + counters.back_in_time + counters.unknown_ack ==
              datagrams,
          "every datagram is counted once");
}

void orient(std::string_view text) {
  for (const worlds::Frame frame :
       {worlds::Frame::kRos, worlds::Frame::kUnreal, worlds::Frame::kUnity})
    if (const auto found = worlds::orientation_of(text, frame))
      require(finite(found->pose), "an orientation is finite");
}

}  // namespace
}  // namespace tp100

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  tp100::converse(text);
  tp100::orient(text);
  return 0;
}
