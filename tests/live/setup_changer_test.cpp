// Changes of course, robot and set-up in a running `tp100d run`, with a scripted robot on a pty,
// all in this process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <set>
#include <thread>

#include "../server/web_client.h"
#include "../support/temporary_folder.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "live_command.h"
#include "pty_robot.h"
#include "record/recording.h"
#include "server/services.h"

namespace tp100::live {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

constexpr char number_of(server::Service service) { return static_cast<char>(service); }
constexpr char kStart = number_of(server::Service::kStart),
               kStop = number_of(server::Service::kStop),
               kChoose = number_of(server::Service::kChoose),
               kPlace = number_of(server::Service::kPlace),
               kSave = number_of(server::Service::kFileSave),
               kSaveParameters = number_of(server::Service::kParametersSave),
               kRestoreParameters = number_of(server::Service::kParametersRestore);

class SetupChange : public ::testing::Test {
 protected:
  SetupChange() {
    robot_ = std::make_unique<PtyRobot>(folder_.path() / "robot");
    std::ofstream(folder_.path() / "config.toml")
        << "library = \"" << folder_.file("library")
        << "\"\n[loop]\npriority = 0\nlock_memory = false\nspin_us = 0\n"
           "[server]\nlisten = \"127.0.0.1:0\"\n[record]\ndirectory = \""
        << folder_.file("runs") << "\"\nblack_box_s = 0\n";
    options_.config = folder_.file("config.toml");
    options_.port = folder_.file("robot");
    options_.course = "1-straight";
    options_.setup = "stand";
    options_.stats = folder_.file("stats.json");
    options_.stay = true;
    options_.duration_s = 300.0;
    robot_->with([](ScriptedRobot& robot) {
      // Nothing starts by itself.
      robot.board = static_cast<std::uint8_t>(wire::BoardType::kMega2560);
      robot.drives = true;
    });
    robot_->plug_in();
  }
  ~SetupChange() override { robot_.reset(); }

  void run(const std::function<void()>& script) { log_ = run_beside(options_, script).log; }
  std::string page() const {
    const std::string served = page_of(options_.stats);
    if (served.empty()) throw std::runtime_error("no page");
    return served;
  }
  /// The answer to a service request, or its failure.
  static std::string ask(server::WebClient& viewer, char service, const std::string& request) {
    static char call = 0;
    const char number = ++call;
    const std::string head = {'\x02', service, 0, 0, 0, number, 0, 0, 0, 4, 0, 0, 0};
    viewer.write_binary(head + "json" + request);
    // The response repeats service and call; a failure names the call.
    const std::string response = {'\x03', service, 0, 0, 0, number, 0, 0, 0};
    const std::string failure = "\"callId\":" + std::to_string(int{number});
    for (;;) {
      viewer.drain();
      for (const std::string& message : viewer.take())
        if (message.starts_with(response) || message.find(failure) != std::string::npos)
          return message;
      if (viewer.closed()) throw std::runtime_error("the viewer was disconnected");
      std::this_thread::sleep_for(2ms);
    }
  }
  /// Starts again where a busy machine has ended a run.
  static void drive(server::WebClient& viewer) {
    for (int i = 0; i < 10; ++i) {
      viewer.read_until("\"start\":true");
      ask(viewer, kStart, "{" + viewer.consent() + "}");
      viewer.read_until("\"run\":\"arming\"");
      const std::string next = viewer.read_until("\"run\":\"");
      if (next.find("\"run\":\"running\"") != std::string::npos ||
          viewer.read_until("\"run\":\"").find("running") != std::string::npos)
        return;
    }
    throw std::runtime_error("no run began");
  }
  std::vector<std::string> recordings() const {
    std::vector<std::string> all;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.file("runs")))
      all.push_back(entry.path().string());
    std::sort(all.begin(), all.end());
    return all;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<PtyRobot> robot_;
  app::RunOptions options_;
  std::string log_;
};

TEST_F(SetupChange, EachRecordingHoldsItsOwnFilesAndReplaysBitForBit) {
  run([&] {
    server::WebClient viewer(page());
    viewer.subscribe(messages::Channel::kState);
    drive(viewer);
    EXPECT_THAT(ask(viewer, kChoose, R"({"course":"2"})"), HasSubstr("a run is under way"));
    ask(viewer, kStop, "{}");
    // It comes to rest, and its recording ends by itself or with the change.
    const std::string chosen = ask(viewer, kChoose, R"({"course":"1-curve","robot":"worn"})");
    EXPECT_THAT(chosen, HasSubstr(R"({"course":"1-curve","robot":"worn","setup":"stand"})"));
    EXPECT_THAT(ask(viewer, kPlace, R"({"x_m":0.25,"y_m":0.5,"yaw_rad":1.0})"),
                HasSubstr(R"("y_m":0.5)"));
    drive(viewer);
    ask(viewer, kStop, "{}");
    viewer.read_until("\"run\":\"aborted\"");
  });
  EXPECT_THAT(log_, HasSubstr("course 1-curve, robot worn, set-up stand"));
  robot_->with([](ScriptedRobot& robot) {
    EXPECT_EQ(robot.received.parameters.size(), 2u) << "another robot's are sent once";
  });
  std::set<std::string> courses;
  for (const std::string& folder : recordings()) {
    const record::Recording recording(folder);
    const std::string course = recording.fact("course");
    courses.insert(course);
    EXPECT_EQ(recording.fact("robot"), course == "1-straight" ? "end-loaded" : "worn");
    EXPECT_EQ(recording.file("course.toml"),
              course::read_bundled(course::Bundled::kCourses, course).text);
    app::ReplayOptions options;
    options.in = folder;
    options.out = folder_.file("poses.csv");
    testing::internal::CaptureStdout();
    EXPECT_EQ(app::run_replay(options), 0) << folder;
    EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("bit for bit")) << folder;
  }
  EXPECT_THAT(courses, ::testing::ElementsAre("1-curve", "1-straight"));
}

TEST_F(SetupChange, WithoutStayTheRecordingGoesOnInAnother) {
  options_.stay = false;
  options_.go = false;
  run([&] {
    server::WebClient viewer(page());
    viewer.subscribe(messages::Channel::kState);
    viewer.read_until("\"session\":\"ready\"");
    ask(viewer, kChoose, R"({"course":"2"})");
    viewer.read_until("\"course\":\"2\"");
    std::this_thread::sleep_for(300ms);
  });
  std::vector<std::string> courses;
  for (const std::string& folder : recordings()) {
    const record::Recording recording(folder);
    EXPECT_TRUE(recording.whole());
    courses.push_back(recording.fact("course"));
    app::ReplayOptions options;
    options.in = folder;
    options.out = folder_.file("poses.csv");
    testing::internal::CaptureStdout();
    EXPECT_EQ(app::run_replay(options), 0) << folder;
    testing::internal::GetCapturedStdout();
  }
  EXPECT_THAT(courses, ::testing::UnorderedElementsAre("1-straight", "2"));
}

TEST_F(SetupChange, WhatDoesNotFitIsRefusedWithTheReasonAndNothingChanges) {
  run([&] {
    server::WebClient viewer(page());
    viewer.subscribe(messages::Channel::kState);
    viewer.read_until("\"session\":\"ready\"");
    const std::string wall =
        R"(speed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 0.5\n[[block]]\nx_m = 0.2\n)"
        R"(y_m = 0.0\nheight_m = 0.3\ndepth_m = 0.1\nwidth_m = 0.4\n[fence]\nmin_x_m = -1\n)"
        R"(max_x_m = 1\nmin_y_m = -1\nmax_y_m = 1\n)";
    EXPECT_THAT(ask(viewer, kSave, R"({"kind":"course","name":"wall","text":")" + wall + "\"}"),
                HasSubstr(R"({"name":"wall"})"));
    EXPECT_THAT(ask(viewer, kChoose, R"({"course":"wall"})"), HasSubstr("block"));
    EXPECT_THAT(ask(viewer, kChoose, R"({"course":"nothing"})"), HasSubstr("no such course"));
    EXPECT_THAT(ask(viewer, kChoose, R"({"setup":"sky"})"), HasSubstr("setup is"));
    EXPECT_THAT(viewer.read_until("\"course\":"), HasSubstr("\"course\":\"1-straight\""));
    // Nothing stays pending.
    EXPECT_THAT(ask(viewer, kChoose, R"({"course":"2"})"), HasSubstr(R"({"course":"2")"));
  });
}

TEST_F(SetupChange, WithAnExternalWorldNothingIsChanged) {
  options_.world = "files";
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  run([&] {
    server::WebClient viewer(page());
    EXPECT_THAT(ask(viewer, kChoose, R"({"course":"2"})"), HasSubstr("external world"));
    EXPECT_THAT(ask(viewer, kPlace, R"({"at":"start"})"), HasSubstr("external world"));
  });
  fs::current_path(before);
}

TEST_F(SetupChange, ParametersAreSavedIntoTheFileAndTakenBack) {
  const std::string original = content_of(options_.config), kept = options_.config + ".bak";
  run([&] {
    server::WebClient viewer(page());
    EXPECT_THAT(ask(viewer, kRestoreParameters, "{}"), HasSubstr("nothing was saved yet"));
    const std::string request = R"("control.preview_s":0.08,"loop.priority":0})";
    const std::string difference =
        R"("differences":[{"name":"control.preview_s","before":"0.06","after":"0.08"}]})";
    EXPECT_THAT(
        ask(viewer, kSaveParameters, R"({"check":true,)" + request),
        HasSubstr(R"("file":"config.toml","written":false,"may_restore":false,)" + difference));
    EXPECT_EQ(content_of(options_.config), original);
    EXPECT_THAT(ask(viewer, kSaveParameters, "{" + request),
                HasSubstr(R"("written":true,"may_restore":true,)" + difference));
    const std::string saved = content_of(options_.config);
    EXPECT_EQ(saved, original + "\n[control]\npreview_s = 0.08\n");
    EXPECT_EQ(content_of(kept), original);
    // The same change again has no effect, and the restorable values are kept.
    EXPECT_THAT(ask(viewer, kSaveParameters, "{" + request), HasSubstr(R"("written":false)"));
    EXPECT_EQ(content_of(kept), original);
    EXPECT_THAT(ask(viewer, kSaveParameters, R"({"course":"no-such"})"), HasSubstr("no-such"));
    EXPECT_THAT(ask(viewer, kSaveParameters, R"({"robot":"worn","course":"1-curve"})"),
                HasSubstr(R"("written":true)"));
    EXPECT_THAT(content_of(options_.config), HasSubstr("robot = \"worn\"\n"));
    EXPECT_THAT(ask(viewer, kRestoreParameters, R"({"check":true})"),
                HasSubstr(R"({"name":"robot","before":"\"worn\"","after":"\"end-loaded\""})"));
    EXPECT_THAT(ask(viewer, kRestoreParameters, "{}"), HasSubstr(R"("written":true)"));
    EXPECT_EQ(content_of(options_.config), saved);
    // Changes by other programs meanwhile are kept, unless they are invalid.
    std::ofstream(options_.config) << original << "# by hand\n";
    EXPECT_THAT(ask(viewer, kSaveParameters, "{" + request), HasSubstr(R"("written":true)"));
    EXPECT_EQ(content_of(options_.config), original + "# by hand\n\n[control]\npreview_s = 0.08\n");
    std::ofstream(options_.config) << "[control]\npreview = 1\n";
    EXPECT_THAT(ask(viewer, kSaveParameters, "{" + request), HasSubstr("unknown key"));
    EXPECT_EQ(content_of(options_.config), "[control]\npreview = 1\n");
  });
}

}  // namespace
}  // namespace tp100::live
