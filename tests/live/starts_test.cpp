// Starts of a run of `tp100d run` by keyboard and by viewer, with a scripted robot on a pty, all in
// this process.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "../support/notify_socket.h"
#include "run_rig.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
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
  // Repetitions per test; --gtest_repeat gives more.
  static constexpr int kRepetitions = 10;

  Starts() {
    configure("black_box_s = 0");
    options_.course = "1-straight";
    options_.stay = true;
  }
  void with_board(wire::BoardType board) {
    robot_->with([&](ScriptedRobot& robot) { robot.board = static_cast<std::uint8_t>(board); });
    robot_->plug_in();
  }
  std::size_t stops() { return received().stops.size(); }
  bool ready() {
    return soon([this] { return received().commands.size() > 60; });
  }
  static bool moves(const ScriptedRobot& robot) {
    return !robot.received.commands.empty() && robot.received.commands.back().speed_mps > 0.0F;
  }
  bool starts_to_move() {
    return soon([this] { return robot_->with(moves); });
  }
  /// On a busy machine a run may end by itself; then it is started again.
  bool driving() {
    return soon([this] { return robot_->with(moves); }, 5s) || start_again();
  }
  bool start_again() {
    for (int tries = 0; tries < 10; ++tries) {
      const std::size_t before = arms();
      keyboard_.type("go\n");
      if (soon([&] { return arms() > before; }, 2s) &&
          soon([this] { return robot_->with(moves); }, 3s))
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

TEST_F(Starts, ASecondEnterStartsNothing) {
  with_board(wire::BoardType::kNative);
  run([&] {
    ASSERT_TRUE(driving());
    for (const int apart_ms : {50, 500, 5000, 3, 50, 9, 50, 15, 50, 21, 50, 27}) {
      SCOPED_TRACE(apart_ms);
      const std::size_t before = arms();
      keyboard_.enter();
      std::this_thread::sleep_for(std::chrono::milliseconds(apart_ms));
      keyboard_.enter();
      ASSERT_TRUE(after_commands(apart_ms < 500 ? 50 : 200));
      ASSERT_EQ(arms(), before) << "a second Enter armed the robot";
      ASSERT_TRUE(start_again()) << "typing go must start a run";
    }
  });
  EXPECT_TRUE(logged("Enter: STOP")) << log_;
  EXPECT_TRUE(logged("type go and press Enter to start course 1-straight")) << log_;
}

TEST_F(Starts, AStopAfterACompletedRunLeavesItsResult) {
  choose_short_course();
  robot_->with([](ScriptedRobot& robot) { robot.drives = true; });
  with_board(wire::BoardType::kNative);
  EXPECT_EQ(run([&] {
              const auto completed = [&] {
                return soon(
                    [&] { return stats().find("\"result\": \"completed\"") != std::string::npos; },
                    10s);
              };
              ASSERT_TRUE(driving());
              // On a busy machine a run may end early.
              for (int i = 0; i < 5 && !completed(); ++i) ASSERT_TRUE(start_again());
              const std::size_t before = stops();
              keyboard_.enter();
              ASSERT_TRUE(soon([&] { return stops() > before; }));
              ASSERT_TRUE(after_commands(50));
            }),
            0)
      << log_;
  EXPECT_FALSE(logged("finished -> aborted")) << log_;
}

// The robot ends the run, or somebody presses STOP on the page; at that moment the operator presses
// Enter to stop it.
TEST_F(Starts, EnterInTheMomentInWhichARunEndsOrIsStoppedStartsNothing) {
  with_board(wire::BoardType::kNative);
  run([&] {
    ASSERT_TRUE(driving());
    server::WebClient viewer(page());
    for (int i = 0; i < 2 * kRepetitions; ++i) {
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

// The same as AFirstStart... of the live cycle, through the whole program: neither operator knows
// of the other's request yet.
TEST_F(Starts, TheFirstEnterAndTheStopOfThePageAtOnceLeaveNoRun) {
  with_board(wire::BoardType::kMega2560);
  run([&] {
    ASSERT_TRUE(ready());
    server::WebClient viewer(page());
    viewer.call(server::Service::kStop);
    keyboard_.enter();
    ASSERT_TRUE(after_commands(200));
    ASSERT_TRUE(soon([this] { return stops() > 0; }));
    keyboard_.enter();
    expect_no_start();
    ASSERT_TRUE(start_again());
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
    ASSERT_TRUE(soon([this] { return arms() > 0; }));
    keyboard_.enter();
    ASSERT_TRUE(soon([this] { return stops() > 0; }));
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
    ASSERT_TRUE(starts_to_move());
    keyboard_.type("\ngo\n");
    ASSERT_TRUE(eventually([](const ScriptedRobot& robot) { return !moves(robot); }));
    ASSERT_TRUE(after_commands(100));
    EXPECT_EQ(arms(), 1U);
  });
}

TEST_F(Starts, ABoardThatIsNoEmulatorWaitsForEnter) {
  struct Case {
    wire::BoardType board;
    const char* logged;
  };
  for (const Case& each :
       {Case{wire::BoardType::kMega2560, "ready; press Enter to start course 1-straight"},
        {wire::BoardType::kFakeRobot, "with the robot simulated inside the board"},
        {wire::BoardType::kUnknown, "ready; press Enter"}}) {
    forget();
    with_board(each.board);
    run([&] {
      ASSERT_TRUE(ready());
      ASSERT_TRUE(after_commands(200));
      EXPECT_EQ(arms(), 0U);
      keyboard_.enter();
      ASSERT_TRUE(starts_to_move());
    });
    EXPECT_TRUE(logged(each.logged)) << log_;
  }
}

TEST_F(Starts, AMegasHelloBehindAPtyStartsWithGo) {
  options_.go = true;
  with_board(wire::BoardType::kMega2560);
  run([&] { ASSERT_TRUE(starts_to_move()); });
}

// --go is the consent of a person for the robot that stood there when the program was started.
TEST_F(Starts, GoDoesNotStartARobotThatIsPluggedInLater) {
  options_.go = options_.wait = true;
  for (const bool was_there : {true, false}) {
    std::filesystem::remove(options_.stats);
    forget();
    robot_->with([&](ScriptedRobot& robot) { robot.answers_parameters = !was_there; });
    if (was_there) with_board(wire::BoardType::kMega2560);
    run([&] {
      if (was_there) says_of_itself("\"session\": \"parameters\"");
      robot_->unplug();
      says_of_itself("\"session\": \"closed\"");
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

TEST_F(Starts, ALaterDriveOfTheSameProgramTakesTheWord) {
  options_.ran_before = true;
  with_board(wire::BoardType::kMega2560);
  run([&] {
    ASSERT_TRUE(ready());
    ASSERT_TRUE(after_commands(50));
    keyboard_.enter();
    ASSERT_TRUE(after_commands(100));
    EXPECT_EQ(arms(), 0U);
    ASSERT_TRUE(start_again());
  });
}

TEST_F(Starts, AServiceNeverStartsByItself) {
  const test::NotifySocket manager(folder_.file("notify"));
  ::setenv("NOTIFY_SOCKET", folder_.file("notify").c_str(), 1);
  for (const bool go : {false, true}) {
    options_.go = go;
    with_board(wire::BoardType::kNative);
    run([&] {
      ASSERT_TRUE(ready());
      ASSERT_TRUE(after_commands(200));
      EXPECT_EQ(arms(), 0U);
    });
    forget();
    robot_->unplug();
  }
  ::unsetenv("NOTIFY_SOCKET");
}

TEST_F(Starts, AStopBeforeTheRobotIsThereIsNotUndoneByStartingByItself) {
  options_.wait = true;
  run([&] {
    server::WebClient viewer(page());
    viewer.subscribe(messages::Channel::kState);
    viewer.call(server::Service::kStop);
    viewer.read_until("\"latched\":true");
    with_board(wire::BoardType::kNative);
    ASSERT_TRUE(ready());
    ASSERT_TRUE(after_commands(200));
    EXPECT_EQ(arms(), 0U);
    ASSERT_TRUE(start_again());
    EXPECT_THAT(viewer.read_until("\"run\":\"running\""), HasSubstr("\"confirm_start\":true"))
        << "the page must be told that a start is to be confirmed";
  });
}

}  // namespace
}  // namespace tp100::live
