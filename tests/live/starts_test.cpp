// Starts of a run of `tp100d run` by keyboard and by viewer, with a scripted robot on a pty, all in
// this process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>

#include "../server/web_client.h"
#include "../support/notify_socket.h"
#include "../support/temporary_folder.h"
#include "live_command.h"
#include "pty_robot.h"
#include "server/services.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
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

class Starts : public ::testing::Test {
 protected:
  // Repetitions per test; --gtest_repeat gives more.
  static constexpr int kRepetitions = 10;
  // After this many commands, an accepted start would have armed the robot.
  static constexpr std::size_t kManyCommands = 50;

  Starts() {
    robot_ = std::make_unique<PtyRobot>(folder_.path() / "robot");
    // Scheduling is ordinary because other tests run on the machine at the same time.
    std::ofstream(folder_.path() / "config.toml")
        << "[loop]\npriority = 0\nlock_memory = false\nspin_us = 0\n"
           "[server]\nlisten = \"127.0.0.1:0\"\n"
           "[record]\nblack_box_s = 0\n";
    options_.config = folder_.file("config.toml");
    options_.port = folder_.file("robot");
    options_.course = "1-straight";
    options_.stats = folder_.file("stats.json");
    options_.stay = true;
    options_.duration_s = 300.0;
  }
  ~Starts() override { robot_.reset(); }

  void run(const std::function<void()>& script) {
    const Ended ended = run_beside(options_, script);
    status_ = ended.status;
    log_ = ended.log;
  }
  void with_board(wire::BoardType board) {
    robot_->with([&](ScriptedRobot& robot) { robot.board = static_cast<std::uint8_t>(board); });
    robot_->plug_in();
  }
  std::size_t arms() {
    return robot_->with([](ScriptedRobot& robot) { return robot.received.arms.size(); });
  }
  std::size_t stops() {
    return robot_->with([](ScriptedRobot& robot) { return robot.received.stops.size(); });
  }
  /// Waits until the robot has received `more` further commands. They are sent all the time, armed
  /// or not.
  bool after_commands(std::size_t more = kManyCommands) {
    const auto got = [this] {
      return robot_->with([](ScriptedRobot& robot) { return robot.received.commands.size(); });
    };
    const std::size_t until = got() + more;
    return soon([&] { return got() >= until; });
  }
  bool ready() {
    return soon([this] {
      return robot_->with([](ScriptedRobot& robot) { return robot.received.commands.size() > 60; });
    });
  }
  bool moves() {
    return robot_->with([](ScriptedRobot& robot) {
      return !robot.received.commands.empty() && robot.received.commands.back().speed_mps > 0.0F;
    });
  }
  /// On a busy machine a run may end by itself; then it is started again.
  bool driving() {
    return soon([this] { return moves(); }, 5s) || start_again();
  }
  bool standing() {
    return soon([this] {
      return robot_->with([](ScriptedRobot& robot) {
        return !robot.received.commands.empty() && robot.received.commands.back().speed_mps == 0.0F;
      });
    });
  }
  bool start_again() {
    for (int tries = 0; tries < 10; ++tries) {
      const std::size_t before = arms();
      keyboard_.type("go\n");
      if (soon([&] { return arms() > before; }, 2s) && soon([this] { return moves(); }, 3s))
        return true;
    }
    return false;
  }
  std::string stats() const { return content_of(options_.stats); }
  std::string page() const { return page_of(options_.stats); }

  test::TemporaryFolder folder_;
  Keyboard keyboard_;
  std::unique_ptr<PtyRobot> robot_;
  app::RunOptions options_;
  std::string log_;
  int status_ = -1;
};

TEST_F(Starts, ASecondEnterStartsNothing) {
  with_board(wire::BoardType::kNative);
  run([&] {
    for (const auto apart : {50ms, 500ms, 5000ms}) {
      ASSERT_TRUE(apart == 50ms ? driving() : start_again());
      const std::size_t before = arms();
      keyboard_.enter();
      std::this_thread::sleep_for(apart);
      keyboard_.enter();
      ASSERT_TRUE(after_commands(200));
      ASSERT_EQ(arms(), before) << "a second Enter armed the robot";
    }
    ASSERT_TRUE(start_again()) << "typing go must start a run";
  });
  EXPECT_THAT(log_, HasSubstr("Enter: STOP"));
  EXPECT_THAT(log_, HasSubstr("type go and press Enter to start course 1-straight"));
}

TEST_F(Starts, AStopAfterACompletedRunLeavesItsResult) {
  std::ofstream(folder_.path() / "short.toml")
      << "speed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 0.1\n"
         "[fence]\nmin_x_m = -1.0\nmax_x_m = 1.0\nmin_y_m = -1.0\nmax_y_m = 1.0\n";
  options_.course = folder_.file("short.toml");
  options_.setup = "stand";
  robot_->with([](ScriptedRobot& robot) { robot.drives = true; });
  with_board(wire::BoardType::kNative);
  run([&] {
    const auto completed = [&] {
      return soon([&] { return stats().find("\"result\": \"completed\"") != std::string::npos; },
                  10s);
    };
    ASSERT_TRUE(driving());
    // On a busy machine a run may end early.
    for (int i = 0; i < 5 && !completed(); ++i) ASSERT_TRUE(start_again());
    const std::size_t before = stops();
    keyboard_.enter();
    ASSERT_TRUE(soon([&] { return stops() > before; }));
    ASSERT_TRUE(after_commands());
  });
  EXPECT_THAT(log_, Not(HasSubstr("finished -> aborted")));
  EXPECT_EQ(status_, 0) << log_;
}

TEST_F(Starts, AgainAndAgainTakeTheWord) {
  with_board(wire::BoardType::kNative);
  run([&] {
    ASSERT_TRUE(driving());
    for (int i = 0; i < kRepetitions; ++i) {
      const std::size_t before = arms();
      keyboard_.enter();
      std::this_thread::sleep_for(std::chrono::milliseconds(i % 2 == 0 ? 50 : i * 3));
      keyboard_.enter();
      ASSERT_TRUE(after_commands());
      ASSERT_EQ(arms(), before) << "repetition " << i;
      ASSERT_TRUE(start_again());
    }
  });
}

// The robot ends the run; at that moment the operator presses Enter to stop it.
TEST_F(Starts, EnterInTheCycleInWhichARunEndsStartsNothing) {
  with_board(wire::BoardType::kNative);
  run([&] {
    ASSERT_TRUE(driving());
    for (int i = 0; i < kRepetitions; ++i) {
      const std::size_t before = arms();
      const auto press = [&] { keyboard_.enter(); };
      const auto end = [&] {
        robot_->with([](ScriptedRobot& robot) { robot.state = wire::State::kFaulted; });
      };
      if (i % 4 == 3) press();
      end();
      std::this_thread::sleep_for(std::chrono::milliseconds(2 * i));
      if (i % 4 != 3) press();
      ASSERT_TRUE(after_commands());
      ASSERT_EQ(arms(), before) << "repetition " << i;
      ASSERT_TRUE(start_again());
    }
  });
}

TEST_F(Starts, EnterAndTheStopOfThePageAtOnceStartNothing) {
  with_board(wire::BoardType::kNative);
  run([&] {
    ASSERT_TRUE(driving());
    server::WebClient viewer(page());
    for (int i = 0; i < kRepetitions; ++i) {
      const std::size_t before = arms();
      if (i % 2 == 0) viewer.call(server::Service::kStop);
      if (i % 2 != 0) keyboard_.enter();
      std::this_thread::sleep_for(std::chrono::milliseconds(i));
      if (i % 2 == 0) keyboard_.enter();
      if (i % 2 != 0) viewer.call(server::Service::kStop);
      ASSERT_TRUE(after_commands());
      ASSERT_EQ(arms(), before) << "repetition " << i;
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
    const std::size_t before = arms();
    keyboard_.enter();
    ASSERT_TRUE(after_commands());
    EXPECT_EQ(arms(), before);
    ASSERT_TRUE(start_again());
  });
}

TEST_F(Starts, EnterStopsADriveByHandWithoutACourse) {
  with_board(wire::BoardType::kMega2560);
  options_.course.clear();
  run([&] {
    ASSERT_TRUE(ready());
    keyboard_.enter();
    ASSERT_TRUE(after_commands() && arms() == 0);
    server::WebClient viewer(page());
    viewer.call(server::Service::kDriveTake);
    ASSERT_TRUE(soon([this] { return arms() > 0; }));
    const std::size_t before = arms();
    keyboard_.enter();
    ASSERT_TRUE(soon([this] { return stops() > 0; }));
    keyboard_.type("go\n");
    ASSERT_TRUE(after_commands());
    EXPECT_EQ(arms(), before);
  });
  EXPECT_THAT(log_, HasSubstr("Enter: STOP"));
  EXPECT_THAT(log_, HasSubstr("there is no course; nothing is started"));
}

TEST_F(Starts, WhatIsTypedAheadStartsNothing) {
  with_board(wire::BoardType::kMega2560);
  run([&] {
    // This is typed before the prompt.
    keyboard_.type("\n\ngo\n\ngo");
    ASSERT_TRUE(ready());
    ASSERT_TRUE(after_commands(100));
    EXPECT_EQ(arms(), 0u);
    // The incomplete word was discarded, and lines that arrive together do not count as an answer.
    keyboard_.type("\n\n");
    ASSERT_TRUE(after_commands(100));
    EXPECT_EQ(arms(), 0u);
    keyboard_.enter();
    ASSERT_TRUE(soon([this] { return moves(); }));
    keyboard_.type("\ngo\n");
    ASSERT_TRUE(standing());
    ASSERT_TRUE(after_commands(100));
    EXPECT_EQ(arms(), 1u);
  });
}

TEST_F(Starts, AMegasHelloBehindAPtyWaitsForEnter) {
  with_board(wire::BoardType::kMega2560);
  run([&] {
    ASSERT_TRUE(ready());
    ASSERT_TRUE(after_commands(200));
    EXPECT_EQ(arms(), 0u);
    keyboard_.enter();
    ASSERT_TRUE(soon([this] { return moves(); }));
  });
  EXPECT_THAT(log_, HasSubstr("ready; press Enter to start course 1-straight"));
}

TEST_F(Starts, ABoardThatSimulatesItsRobotIsCalledSoAndWaitsForEnter) {
  with_board(wire::BoardType::kFakeRobot);
  run([&] {
    ASSERT_TRUE(ready());
    ASSERT_TRUE(after_commands(200));
    EXPECT_EQ(arms(), 0u);
    keyboard_.enter();
    ASSERT_TRUE(soon([this] { return moves(); }));
  });
  EXPECT_THAT(log_, HasSubstr("with the robot simulated inside the board"));
}

TEST_F(Starts, ABoardThatNobodyKnowsWaitsForEnter) {
  with_board(wire::BoardType::kUnknown);
  run([&] {
    ASSERT_TRUE(ready());
    ASSERT_TRUE(after_commands(200));
    EXPECT_EQ(arms(), 0u);
  });
}

TEST_F(Starts, AMegasHelloBehindAPtyStartsWithGo) {
  options_.go = true;
  with_board(wire::BoardType::kMega2560);
  run([&] { ASSERT_TRUE(soon([this] { return moves(); })); });
}

TEST_F(Starts, ALaterDriveOfTheSameProgramTakesTheWord) {
  options_.ran_before = true;
  with_board(wire::BoardType::kMega2560);
  run([&] {
    ASSERT_TRUE(ready());
    ASSERT_TRUE(after_commands());
    keyboard_.enter();
    ASSERT_TRUE(after_commands(100));
    EXPECT_EQ(arms(), 0u);
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
      EXPECT_EQ(arms(), 0u);
    });
    robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
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
    EXPECT_EQ(arms(), 0u);
    ASSERT_TRUE(start_again());
  });
}

TEST_F(Starts, ThePageIsToldThatAStartIsToBeConfirmed) {
  with_board(wire::BoardType::kNative);
  run([&] {
    ASSERT_TRUE(driving());
    server::WebClient viewer(page());
    viewer.subscribe(messages::Channel::kState);
    EXPECT_THAT(viewer.read_until("\"run\":\"running\""), HasSubstr("\"confirm_start\":true"));
  });
}

}  // namespace
}  // namespace tp100::live
