// stop_load_bench [PRESSES [RUNS]]: presses STOP on a viewer's socket while nobody else asks for
// anything, and then while everything else is asked for: the longest course is chosen again and
// again, 40 viewers flood the dearest requests, RUNS runs are listed, a report and an
// identification are made, and the disk of the recordings hangs. Prints rows of JSON: the time from
// the press until the robot has received it [ms], and the daemon's peak memory [MB]. The load runs
// at nice 19, as it comes from other machines; who measures runs in real time. Needs root and a
// loop device for the disk.

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "../live/pty_robot.h"
#include "../programs/process.h"
#include "../server/web_client.h"
#include "../support/frozen_disk.h"
#include "../support/temporary_folder.h"
#include "core/statistics.h"

namespace tp100 {
namespace {

using namespace std::chrono_literals;
using server::WebClient;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kStop = 3, kRecordStart = 4, kRecordStop = 5, kChoose = 9, kFileCheck = 13,
                        kRunReport = 20, kRunIdentify = 23;
constexpr int kFlooders = 40, kReaders = 4;
constexpr auto kPause = 10ms;

double ms_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

void in_real_time() {
  sched_param param{};
  param.sched_priority = 1;
  ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &param);
}

void as_another_machine() {
  const sched_param param{};
  ::pthread_setschedparam(::pthread_self(), SCHED_OTHER, &param);
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 19);
}

std::string call_of(std::uint32_t service, const std::string& json) {
  std::string bytes = {'\x02', static_cast<char>(service), 0, 0, 0, 1, 0, 0, 0, 4, 0, 0, 0};
  return bytes + "json" + json;
}

std::string in_json(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\n' ? std::string("\\n") : std::string(1, c);
  return out;
}

/// A course of a kilometre, in 1000 segments.
std::string longest_course() {
  std::string text = "[fence]\nmin_x_m = -5\nmax_x_m = 5\nmin_y_m = -5\nmax_y_m = 5\n";
  for (int i = 0; i < 1000; ++i)
    text += "[[segment]]\ntype = 'arc'\nradius_m = 0.95\nangle_deg = 60\n";
  return text;
}

std::size_t peak_mb(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stoul(line.substr(6)) / 1000;
  return 0;
}

void print(const std::string& what, std::vector<double> values) {
  std::printf("{\"what\":\"%s\",\"count\":%zu,\"p50\":%.2f,\"p99\":%.2f,\"max\":%.2f}\n",
              what.c_str(), values.size(), percentile(values, 0.5), percentile(values, 0.99),
              percentile(values, 1.0));
  std::fflush(stdout);
}

class Daemon {
 public:
  Daemon(const std::string& runs, const std::string& link, const test::TemporaryFolder& folder) {
    std::filesystem::create_directories(folder.file("library/courses"));
    std::ofstream(folder.file("library/courses/longest.toml")) << longest_course();
    std::ofstream(folder.file("tp100.toml"))
        << "library = \"" << folder.file("library") << "\"\ncourse = \"longest\"\n";
    process_ = std::make_unique<test::Process>(std::vector<std::string>{
        "tp100d", "run", "--port", link, "--wait", "--stay", "--config", folder.file("tp100.toml"),
        "--record", runs, "--listen", "127.0.0.1:0"});
    const std::string before = "http://127.0.0.1:";
    if (!process_->wait_for(before) || !process_->wait_for("/"))
      throw std::runtime_error("no page: " + process_->output());
    const std::string& output = process_->output();
    const std::size_t at = output.find(before) + before.size();
    port_ = output.substr(at, output.find('/', at) - at);
  }
  const std::string& port() const { return port_; }
  test::Process& process() { return *process_; }

 private:
  std::unique_ptr<test::Process> process_;
  std::string port_;
};

/// Everything that others may ask for, until the end of the object.
class Load {
 public:
  Load(std::string port, test::FrozenDisk& disk) : port_(std::move(port)), disk_(disk) {
    std::string corners;
    for (int i = 0; i < 100; ++i)
      corners += "[" + std::to_string(4.0 + 0.01 * (i % 2)) + "," + std::to_string(0.01 * i) + "],";
    std::string dear = longest_course().substr(0, 55'000);
    dear.resize(dear.rfind("[[segment]]"));
    check_ = R"({"kind":"course","name":"dear","text":")" + in_json(dear) + "\"}";
    for (int i = 0; i < kFlooders; ++i) add([this, i] { flood(i); });
    for (int i = 0; i < kReaders; ++i) add([this] { read(); });
    add([this] { choose(); });
    add([this] { analyse(); });
    add([this] { hang(); });
  }
  ~Load() {
    over_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

  std::atomic<std::size_t> requests{0}, closed{0}, lists{0}, choices{0}, hangs{0}, analyses{0};

 private:
  template <class Do>
  void add(Do work) {
    threads_.emplace_back([work] {
      as_another_machine();
      work();
    });
  }
  template <class Once>
  void connected(Once once) {
    while (!over_) {
      try {
        WebClient client(port_);
        while (!over_ && !client.closed()) once(client);
        if (!over_) ++closed;
      } catch (const std::runtime_error&) {
        std::this_thread::sleep_for(20ms);
      }
    }
  }
  // Every second one never reads its answers.
  void flood(int number) {
    const bool deaf = number % 2 == 1;
    std::string all = R"({"op":"subscribe","subscriptions":[)", none;
    for (std::uint32_t i = 1; i <= messages::kChannelCount; ++i) {
      const std::string id = std::to_string(i);
      all += (i > 1 ? "," : "") + (R"({"id":)" + id + R"(,"channelId":)" + id + "}");
      none += (i > 1 ? "," : "") + id;
    }
    while (!over_) {
      try {
        WebClient client(port_);
        for (std::size_t i = 0; !over_ && (deaf ? i < 400 : !client.closed()); ++i) {
          switch ((i + static_cast<std::size_t>(number)) % 5) {
            case 0:
              client.write_text(R"({"op":"getParameters","parameterNames":[],"id":"a"})");
              break;
            case 1:
              client.write_text(all + "]}");
              break;
            case 2:
              client.write_text(R"({"op":"unsubscribe","subscriptionIds":[)" + none + "]}");
              break;
            case 3:
              client.write_binary(call_of(kFileCheck, check_));
              break;
            default:
              client.write_text(R"({"op":"subscribeParameterUpdates","parameterNames":[]})");
          }
          ++requests;
        }
        ++closed;
        // The kernel has what the daemon wrote; it holds the rest until it gives up.
        for (int i = 0; deaf && i < 30 && !over_; ++i) std::this_thread::sleep_for(100ms);
      } catch (const std::runtime_error&) {
        std::this_thread::sleep_for(20ms);
      }
    }
  }
  void read() {
    while (!over_) {
      for (const char* target : {"/api/runs", "/api/history/estimate", "/metrics", "/api/setup"}) {
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
  void choose() {
    connected([this](WebClient& client) {
      client.write_binary(call_of(kChoose, R"({"course":"longest"})"));
      ++choices;
      std::this_thread::sleep_for(200ms);
    });
  }
  void analyse() {
    connected([this](WebClient& client) {
      client.write_binary(call_of(kRunReport, R"({"run":"seen"})"));
      std::this_thread::sleep_for(700ms);
      client.write_binary(call_of(kRunIdentify, R"({"runs":"seen"})"));
      std::this_thread::sleep_for(700ms);
      ++analyses;
    });
  }
  void hang() {
    connected([this](WebClient& client) {
      client.call(kRecordStart);
      std::this_thread::sleep_for(300ms);
      if (!disk_.freeze()) throw std::runtime_error("the disk cannot be frozen");
      client.call(kRecordStop);
      ++hangs;
      std::this_thread::sleep_for(1s);
      disk_.thaw();
    });
  }

  std::string port_, check_;
  test::FrozenDisk& disk_;
  std::atomic<bool> over_{false};
  std::vector<std::thread> threads_;
};

/// Times from a press on `viewer` until the robot has received a STOP.
std::vector<double> press(WebClient& viewer, PtyRobot& robot, int presses) {
  std::vector<double> took;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> later_us(0, 10'000);
  for (int i = 0; i < presses; ++i) {
    robot.with([](ScriptedRobot& it) { it.received = {}; });
    const auto begin = Clock::now();
    viewer.call(kStop);
    while (ms_since(begin) < 20'000 &&
           robot.with([](ScriptedRobot& it) { return it.received.stops.empty(); }))
      std::this_thread::sleep_for(100us);
    took.push_back(ms_since(begin));
    if (viewer.closed()) throw std::runtime_error("the viewer that presses STOP was closed");
    viewer.take();
    std::this_thread::sleep_for(kPause + std::chrono::microseconds(later_us(random)));
  }
  return took;
}

void measure(int presses, int runs) {
  test::FrozenDisk disk;
  if (!disk.available()) throw std::runtime_error("no file system can be frozen here");
  const test::TemporaryFolder folder;
  const std::string kept = disk.path() + "/runs";
  for (int i = 0; i < runs; ++i) {
    const std::string run = kept + "/run-" + std::to_string(i);
    std::filesystem::create_directories(run);
    std::ofstream(run + "/run.mcap") << 'x';
  }
  const std::string link = folder.file("robot");
  Daemon daemon(kept, link, folder);
  in_real_time();
  PtyRobot robot(link);
  robot.plug_in();
  if (!daemon.process().wait_for("ready")) throw std::runtime_error("no robot");
  WebClient viewer(daemon.port());
  viewer.subscribe(messages::Channel::kState);
  viewer.write_binary(call_of(kRecordStart, R"({"name":"seen"})"));
  std::this_thread::sleep_for(1s);
  viewer.call(kRecordStop);
  std::this_thread::sleep_for(1s);
  viewer.take();
  const double idle_mb = static_cast<double>(peak_mb(daemon.process().pid()));
  print("an idle daemon: STOP of the page [ms]", press(viewer, robot, presses));
  {
    Load load(daemon.port(), disk);
    std::this_thread::sleep_for(3s);
    const std::vector<double> took = press(viewer, robot, presses);
    print(std::to_string(load.requests) + " requests, " + std::to_string(load.closed) +
              " viewers closed, " + std::to_string(load.lists) + " lists of " +
              std::to_string(runs) + " runs and histories, " + std::to_string(load.choices) +
              " choices, " + std::to_string(load.analyses) + " analyses, " +
              std::to_string(load.hangs) + " hangs of the disk: STOP of the page [ms]",
          took);
  }
  print("peak memory before the load [MB]", {idle_mb});
  print("peak memory [MB]", {static_cast<double>(peak_mb(daemon.process().pid()))});
  daemon.process().signal(SIGTERM);
  daemon.process().wait();
}

}  // namespace
}  // namespace tp100

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  const int presses = argc > 1 ? std::atoi(argv[1]) : 1000;
  const int runs = argc > 2 ? std::atoi(argv[2]) : 5000;
  try {
    tp100::measure(presses, runs);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stop_load_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
