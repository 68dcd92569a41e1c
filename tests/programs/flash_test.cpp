// Tests scripts/flash against Arduino's own bootloader on the emulated chip, with the real avrdude,
// and its messages when there is nothing to flash.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "firmware/version.h"
#include "process.h"
#include "sim/robot/pty.h"
#include "support/container_terminal.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const std::string kFlash = source_path("scripts/flash");

std::string firmware_version() {
  return "firmware " + std::to_string(firmware::kVersionMajor) + "." +
         std::to_string(firmware::kVersionMinor) + "." + std::to_string(firmware::kVersionPatch);
}

/// Flashes the image of this build to an emulated chip.
class FlashEmulatedMega : public testing::Test {
 protected:
  std::string port() const { return folder_.file("tp100"); }
  Finished flash(const Words& more = {}) const {
    return run(joined({kFlash, "--build", build_path(), "--port", port()}, more));
  }
  Finished hello(const std::string& timeout_s) const {
    return run({"tp100d", "ports", "--hello", port(), "--timeout", timeout_s});
  }
  TemporaryFolder folder_;
};

TEST_F(FlashEmulatedMega, ABlankBoardSaysHelloOnlyOnceItIsFlashed) {
  const auto robot = start_robot(port(), {"--board", "avr", "--blank"});
  EXPECT_EQ(hello("2").status, 1);

  const Finished flashed = flash();
  EXPECT_EQ(flashed.status, 0) << flashed.output;
  EXPECT_THAT(flashed.output, HasSubstr("bytes of flash verified"));
  EXPECT_THAT(flashed.output, HasSubstr("a Mega 2560, " + firmware_version()));

  // The image is still there after another reset.
  const Finished again = hello("10");
  EXPECT_EQ(again.status, 0) << again.output;
  EXPECT_THAT(again.output, HasSubstr(firmware_version()));
}

TEST_F(FlashEmulatedMega, AnImageReplacesTheRunningOneAndSilenceIsReported) {
  const auto robot = start_robot(port(), {"--board", "avr"});
  EXPECT_EQ(hello("10").status, 0);

  // The image is a single rjmp to itself.
  std::ofstream(folder_.file("silent.hex")) << ":02000000FFCF30\n:00000001FF\n";
  const Finished silent = flash({"--hex", folder_.file("silent.hex")});
  EXPECT_EQ(silent.status, 1) << silent.output;
  EXPECT_THAT(silent.output, HasSubstr("2 bytes of flash verified"));
  EXPECT_THAT(silent.output, HasSubstr("no hello"));
  EXPECT_THAT(silent.output, HasSubstr("press the board's reset button"));

  const Finished flashed = flash();
  EXPECT_EQ(flashed.status, 0) << flashed.output;
}

/// A board with nothing attached, flashed with the image that simulates the robot inside, and a
/// daemon that drives a course with it in real time.
class BareMega : public FlashEmulatedMega {
 protected:
  void SetUp() override {
    const Finished flashed = flash({"--hex", build_path("firmware/tp100_fake.hex")});
    ASSERT_EQ(flashed.status, 0) << flashed.output;
    EXPECT_THAT(flashed.output, HasSubstr("FAKE_ROBOT"));
    // A line, and a quarter of a circle to the left: to (0.4, 0.2), 90 degrees.
    std::ofstream(folder_.file("bend.toml"))
        << "speed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 0.2\n[[segment]]\n"
           "type = \"arc\"\nradius_m = 0.2\nangle_deg = 90.0\n"
           "[fence]\nmin_x_m = -0.5\nmax_x_m = 1.0\nmin_y_m = -0.5\nmax_y_m = 1.0\n";
    int keyboard[2];
    ASSERT_EQ(::pipe2(keyboard, O_CLOEXEC), 0);
    keyboard_ = keyboard[1];
    daemon_.emplace(
        std::vector<std::string>{"tp100d", "run", "--port", port(), "--listen", "off", "--course",
                                 folder_.file("bend.toml"), "--stats", stats()},
        keyboard[0]);
    ::close(keyboard[0]);
    ASSERT_TRUE(daemon_->wait_for("press Enter to start")) << daemon_->output();
    EXPECT_THAT(daemon_->output(), Not(HasSubstr("running")));
  }
  ~BareMega() override {
    if (keyboard_ >= 0) ::close(keyboard_);
  }
  void type(const std::string& line) const {
    ASSERT_EQ(::write(keyboard_, line.data(), line.size()), static_cast<ssize_t>(line.size()));
  }
  std::string stats() const { return folder_.file("stats.json"); }
  bool drives() const {
    return eventually([&] { return figure(stats(), "progress_m") > 0.05; });
  }

  std::unique_ptr<Process> robot_ = start_robot(port(), {"--board", "avr", "--blank"});
  std::optional<Process> daemon_;
  int keyboard_ = -1;
};

TEST_F(BareMega, DrivesACourseToItsEndOnceEnterIsPressed) {
  type("\n");
  EXPECT_EQ(daemon_->wait(), 0) << daemon_->output();
  EXPECT_THAT(daemon_->output(), HasSubstr("bend: completed"));
  for (const char* source : {"odometry", "model", "fused"}) {
    const nlohmann::json pose = nlohmann::json::parse(std::ifstream(stats())).at(source);
    EXPECT_NEAR(pose.at("x_m").get<double>(), 0.4, 0.03) << source;
    EXPECT_NEAR(pose.at("y_m").get<double>(), 0.2, 0.03) << source;
    EXPECT_NEAR(pose.at("yaw_rad").get<double>(), std::numbers::pi / 2.0, 0.1) << source;
  }
}

TEST_F(BareMega, EnterStopsItAndPullingTheCableEndsTheRun) {
  type("\n");
  ASSERT_TRUE(robot_->wait_for("motors on")) << robot_->output();
  ASSERT_TRUE(drives()) << daemon_->output();
  type("\n");
  ASSERT_TRUE(daemon_->wait_for("STOP")) << daemon_->output();
  EXPECT_TRUE(robot_->wait_for("motors off")) << robot_->output();
  ASSERT_TRUE(daemon_->wait_for("type go")) << daemon_->output();

  fs::remove(stats());
  type("go start\n");
  ASSERT_TRUE(robot_->wait_for("motors on")) << robot_->output();
  ASSERT_TRUE(drives()) << daemon_->output();
  // The cable feeds the board, too. The link that it leaves may become another test's.
  fs::remove(port());
  robot_->signal(SIGKILL);
  ASSERT_TRUE(daemon_->wait_for("no such port; plug the robot in")) << daemon_->output();
  EXPECT_THAT(daemon_->output(), HasSubstr("error link_lost: "));
  EXPECT_THAT(daemon_->output(), HasSubstr("port is gone"));
  daemon_->signal(SIGTERM);
  EXPECT_EQ(daemon_->wait(), 1) << daemon_->output();
}

/// A build folder whose tp100d lists the ports that a test supplies, so that real devices on this
/// machine's USB are left alone.
class FlashOf : public testing::Test {
 protected:
  FlashOf() {
    fs::create_directories(folder_.path() / "bin");
    fs::create_directories(folder_.path() / "firmware");
    std::ofstream(folder_.path() / "firmware" / "tp100.hex") << ":00000001FF\n";
    list({});
    program("avrdude", "echo x >> '" + folder_.file("tries") + "'\n" +
                           "echo 'avrdude error: unable to open programmer wiring'; exit 1\n");
  }
  void program(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << "#!/bin/sh\n" << text;
    fs::permissions(folder_.path() / name, fs::perms::owner_all);
  }
  /// Sets the ports that `tp100d ports` lists as candidates.
  void list(const std::vector<std::string>& ports) const {
    std::string text = "cat <<'END'\n/dev/ttyS0  -  serial port\n";
    for (const std::string& port : ports) {
      text += port + "  2341:0042  Arduino Mega 2560\n    port = \"" + port + "\"\n";
    }
    program("bin/tp100d", text + "END\n");
  }
  Finished flash(const Words& more, const std::string& path = {}) const {
    const std::string folder = folder_.path().string();
    return run(joined({"/usr/bin/env", "PATH=" + (path.empty() ? folder + ":/usr/bin:/bin" : path),
                       kFlash, "--build", folder},
                      more));
  }
  void expect_refused(const std::vector<std::string>& arguments,
                      const std::vector<std::string>& says, const std::string& path = {}) const {
    const Finished finished = flash(arguments, path);
    EXPECT_EQ(finished.status, 2) << finished.output;
    EXPECT_EQ(lines(finished.output), 1u) << finished.output;
    for (const std::string& text : says) EXPECT_THAT(finished.output, HasSubstr(text));
  }
  TemporaryFolder folder_;
};

TEST_F(FlashOf, NoBoardOrSeveralAreNotChosenFrom) {
  expect_refused({}, {"no board found", "plug the Mega in", "--port"});
  list({"/dev/ttyACM0", "/dev/ttyACM1"});
  expect_refused({}, {"/dev/ttyACM0 /dev/ttyACM1", "--port"});
}

TEST_F(FlashOf, TheOnlyBoardNeedsNoOptionAndADryRunDoesNotOpenIt) {
  const sim::Pty board("");
  list({board.device()});
  const Finished finished = flash({"--dry-run"});
  EXPECT_EQ(finished.status, 0) << finished.output;
  EXPECT_THAT(finished.output, HasSubstr("avrdude -q -c wiring -p m2560 -P " + board.device()));
  EXPECT_FALSE(fs::exists(folder_.file("tries")));
}

TEST_F(FlashOf, ABusyPortNamesItsHolder) {
  const sim::Pty board("");
  const int held = ::open(board.device().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(held, 0);
  expect_refused({"--port", board.device()},
                 {"busy", "(pid " + std::to_string(::getpid()) + ")", "end that program"});
  ::close(held);
}

TEST_F(FlashOf, ATerminalOfTheSameNameInAContainerIsNoHolder) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root makes a terminal of a container; run it as root";
  const sim::Pty board("");
  const ContainerTerminal other(board.device());
  ASSERT_TRUE(other.is_held());
  const Finished finished = flash({"--port", board.device(), "--dry-run"});
  EXPECT_EQ(finished.status, 0) << finished.output;
}

TEST_F(FlashOf, WhatIsNoPortIsLeftAlone) {
  expect_refused({"--port", folder_.file("none")}, {"no such port", "plug"});
  expect_refused({"--port", folder_.file("firmware/tp100.hex")}, {"is not a serial port"});
  expect_refused({"--port"}, {"--port needs a value", "--help"});
  expect_refused({"--fast"}, {"--fast", "--help"});
  expect_refused({"--hex", folder_.file("none.hex")}, {"none.hex: no image", "leave --hex out"});
}

TEST_F(FlashOf, AMissingAvrdudeIsNamed) {
  fs::create_directories(folder_.path() / "few");
  for (const char* name : {"bash", "dirname", "sed", "realpath", "find"}) {
    fs::create_symlink(fs::path("/usr/bin") / name, folder_.path() / "few" / name);
  }
  expect_refused({}, {"avrdude is missing", "scripts/setup"}, folder_.file("few"));
}

TEST_F(FlashOf, AFailureSaysWhetherTheBootloaderAnswered) {
  const sim::Pty board("");
  const Finished silent = flash({"--port", board.device()});
  EXPECT_EQ(silent.status, 1) << silent.output;
  EXPECT_THAT(silent.output, HasSubstr("no bootloader answers"));
  EXPECT_EQ(fs::file_size(folder_.file("tries")), 4u) << "the script must try a second time";

  program("avrdude",
          "echo 'avrdude: AVR device initialized and ready to accept instructions'\n"
          "echo 'avrdude error: verification mismatch'; exit 1\n");
  const Finished mismatch = flash({"--port", board.device()});
  EXPECT_EQ(mismatch.status, 1) << mismatch.output;
  EXPECT_THAT(mismatch.output, HasSubstr("verification mismatch"));
  EXPECT_THAT(mismatch.output, HasSubstr("writing or verifying failed"));
}

}  // namespace
}  // namespace tp100::test
