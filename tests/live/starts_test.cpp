// Starts of a run of `tp100d run` by keyboard and by viewer, with a scripted robot on a pty, all in
// this process.
#include <fcntl.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "../support/notify_socket.h"
#include "run_rig.h"

namespace tp100::live {
namespace {

using namespace std::chrono_literals;

/// Standard input of this process; the test supplies what is typed.
class Keyboard {
 public:
  Keyboard() : kept_(::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    ::dup2(ends[0], STDIN_FILENO);
    ::close(ends[0]);
    keys_ = ends[1];
  }
  ~Keyboard() {
    if (kept_ >= 0) ::dup2(kept_, STDIN_FILENO);
    ::close(kept_);
    ::close(keys_);
  }
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  void type(const std::string& text) const {
    if (::write(keys_, text.data(), text.size()) < 0) throw std::runtime_error("nobody reads");
  }
  void enter() const { type("\n"); }

 private:
  int kept_;
  int keys_ = -1;
};

class Starts : public Run {
 protected:
  Starts() {
    configure("black_box_s = 0");
    options_.course = "1-straight";
    options_.daemon.stay = true;
  }
  void with_board(wire::BoardType board) {
    robot_->with([&](ScriptedRobot& robot) { robot.board = static_cast<std::uint8_t>(board); });
    robot_->plug_in();
  }
  std::size_t stops() { return received().stops.size(); }
  bool ready() {
    return test::eventually([this] { return received().commands.size() > 60; });
  }
  /// On a busy machine a run may end by itself; then it is started again.
  bool driving() {
    return test::eventually([this] { return robot_->with(driven); }, 5s) || start_again();
  }
  bool start_again() {
    for (int tries = 0; tries < 10; ++tries) {
      const std::size_t before = arms();
      keyboard_.type("go\n");
      if (test::eventually([&] { return arms() > before; }, 2s) &&
          test::eventually([this] { return robot_->with(driven); }, 3s))
        return true;
    }
    return false;
  }
  /// Nothing that came before arms the robot.
  void expect_no_start(std::size_t commands = 50) {
    const std::size_t before = arms();
    ASSERT_TRUE(after_commands(commands));
    EXPECT_EQ(arms(), before);
  }

  Keyboard keyboard_;
};

// The robot ends the run, or somebody presses STOP on the page; at that moment the operator presses
// Enter to stop it. Other moments: doors_test.
TEST_F(Starts, EnterInTheMomentInWhichARunEndsOrIsStoppedStartsNothing) {
  with_board(wire::BoardType::kNative);
  run([&] {
    ASSERT_TRUE(driving());
    server::WebClient viewer(page());
    for (int i = 0; i < 8; ++i) {
      SCOPED_TRACE(i);
      const std::size_t before = arms();
      const auto end = [&] {
        if (i % 2 == 0) return viewer.call(server::Service::kStop);
        robot_->with([](ScriptedRobot& robot) { robot.state = wire::State::kFaulted; });
      };
      const bool enter_first = i % 4 > 1;
      if (enter_first) keyboard_.enter();
      if (!enter_first) end();
      std::this_thread::sleep_for(std::chrono::milliseconds(i));
      if (enter_first) end();
      if (!enter_first) keyboard_.enter();
      ASSERT_TRUE(after_commands(50));
      ASSERT_EQ(arms(), before);
      viewer.drain();
      ASSERT_TRUE(start_again());
    }
  });
}

TEST_F(Starts, EnterStopsADriveByHandWithoutACourse) {
  with_board(wire::BoardType::kMega2560);
  options_.course.clear();
  run([&] {
    ASSERT_TRUE(ready());
    keyboard_.enter();
    expect_no_start();
    server::WebClient viewer(page());
    viewer.call(server::Service::kDriveTake);
    ASSERT_TRUE(test::eventually([this] { return arms() > 0; }));
    keyboard_.enter();
    ASSERT_TRUE(test::eventually([this] { return stops() > 0; }));
    keyboard_.type("go\n");
    expect_no_start();
  });
  EXPECT_TRUE(logged("Enter: STOP")) << log_;
  EXPECT_TRUE(logged("there is no course; nothing is started")) << log_;
}

TEST_F(Starts, WhatIsTypedAheadStartsNothing) {
  with_board(wire::BoardType::kMega2560);
  run([&] {
    // This is typed before the prompt.
    keyboard_.type("\n\ngo\n\ngo");
    ASSERT_TRUE(ready());
    ASSERT_TRUE(after_commands(100));
    EXPECT_EQ(arms(), 0U);
    // The incomplete word was discarded, and lines that arrive together do not count as an answer.
    keyboard_.type("\n\n");
    ASSERT_TRUE(after_commands(100));
    EXPECT_EQ(arms(), 0U);
    keyboard_.enter();
    ASSERT_TRUE(eventually(driven));
    keyboard_.type("\ngo\n");
    ASSERT_TRUE(eventually([](const ScriptedRobot& robot) { return !driven(robot); }));
    ASSERT_TRUE(after_commands(100));
    EXPECT_EQ(arms(), 1U);
  });
}

TEST_F(Starts, WhatIsNoEmulatorOfTheFirstRunWaitsForAPerson) {
  using enum wire::BoardType;
  const test::NotifySocket manager(folder_.file("notify"));
  struct Case {
    const char* name;
    wire::BoardType board;
    bool go, service, ran_before;
    const char *starts, *logged;
  };
  for (const Case& each :
       {Case{"a Mega", kMega2560, false, false, false, "\n", "ready; press Enter to start course"},
        {"a Mega and --go", kMega2560, true, false, false, "", ""},
        {"a robot simulated inside its board", kFakeRobot, false, false, false, "\n",
         "with the robot simulated inside the board"},
        {"an emulator, --go and a service", kNative, true, true, false, "\n", ""},
        {"a later drive of the same program", kMega2560, false, false, true, "go\n", "type go"}}) {
    SCOPED_TRACE(each.name);
    if (each.service) ::setenv("NOTIFY_SOCKET", folder_.file("notify").c_str(), 1);
    options_.daemon.go = each.go;
    options_.daemon.ran_before = each.ran_before;
    forget();
    with_board(each.board);
    run([&] {
      const std::string starts = each.starts;
      if (!starts.empty()) {
        ASSERT_TRUE(ready());
        if (each.ran_before) keyboard_.enter();
        ASSERT_TRUE(after_commands(200));
        EXPECT_EQ(arms(), 0U);
        keyboard_.type(starts);
      }
      ASSERT_TRUE(eventually(driven));
    });
    ::unsetenv("NOTIFY_SOCKET");
    EXPECT_TRUE(logged(each.logged)) << message_ << log_;
    robot_->unplug();
  }
}

// --go is the consent of a person for the robot that stood there when the program was started.
TEST_F(Starts, GoDoesNotStartARobotThatIsPluggedInLater) {
  options_.daemon.go = options_.daemon.wait = true;
  for (const bool was_there : {true, false}) {
    std::filesystem::remove(options_.daemon.stats_path);
    forget();
    robot_->with([&](ScriptedRobot& robot) { robot.answers_parameters = !was_there; });
    if (was_there) with_board(wire::BoardType::kMega2560);
    run([&] {
      if (was_there) says_of_itself("\"session\": \"parameters\"");
      robot_->unplug();
      // Figures of a loop that has begun: by then the port was looked for.
      EXPECT_TRUE(test::eventually([&] {
        const std::string now = stats();
        return now.find("\"session\": \"closed\"") != std::string::npos &&
               now.find("\"cycles\": 0,") == std::string::npos;
      }));
      robot_->with([](ScriptedRobot& robot) { robot.answers_parameters = true; });
      robot_->plug_in();
      ASSERT_TRUE(ready());
      ASSERT_TRUE(after_commands(100));
      EXPECT_EQ(arms(), 0U);
    });
    EXPECT_TRUE(logged("nothing starts by itself")) << log_;
    robot_->unplug();
  }
}

}  // namespace
}  // namespace tp100::live
