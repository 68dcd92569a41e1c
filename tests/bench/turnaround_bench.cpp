// turnaround_bench daemon|echo SECONDS PROGRAM [ARGUMENT...]: plays the robot on a pty whose other
// end PROGRAM (an absolute path) opens; the argument PORT stands for the name of the pty. Writes a
// sample frame every 5 ms and waits for the response: the command that answers the sample, or as
// many bytes as were sent. Prints one JSON object with the response times [us]. turnaround_bench
// --echo PORT is the simplest such program: it sends every frame back.

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "../link/pty_pair.h"
#include "../link/scripted_robot.h"
#include "../programs/process.h"
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

/// Sends back what ends with a delimiter.
int echo(const char* name) {
  const int port = ::open(name, O_RDWR | O_NOCTTY);
  if (port < 0) return 2;
  termios settings{};
  ::tcgetattr(port, &settings);
  ::cfmakeraw(&settings);
  ::tcsetattr(port, TCSANOW, &settings);
  char frame[4096];
  for (std::size_t used = 0;;) {
    pollfd wait = {port, POLLIN, 0};
    ::poll(&wait, 1, -1);
    const ssize_t n = ::read(port, frame + used, sizeof frame - used);
    if (n <= 0) return 0;
    used += static_cast<std::size_t>(n);
    if (frame[used - 1] != 0 && used < sizeof frame) continue;
    if (::write(port, frame, used) < 0) return 1;
    used = 0;
  }
}

class Robot {
 public:
  explicit Robot(bool daemon) : daemon_(daemon), robot_(monotonic_now()) { robot_.samples = false; }

  const std::string& port() const { return pty_.near(); }

  /// False if the peer does not respond.
  bool connect() {
    const HostNs give_up = monotonic_now() + kConnectNs;
    while (monotonic_now() < give_up) {
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

int run(bool daemon, double seconds, std::vector<std::string> command) {
  Robot robot(daemon);
  for (std::string& word : command)
    if (word == "PORT") word = robot.port();
  test::Process peer(command);
  // The priority is set after the fork: the peer requests its own.
  const sched_param fifo{.sched_priority = kPriority};
  const bool before_others = ::sched_setscheduler(0, SCHED_FIFO, &fifo) == 0;
  if (!robot.connect()) {
    std::fprintf(stderr, "turnaround_bench: no answer: %s\n", peer.output().c_str());
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
  if (argc == 3 && std::string(argv[1]) == "--echo") return tp100::echo(argv[2]);
  const std::string kind = argc > 3 ? argv[1] : "";
  if (kind != "daemon" && kind != "echo") {
    std::fprintf(stderr, "usage: turnaround_bench daemon|echo SECONDS PROGRAM [ARGUMENT...]\n");
    return 2;
  }
  return tp100::run(kind == "daemon", std::atof(argv[2]), {argv + 3, argv + argc});
}
