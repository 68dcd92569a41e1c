// stop_bench PRESSES ROUNDS [RUNS]: measures how soon a STOP has reached the robot. First beside a
// frozen disk, ROUNDS of each way to stop, with the longest time in which the service manager
// receives no watchdog message. Then PRESSES on an idle page, and as many while everything is asked
// for at once: the longest course is chosen again and again, 40 viewers flood the dearest requests,
// RUNS runs are listed, reports and identifications are made, and the disk hangs. Prints rows of
// JSON [ms], and the daemon's peak memory [MB]. The load runs at nice 19, as it comes from other
// machines; who measures runs in real time. Needs root and a loop device for the disk.

#include <fcntl.h>
#include <malloc.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <random>
#include <thread>

#include "../live/pty_robot.h"
#include "../server/web_client.h"
#include "../support/frozen_disk.h"
#include "../support/notify_socket.h"
#include "../support/temporary_folder.h"
#include "rig.h"
#include "server/service.h"

namespace tp100::bench {
namespace {

using namespace std::chrono_literals;
using server::Service;
using server::WebClient;

constexpr int kFlooders = 40, kReaders = 4;

/// This thread measures, and so waits for no load; `inherited`: so do the threads that it starts.
void measure_in_real_time(bool inherited) {
  const sched_param first{.sched_priority = 1};
  ::sched_setscheduler(0, SCHED_FIFO | (inherited ? 0 : SCHED_RESET_ON_FORK), &first);
}

/// A scripted robot with its daemon and a viewer.
class Rig {
 public:
  explicit Rig(const std::vector<std::string>& arguments, int keyboard = -1)
      : daemon_(link_, arguments, keyboard), viewer_(daemon_.port()) {
    measure_in_real_time(true);
    robot_.emplace(link_);
    measure_in_real_time(false);
    robot_->plug_in();
  }

  Daemon& daemon() { return daemon_; }
  WebClient& viewer() { return viewer_; }

  /// Requests a start until the robot drives, and until a recording has begun.
  void start() {
    forget();
    for (int i = 0; i < 600 && !drives(); ++i) {
      if (i % 10 == 0) viewer_.call(Service::kStart);
      std::this_thread::sleep_for(20ms);
    }
    if (!drives()) throw std::runtime_error("it does not drive: " + daemon_.process().output());
    std::this_thread::sleep_for(200ms);
    viewer_.drain();
  }
  /// Time from `press` until the robot has received a STOP, or the disarm at the end of a run.
  double pressed(const std::function<void()>& press) {
    forget();
    const auto begin = Clock::now();
    press();
    while (ms_since(begin) < 20'000 && !robot_->with([](ScriptedRobot& it) {
      return !it.received.stops.empty() || !it.received.disarms.empty();
    }))
      std::this_thread::sleep_for(100us);
    return ms_since(begin);
  }

 private:
  void forget() {
    robot_->with([](ScriptedRobot& it) { it.received = {}; });
  }
  bool drives() {
    return robot_->with([](ScriptedRobot& it) {
      return !it.received.commands.empty() && it.received.commands.back().speed_mps > 0.0F;
    });
  }

  test::TemporaryFolder folder_;
  std::string link_ = folder_.file("robot");
  Daemon daemon_;
  WebClient viewer_;
  std::optional<PtyRobot> robot_;
};

/// The longest time without WATCHDOG=1 during 3 s.
double longest_silence_ms(const test::NotifySocket& manager) {
  manager.received();
  double longest = 0.0;
  const auto begin = Clock::now();
  for (auto last = begin; ms_since(begin) < 3000.0; std::this_thread::sleep_for(1ms)) {
    for (const std::string& text : manager.received())
      if (text == "WATCHDOG=1") last = Clock::now();
    longest = std::max(longest, ms_since(last));
  }
  return longest;
}

void beside_a_frozen_disk(test::FrozenDisk& disk, int rounds) {
  const std::string name = "@tp100-stop-bench-" + std::to_string(::getpid());
  const test::NotifySocket manager(name);
  ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
  ::setenv("WATCHDOG_USEC", "2000000", 1);
  int keyboard[2];
  if (::pipe2(keyboard, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  std::vector<double> silence;
  const std::pair<const char*, std::function<void(Rig&)>> ways[] = {
      {"STOP of the page",
       [](Rig& rig) {
         // A client ends the recording, which waits for the disk, and then STOP is pressed.
         rig.viewer().call(Service::kRecordStop);
         rig.viewer().call(Service::kStop);
       }},
      {"Enter",
       [&](Rig&) {
         if (::write(keyboard[1], "\n", 1) != 1) std::perror("enter");
       }},
      {"Ctrl-C", [](Rig& rig) { rig.daemon().process().signal(SIGINT); }},
      {"SIGTERM", [](Rig& rig) { rig.daemon().process().signal(SIGTERM); }}};
  for (const auto& [way, press] : ways) {
    std::vector<double> took;
    for (int i = 0; i < rounds; ++i) {
      Rig rig({"--go", "--course", "1-straight", "--record", disk.path() + "/runs"}, keyboard[0]);
      rig.start();
      disk.freeze();
      std::this_thread::sleep_for(100ms);
      took.push_back(rig.pressed([&rig, &stop = press] { stop(rig); }));
      silence.push_back(longest_silence_ms(manager));
      disk.thaw();
      rig.daemon().process().signal(SIGTERM);
      rig.daemon().process().wait();
    }
    print("frozen disk: " + std::string(way), took);
  }
  print("frozen disk: longest silence of the watchdog in 3 s", silence);
  ::unsetenv("NOTIFY_SOCKET");
}

/// A course of a kilometre.
std::string longest_course(int segments = 1000, const std::string& line_end = "\n") {
  std::string text;
  for (const char* line : {"[fence]", "min_x_m = -5", "max_x_m = 5", "min_y_m = -5", "max_y_m = 5"})
    text += line + line_end;
  for (int i = 0; i < segments; ++i)
    for (const char* line : {"[[segment]]", "type = 'arc'", "radius_m = 0.95", "angle_deg = 60"})
      text += line + line_end;
  return text;
}

/// Everything that others may ask for, until the end of the object.
class Load {
 public:
  Load(std::string port, test::FrozenDisk& disk) : port_(std::move(port)), disk_(disk) {
    for (int i = 0; i < kFlooders; ++i) add([this, i] { flood(i); });
    for (int i = 0; i < kReaders; ++i) add([this] { read(); });
    add([this] {
      connected([](WebClient& client) {
        client.call(Service::kChoose, R"({"course":"longest"})");
        std::this_thread::sleep_for(200ms);
      });
    });
    add([this] {
      connected([](WebClient& client) {
        client.call(Service::kRunReport, R"({"run":"seen"})");
        std::this_thread::sleep_for(700ms);
        client.call(Service::kRunIdentify, R"({"runs":"seen"})");
        std::this_thread::sleep_for(700ms);
      });
    });
    add([this] {
      connected([this](WebClient& client) {
        client.call(Service::kRecordStart);
        std::this_thread::sleep_for(300ms);
        disk_.freeze();
        client.call(Service::kRecordStop);
        std::this_thread::sleep_for(1s);
        disk_.thaw();
      });
    });
  }
  ~Load() {
    over_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

  std::atomic<std::size_t> requests{0}, lists{0};

 private:
  /// Runs `work` as another machine would: whenever the processors have nothing else to do.
  template <class Do>
  void add(Do work) {
    threads_.emplace_back([work] {
      ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 19);
      work();
    });
  }
  template <class Once>
  void connected(Once once) {
    while (!over_) {
      try {
        WebClient client(port_);
        while (!over_ && !client.closed()) once(client);
      } catch (const std::runtime_error&) {
        std::this_thread::sleep_for(20ms);
      }
    }
  }
  // Every second one never reads its answers, and is closed once the daemon gives it up.
  void flood(int number) {
    std::string all, none;
    for (std::uint32_t i = 1; i <= messages::kChannelCount; ++i) {
      const std::string id = std::to_string(i), comma = i > 1 ? "," : "";
      all += comma + R"({"id":)" + id + R"(,"channelId":)" + id + "}";
      none += comma + id;
    }
    const std::vector<std::string> texts = {
        R"({"op":"getParameters","parameterNames":[],"id":"a"})",
        R"({"op":"subscribe","subscriptions":[)" + all + "]}",
        R"({"op":"unsubscribe","subscriptionIds":[)" + none + "]}",
        R"({"op":"subscribeParameterUpdates","parameterNames":[]})"};
    const std::string check =
        R"({"kind":"course","name":"dear","text":")" + longest_course(900, "\\n") + "\"}";
    std::size_t next = static_cast<std::size_t>(number);
    connected([&](WebClient& client) {
      const std::size_t which = next++ % (texts.size() + 1);
      which < texts.size() ? client.write_text(texts[which])
                           : client.call(Service::kFileCheck, check);
      if (number % 2 == 0) client.drain();
      ++requests;
    });
  }
  void read() {
    while (!over_) {
      for (const char* target : {"/api/runs", "/api/history/estimate", "/healthz", "/api/setup"}) {
        try {
          const std::string answer = server::http_get(
              port_, std::string("GET ") + target + " HTTP/1.0\r\nHost: localhost\r\n\r\n");
          if (answer.find("200 OK") != std::string::npos) ++lists;
        } catch (const std::runtime_error&) {
        }
        std::this_thread::sleep_for(5ms);
      }
    }
  }

  std::string port_;
  test::FrozenDisk& disk_;
  std::atomic<bool> over_{false};
  std::vector<std::thread> threads_;
};

std::vector<double> press(Rig& rig, int presses) {
  std::vector<double> took;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> pause_us(10'000, 20'000);
  for (int i = 0; i < presses; ++i) {
    took.push_back(rig.pressed([&] { rig.viewer().call(Service::kStop); }));
    if (rig.viewer().closed()) throw std::runtime_error("the viewer that presses STOP was closed");
    rig.viewer().take();
    std::this_thread::sleep_for(std::chrono::microseconds(pause_us(random)));
  }
  return took;
}

double peak_mb(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1000.0;
  return 0.0;
}

void beside_everything(test::FrozenDisk& disk, int presses, int runs) {
  const test::TemporaryFolder folder;
  const std::string kept = disk.path() + "/runs";
  for (int i = 0; i < runs; ++i) {
    const std::string run = kept + "/run-" + std::to_string(i);
    std::filesystem::create_directories(run);
    std::ofstream(run + "/run.mcap") << 'x';
  }
  std::filesystem::create_directories(folder.file("library/courses"));
  std::ofstream(folder.file("library/courses/longest.toml")) << longest_course();
  std::ofstream(folder.file("tp100.toml"))
      << "library = \"" << folder.file("library") << "\"\ncourse = \"longest\"\n";
  Rig rig({"--config", folder.file("tp100.toml"), "--record", kept});
  if (!rig.daemon().process().wait_for("ready")) throw std::runtime_error("no robot");
  rig.viewer().call(Service::kRecordStart, R"({"name":"seen"})");
  std::this_thread::sleep_for(1s);
  rig.viewer().call(Service::kRecordStop);
  std::this_thread::sleep_for(1s);
  rig.viewer().take();
  print("an idle daemon: STOP of the page", press(rig, presses));
  print("peak memory before the load [MB]", {peak_mb(rig.daemon().process().pid())});
  {
    const Load load(rig.daemon().port(), disk);
    std::this_thread::sleep_for(3s);
    const std::vector<double> took = press(rig, presses);
    print("beside " + std::to_string(load.requests) + " requests and " +
              std::to_string(load.lists) + " lists of " + std::to_string(runs) +
              " runs: STOP of the page",
          took);
  }
  print("peak memory [MB]", {peak_mb(rig.daemon().process().pid())});
  rig.daemon().process().signal(SIGTERM);
  rig.daemon().process().wait();
}

}  // namespace
}  // namespace tp100::bench

int main(int argc, char** argv) try {
  using namespace tp100::bench;
  if (argc < 3) throw std::runtime_error("usage: stop_bench PRESSES ROUNDS [RUNS]");
  std::signal(SIGPIPE, SIG_IGN);
  // The robot's thread must wait for no lock that a thread of the load holds: a heap for each.
  ::mallopt(M_ARENA_MAX, 1000);
  tp100::test::FrozenDisk disk;
  if (!disk.available())
    throw std::runtime_error("no file system can be frozen (root, loop device)");
  beside_a_frozen_disk(disk, std::atoi(argv[2]));
  beside_everything(disk, std::atoi(argv[1]), argc > 3 ? std::atoi(argv[3]) : 5000);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "stop_bench: %s\n", error.what());
  return 1;
}
