// turnaround_bench daemon|echo SECONDS PROGRAM [ARGUMENT...]: plays the robot on a pty whose other
// end PROGRAM opens; the argument PORT stands for the name of the pty. Writes a sample frame every
// 5 ms and waits for the response: the command that answers the sample, or as many bytes as were
// sent. Prints one JSON object with the response times [us].

#include <sched.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "../link/pty_pair.h"
#include "../link/scripted_robot.h"
#include "bench_peer.h"
#include "core/clock.h"
#include "loop/pacing.h"

namespace tp100 {
namespace {

constexpr HostNs kSampleNs = wire::kSamplePeriodUs * kNsPerUs;
constexpr HostNs kPatienceNs = kNsPerS;
constexpr HostNs kConnectNs = 30 * kNsPerS;
// This covers the clock sync and the first cycles.
constexpr HostNs kWarmUpNs = kNsPerS;
// The priority is above that of the peer: a real robot does not wait for the host's processor.
constexpr int kPriority = 90;

int milliseconds_until(HostNs at) {
  return static_cast<int>(std::max<HostNs>(0, at - monotonic_now()) / kNsPerMs);
}

class Robot {
 public:
  explicit Robot(bool daemon) : daemon_(daemon), robot_(monotonic_now()) { robot_.samples = false; }

  const std::string& port() const { return pty_.near(); }

  /// False if the peer does not respond.
  bool connect(test::BenchPeer& peer) {
    const HostNs give_up = monotonic_now() + kConnectNs;
    while (monotonic_now() < give_up && !peer.ended()) {
      // A pty loses nothing: it buffers what is written before the peer is ready.
      if (daemon_ ? greet() : exchange() >= 0) return true;
    }
    return false;
  }

  /// Time from sample to answer, negative if there is none. [ns]
  HostNs exchange() {
    const HostNs began = monotonic_now();
    const auto frame = frame_of(robot_.sample(began));
    robot_.received.commands.clear();
    pty_.write(frame);
    std::size_t echoed = 0;
    while (pty_.wait(milliseconds_until(began + kPatienceNs))) {
      const auto bytes = pty_.read();
      const HostNs now = monotonic_now();
      echoed += bytes.size();
      if (daemon_) hear(bytes, now);
      const bool over = daemon_ ? answered() : echoed >= frame.size();
      if (!over) continue;
      ++robot_.sequence;
      return now - began;
    }
    ++robot_.sequence;
    return -1;
  }

 private:
  bool greet() {
    pty_.wait(1);
    const HostNs now = monotonic_now();
    hear(pty_.read(), now);
    robot_.tick(now);
    pty_.write(robot_.take());
    return robot_.state >= wire::State::kDisarmed && robot_.received.sync_requests > 4;
  }
  void hear(const std::vector<std::uint8_t>& bytes, HostNs now) {
    robot_.receive(bytes, now);
    pty_.write(robot_.take());
  }
  bool answered() const {
    const auto& commands = robot_.received.commands;
    return !commands.empty() && commands.back().answers == robot_.sequence;
  }

  bool daemon_;
  PtyPair pty_;
  ScriptedRobot robot_;
};

int run(bool daemon, double seconds, const std::vector<std::string>& command) {
  Robot robot(daemon);
  test::BenchPeer peer(command, robot.port());
  // The priority is set after the fork: the peer requests its own.
  const sched_param fifo{.sched_priority = kPriority};
  const bool before_others = ::sched_setscheduler(0, SCHED_FIFO, &fifo) == 0;
  if (!robot.connect(peer)) {
    std::fprintf(stderr, "turnaround_bench: %s does not answer\n", command[0].c_str());
    return 1;
  }
  const HostNs begin = monotonic_now() + kWarmUpNs;
  const HostNs end = begin + from_s(seconds);
  std::printf("{\"us\":[");
  const char* comma = "";
  int unanswered = 0;
  for (HostNs due = monotonic_now(); due < end;) {
    loop::sleep_until(due);
    const HostNs took = robot.exchange();
    if (due >= begin && took >= 0) {
      std::printf("%s%.2f", comma, static_cast<double>(took) * 1e-3);
      comma = ",";
    }
    unanswered += took < 0 ? 1 : 0;
    // A late answer skips the samples that were due meanwhile.
    while (due <= monotonic_now()) due += kSampleNs;
  }
  std::printf("],\"unanswered\":%d,\"before_others\":%s}\n", unanswered,
              before_others ? "true" : "false");
  return 0;
}

}  // namespace
}  // namespace tp100

int main(int argc, char** argv) {
  const std::string kind = argc > 3 ? argv[1] : "";
  if (kind != "daemon" && kind != "echo") {
    std::fprintf(stderr, "usage: turnaround_bench daemon|echo SECONDS PROGRAM [ARGUMENT...]\n");
    return 2;
  }
  return tp100::run(kind == "daemon", std::atof(argv[2]), {argv + 3, argv + argc});
}
