#include "link/port_discovery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "../support/as_nobody.h"
#include "../support/temporary_folder.h"
#include "link/port_holder.h"

namespace tp100::link {
namespace {

using ::testing::HasSubstr;

PortInfo port(const char* path, int vendor_id, int product_id) {
  PortInfo info;
  info.path = path;
  info.vendor_id = vendor_id;
  info.product_id = product_id;
  return info;
}

std::vector<std::string> paths(const std::vector<PortInfo>& ports) {
  std::vector<std::string> result;
  for (const PortInfo& info : ports) result.push_back(info.path);
  return result;
}

TEST(PortDiscovery, PutsMegasBeforeBridgesEachByItsPathAndLeavesTheRestOut) {
  const auto result =
      candidates({port("/dev/ttyS0", -1, -1), port("/dev/ttyUSB1", 0x0403, 0x6001),
                  port("/dev/ttyACM5", 0x2a03, 0x0042), port("/dev/ttyACM2", 0x2341, 0x0042),
                  port("/dev/ttyUSB0", 0x1a86, 0x7523), port("/dev/ttyACM9", 0x1d6b, 0x0104),
                  PortInfo(), port("/dev/ttyACM1", 0x2341, 0x0042)});
  EXPECT_THAT(paths(result), ::testing::ElementsAre("/dev/ttyACM1", "/dev/ttyACM2", "/dev/ttyACM5",
                                                    "/dev/ttyUSB0", "/dev/ttyUSB1"));
}

// Which ids these are, the udev rules say too.
TEST(PortDiscovery, KnowsEachBoardByBothOfItsIdsAndNamesIt) {
  for (const UsbId& id : known_ids()) {
    PortInfo known = port("a", id.vendor_id, id.product_id);
    known.product = "USB Serial";
    EXPECT_NE(classify(known), PortKind::kOther);
    EXPECT_THAT(
        describe(known),
        ::testing::EndsWith(classify(known) == PortKind::kMega ? "Arduino Mega 2560" : " bridge"));
    EXPECT_EQ(classify(port("a", id.vendor_id, 1)), PortKind::kOther);
    EXPECT_EQ(classify(port("a", 1, id.product_id)), PortKind::kOther);
  }
  PortInfo other = port("a", 0x1d6b, 0x0104);
  EXPECT_EQ(describe(other), "serial port");
  other.product = "Mill controller";
  EXPECT_EQ(describe(other), "Mill controller");
}

class Auto : public ::testing::Test {
 protected:
  AutoChoice choose(const std::vector<PortInfo>& ports) const {
    return choose_for_auto(ports, [this](const std::string& path) {
      return PortHolder{path == held_ ? "octoprint (pid 7)" : "", hidden_};
    });
  }
  std::string opened(const std::vector<PortInfo>& ports) const {
    const AutoChoice choice = choose(ports);
    return choice.open ? choice.open->path : "none";
  }
  std::string held_;
  bool hidden_ = false;
  PortInfo mega_ = port("/dev/ttyACM0", 0x2341, 0x0042);
  PortInfo other_mega_ = port("/dev/ttyACM1", 0x2341, 0x0042);
  PortInfo bridge_ = port("/dev/ttyUSB0", 0x1a86, 0x7523);
  PortInfo other_bridge_ = port("/dev/ttyUSB1", 0x0403, 0x6001);
};

TEST_F(Auto, OpensTheOnlyBoardThatMayBeTheRobot) {
  const PortInfo serial_port = port("/dev/ttyS0", -1, -1);
  for (const PortInfo& board : {mega_, bridge_}) {
    EXPECT_EQ(opened({board}), board.path);
    EXPECT_EQ(opened({serial_port, board}), board.path);
  }
  hidden_ = true;
  EXPECT_EQ(opened({mega_}), "/dev/ttyACM0");
}

// A printer or a mill is a Mega too: opening its port resets it in the middle of its work.
TEST_F(Auto, OpensNoneOfSeveralWhoeverHasOneOfThemOpen) {
  const std::vector<PortInfo> boards = {mega_, other_mega_, bridge_, other_bridge_};
  for (const char* held : {"", "/dev/ttyACM0", "/dev/ttyUSB0"}) {
    held_ = held;
    for (const PortInfo& one : boards) {
      for (const PortInfo& other : boards) {
        if (one.path == other.path) continue;
        const AutoChoice choice = choose({one, other});
        EXPECT_FALSE(choice.open) << one.path << " and " << other.path;
        EXPECT_EQ(choice.passed_over.size(), 2U) << "all are listed";
      }
    }
    EXPECT_EQ(opened(boards), "none");
  }
}

TEST_F(Auto, LeavesAloneWhatSomebodyHasOpen) {
  held_ = "/dev/ttyACM0";
  EXPECT_EQ(opened({mega_}), "none");
  held_ = "/dev/ttyUSB0";
  EXPECT_EQ(opened({bridge_}), "none");
}

TEST_F(Auto, LeavesABridgeAloneIfItsHoldersCannotBeSeen) {
  hidden_ = true;
  EXPECT_EQ(opened({bridge_}), "none");
  EXPECT_THAT(why_none(choose({bridge_})), HasSubstr("this account cannot see whether"));
}

TEST_F(Auto, SaysOfEachPortWhyItIsSkipped) {
  held_ = "/dev/ttyACM0";
  const AutoChoice choice = choose({bridge_, mega_, other_bridge_});
  EXPECT_FALSE(choice.open);
  EXPECT_EQ(why_none(choice),
            "auto skips /dev/ttyACM0: held open by octoprint (pid 7); /dev/ttyUSB0: not the only "
            "candidate (CH340 bridge); /dev/ttyUSB1: not the only candidate (FTDI bridge); if it "
            "is the robot, name it with --port or link.port (see `tp100d ports`)");
}

TEST_F(Auto, SaysWhatToDoIfThereIsNothing) {
  EXPECT_THAT(why_none(choose({})), HasSubstr("plug the robot in"));
}

// A folder like /proc in which one process has `target` open.
class Holder : public ::testing::Test {
 protected:
  Holder() {
    std::filesystem::create_directories(folder_.path() / "self/ns");
    std::filesystem::create_directories(folder_.path() / "1");
    std::filesystem::create_directories(folder_.path() / "4711/fd");
    std::ofstream(folder_.path() / "4711/comm") << "screen\n";
  }
  PortHolder of(const std::string& real_path) const {
    return port_holder(real_path, folder_.path());
  }
  void seen_from(const char* processes) const {
    std::filesystem::create_symlink(processes, folder_.path() / "self/ns/pid");
  }
  void has_open(const char* target) const {
    std::filesystem::create_symlink(target, folder_.path() / "4711/fd/3");
  }
  test::TemporaryFolder folder_;
};

TEST_F(Holder, OthersCanBeSeenWhereAllProcessesOfTheMachineAre) {
  seen_from("pid:[4026531836]");
  EXPECT_FALSE(of("/dev/null").others_hidden);
  EXPECT_EQ(of("/dev/null").name, "");
}

TEST_F(Holder, OthersAreHiddenFromWithinAContainer) {
  seen_from("pid:[4026532840]");
  EXPECT_TRUE(of("/dev/null").others_hidden);
}

TEST_F(Holder, IsWhoHasTheDeviceOpenUnderAnyOfItsNames) {
  seen_from("pid:[4026531836]");
  has_open("/dev/null");
  EXPECT_EQ(of("/dev/null").name, "screen (pid 4711)");
  EXPECT_EQ(of("/dev/../dev/null").name, "screen (pid 4711)");
  EXPECT_EQ(of("/dev/zero").name, "");
}

TEST_F(Holder, OthersAreHiddenWhereTheFirstProcessIs) {
  seen_from("pid:[4026531836]");
  std::filesystem::remove(folder_.path() / "1");
  EXPECT_TRUE(of("/dev/null").others_hidden);
}

TEST_F(Holder, OnlyNumbersAreProcessesAndNotThisOne) {
  seen_from("pid:[4026531836]");
  for (const std::string& name : {std::string("47x"), std::string("x47"), std::string("4/7"),
                                  std::string(":"), std::to_string(::getpid())}) {
    const auto fd = folder_.path() / name / "fd";
    std::filesystem::create_directories(fd);
    std::filesystem::create_symlink("/dev/null", fd / "3");
  }
  EXPECT_EQ(of("/dev/null").name, "");
  for (const char* digits : {"9", "0"}) {
    const auto fd = folder_.path() / digits / "fd";
    std::filesystem::create_directories(fd);
    std::filesystem::create_symlink("/dev/null", fd / "3");
    EXPECT_EQ(of("/dev/null").name, "a program (pid " + std::string(digits) + ")");
    std::filesystem::remove_all(folder_.path() / digits);
  }
}

TEST_F(Holder, IsFoundAmongItsOtherFilesByTheNameOfAnyFile) {
  seen_from("pid:[4026531836]");
  has_open("/dev/zero");
  const std::string file = folder_.file("data");
  test::write_bytes(file, "x");
  std::filesystem::create_symlink(file, folder_.path() / "4711/fd/4");
  std::filesystem::create_symlink("/dev/full", folder_.path() / "4711/fd/5");
  EXPECT_EQ(of(file).name, "screen (pid 4711)");
  EXPECT_EQ(of("/dev/full").name, "screen (pid 4711)");
  EXPECT_EQ(of("/dev/null").name, "");
  EXPECT_EQ(of(folder_.file("other")).name, "");
  EXPECT_FALSE(of("/dev/null").others_hidden);
}

// Elsewhere the look-up may wait for a disk.
TEST_F(Holder, IsSoughtByItsDeviceInDevOnly) {
  seen_from("pid:[4026531836]");
  const std::string alias = folder_.file("alias");
  std::filesystem::create_symlink("/dev/null", alias);
  has_open(alias.c_str());
  EXPECT_EQ(of("/dev/null").name, "");
}

TEST_F(Holder, OthersAreHiddenIfAProcessShowsNoFiles) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become nobody; run it as root";
  seen_from("pid:[4026531836]");
  has_open("/dev/null");
  namespace fs = std::filesystem;
  fs::permissions(folder_.path(), fs::perms::all);
  fs::permissions(folder_.path() / "4711/fd", fs::perms::none);
  const test::AsNobody nobody;
  const PortHolder holder = of("/dev/null");
  EXPECT_TRUE(holder.others_hidden);
  EXPECT_EQ(holder.name, "");
}

TEST(PortDiscovery, ListsThisMachinesPortsWithoutFailing) {
  for (const PortInfo& info : list_ports()) EXPECT_FALSE(info.path.empty());
}

}  // namespace
}  // namespace tp100::link
