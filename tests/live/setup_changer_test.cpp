// Changes of course, robot and set-up in a running `tp100d run`, with a scripted robot on a pty,
// all in this process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "../server/service_call.h"
#include "course/bundled_files.h"
#include "record/recording.h"
#include "run_rig.h"

namespace tp100::live {
namespace {

namespace fs = std::filesystem;
using server::ask;
using server::Service;
using ::testing::HasSubstr;

class SetupChange : public Run {
 protected:
  SetupChange() {
    configure("directory = \"" + folder_.file("runs") + "\"\nblack_box_s = 0",
              "library = \"" + folder_.file("library") + "\"");
    options_.course = "1-straight";
    options_.setup = "stand";
    options_.daemon.stay = true;
    robot_->with([](ScriptedRobot& robot) {
      // Nothing starts by itself.
      robot.board = static_cast<std::uint8_t>(wire::BoardType::kMega2560);
      robot.drives = true;
    });
    robot_->plug_in();
  }
  /// The recordings of the run by their courses. Expects that each is repeated bit for bit, holds
  /// the course that it names and is whole.
  std::map<std::string, std::string> robots_by_course() const {
    std::map<std::string, std::string> robots;
    for (const std::string& folder : replayed_recordings(folder_.file("runs"))) {
      const record::Recording recording(folder);
      const std::string course = recording.fact("course");
      robots[course] = recording.fact("robot");
      EXPECT_TRUE(recording.whole());
      EXPECT_EQ(recording.file("course.toml"),
                course::read_bundled(course::Bundled::kCourses, course).text);
    }
    return robots;
  }
};

TEST_F(SetupChange, EachRecordingHoldsItsOwnFilesAndReplaysBitForBit) {
  std::size_t parameters = 0;
  run([&] {
    server::WebClient viewer(page());
    viewer.subscribe(messages::Channel::kState);
    EXPECT_TRUE(start(viewer));
    EXPECT_THAT(ask(viewer, Service::kChoose, R"({"course":"2"})"),
                HasSubstr("a run is under way"));
    ask(viewer, Service::kStop);
    // It comes to rest, and its recording ends by itself or with the change.
    const std::string chosen =
        ask(viewer, Service::kChoose, R"({"course":"1-curve","robot":"worn"})");
    EXPECT_THAT(chosen, HasSubstr(R"({"course":"1-curve","robot":"worn","setup":"stand"})"));
    EXPECT_THAT(ask(viewer, Service::kPlace, R"({"x_m":0.25,"y_m":0.5,"yaw_rad":1.0})"),
                HasSubstr(R"("y_m":0.5)"));
    parameters = received().parameters.size();
    forget();
    EXPECT_TRUE(start(viewer));
    ask(viewer, Service::kStop);
    viewer.read_until("\"run\":\"aborted\"");
  });
  EXPECT_EQ(parameters + received().parameters.size(), 2U) << "another robot's are sent once";
  EXPECT_TRUE(logged("course 1-curve, robot worn, set-up stand")) << log_;
  EXPECT_EQ(robots_by_course(), (std::map<std::string, std::string>{{"1-curve", "worn"},
                                                                    {"1-straight", "end-loaded"}}));
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
    EXPECT_THAT(ask(viewer, Service::kFileSave,
                    R"({"kind":"course","name":"wall","text":")" + wall + "\"}"),
                HasSubstr(R"({"name":"wall"})"));
    EXPECT_THAT(ask(viewer, Service::kChoose, R"({"course":"wall"})"), HasSubstr("block"));
    EXPECT_THAT(ask(viewer, Service::kChoose, R"({"course":"nothing"})"),
                HasSubstr("no such course"));
    EXPECT_THAT(ask(viewer, Service::kChoose, R"({"setup":"sky"})"), HasSubstr("setup is"));
    EXPECT_THAT(viewer.read_until("\"course\":"), HasSubstr("\"course\":\"1-straight\""));
    // Nothing stays pending.
    EXPECT_THAT(ask(viewer, Service::kChoose, R"({"course":"2"})"), HasSubstr(R"({"course":"2")"));
  });
}

TEST_F(SetupChange, WithAnExternalWorldNothingIsChanged) {
  options_.world = "files";
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  run([&] {
    server::WebClient viewer(page());
    EXPECT_THAT(ask(viewer, Service::kChoose, R"({"course":"2"})"), HasSubstr("external world"));
    EXPECT_THAT(ask(viewer, Service::kPlace, R"({"at":"start"})"), HasSubstr("external world"));
  });
  fs::current_path(before);
}

}  // namespace
}  // namespace tp100::live
