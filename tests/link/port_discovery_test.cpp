// Which ports may be the robot's, which one `auto` opens, who has a port open, and which ports the
// package's udev rules prepare.
#include "link/port_discovery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "../support/as_nobody.h"
#include "../support/temporary_folder.h"
#include "link/port_holder.h"
#include "support/paths.h"

namespace tp100::link {
namespace {

using testing::ContainsRegex;
using ::testing::HasSubstr;
using testing::Not;
using testing::UnorderedElementsAreArray;

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
  for (const KnownPort& id : known_ports()) {
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

TEST_F(Auto, LeavesAloneWhatSomebodyHasOpenAndABridgeWhoseHoldersCannotBeSeen) {
  held_ = "/dev/ttyACM0";
  EXPECT_EQ(opened({mega_}), "none");
  held_ = "/dev/ttyUSB0";
  EXPECT_EQ(opened({bridge_}), "none");
  held_ = "";
  hidden_ = true;
  EXPECT_EQ(opened({bridge_}), "none");
  EXPECT_THAT(why_none(choose({bridge_})), HasSubstr("this account cannot see whether"));
}

TEST_F(Auto, SaysOfEachPortWhyItIsSkippedAndWhatToDo) {
  held_ = "/dev/ttyACM0";
  const AutoChoice choice = choose({bridge_, mega_, other_bridge_});
  EXPECT_FALSE(choice.open);
  EXPECT_EQ(why_none(choice),
            "auto skips /dev/ttyACM0: held open by octoprint (pid 7); /dev/ttyUSB0: not the only "
            "candidate (CH340 bridge); /dev/ttyUSB1: not the only candidate (FTDI bridge); if it "
            "is the robot, name it with --port or link.port (see `tp100d ports`)");
  EXPECT_THAT(why_none(choose({})), HasSubstr("plug the robot in"));
}

// A folder like /proc in which a process, 4711, has files open, seen from the whole machine.
class Holder : public ::testing::Test {
 protected:
  Holder() {
    std::filesystem::create_directories(folder_.path() / "self/ns");
    std::filesystem::create_directories(folder_.path() / "1");
    std::filesystem::create_symlink("pid:[4026531836]", folder_.path() / "self/ns/pid");
    std::filesystem::create_directories(folder_.path() / "4711/fd");
    std::ofstream(folder_.path() / "4711/comm") << "screen\n";
  }
  PortHolder of(const std::string& real_path) const {
    return port_holder(real_path, folder_.path());
  }
  void has_open(const std::string& target, const char* pid = "4711") {
    const auto fd = folder_.path() / pid / "fd";
    std::filesystem::create_directories(fd);
    std::filesystem::create_symlink(target, fd / std::to_string(++files_));
  }
  test::TemporaryFolder folder_;
  int files_ = 2;
};

TEST_F(Holder, OthersCanBeSeenWhereAllProcessesOfTheMachineAre) {
  EXPECT_FALSE(of("/dev/null").others_hidden);
  std::filesystem::remove(folder_.path() / "1");
  EXPECT_TRUE(of("/dev/null").others_hidden) << "the first process is hidden";
  std::filesystem::create_directory(folder_.path() / "1");
  std::filesystem::remove(folder_.path() / "self/ns/pid");
  std::filesystem::create_symlink("pid:[4026532840]", folder_.path() / "self/ns/pid");
  EXPECT_TRUE(of("/dev/null").others_hidden) << "from within a container";
}

TEST_F(Holder, IsWhoHasTheDeviceOpenUnderAnyOfItsNamesOrTheFileOfThatName) {
  EXPECT_EQ(of("/dev/null").name, "");
  const std::string file = folder_.file("data"), alias = folder_.file("alias");
  test::write_bytes(file, "x");
  std::filesystem::create_symlink("/dev/full", alias);
  has_open("/dev/zero");
  has_open(alias);
  has_open(file);
  EXPECT_EQ(of("/dev/full").name, "") << "outside of /dev the look-up may wait for a disk";
  EXPECT_EQ(of(file).name, "screen (pid 4711)");
  EXPECT_EQ(of(folder_.file("other")).name, "");
  has_open("/dev/null");
  EXPECT_EQ(of("/dev/null").name, "screen (pid 4711)");
  EXPECT_EQ(of("/dev/../dev/null").name, "screen (pid 4711)");
  EXPECT_FALSE(of("/dev/null").others_hidden);
}

TEST_F(Holder, OnlyNumbersAreProcessesAndNotThisOne) {
  for (const std::string& name : {std::string("47x"), std::string("x47"), std::string("4/7"),
                                  std::string(":"), std::to_string(::getpid())})
    has_open("/dev/null", name.c_str());
  EXPECT_EQ(of("/dev/null").name, "");
  for (const char* digits : {"9", "0"}) {
    has_open("/dev/null", digits);
    EXPECT_EQ(of("/dev/null").name, "a program (pid " + std::string(digits) + ")");
    std::filesystem::remove_all(folder_.path() / digits);
  }
}

TEST_F(Holder, OthersAreHiddenIfAProcessShowsNoFiles) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become nobody; run it as root";
  has_open("/dev/null");
  namespace fs = std::filesystem;
  fs::permissions(folder_.path(), fs::perms::all);
  fs::permissions(folder_.path() / "4711/fd", fs::perms::none);
  const test::AsNobody nobody;
  const PortHolder holder = of("/dev/null");
  EXPECT_TRUE(holder.others_hidden);
  EXPECT_EQ(holder.name, "");
}

int number(const std::string& hex) { return std::stoi(hex, nullptr, 16); }

std::ifstream open_rules(const std::string& name) {
  return std::ifstream(source_path("config/udev/" + name + ".rules"));
}

using UsbId = std::pair<int, int>;  // of vendor and product

/// The ids for which the rules file `name` performs `action`. A rule has one vendor id and its
/// product ids, separated by bars.
std::vector<UsbId> ids_of(const std::string& name, const std::string& action) {
  const std::regex rule(
      "ATTRS\\{idVendor\\}==\"([0-9a-f]{4})\", ATTRS\\{idProduct\\}==\"([0-9a-f|]+)\", " + action);
  std::ifstream file = open_rules(name);
  std::vector<UsbId> ids;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::smatch found;
    if (!std::regex_match(line, found, rule)) {
      EXPECT_EQ(line.find("ATTRS{idVendor}"), std::string::npos) << line;
      continue;
    }
    std::istringstream products(found[2]);
    for (std::string product; std::getline(products, product, '|');)
      ids.emplace_back(number(found[1]), number(product));
  }
  return ids;
}

std::vector<UsbId> known_ids_of(PortKind kind) {
  std::vector<UsbId> ids;
  for (const KnownPort& known : known_ports())
    if (known.kind == kind) ids.emplace_back(known.vendor_id, known.product_id);
  return ids;
}

TEST(UdevRules, PrepareAMega) {
  EXPECT_THAT(ids_of("65-tp100", "GOTO=\"tp100_board\""),
              UnorderedElementsAreArray(known_ids_of(PortKind::kMega)));
}

TEST(UdevRules, PrepareABridgeWhereSomebodyAsksForIt) {
  EXPECT_THAT(ids_of("64-tp100-bridges", "ENV\\{TP100_BOARD\\}=\"1\""),
              UnorderedElementsAreArray(known_ids_of(PortKind::kBridge)));
}

// Otherwise they would override an earlier rule of the administrator.
TEST(UdevRules, SayNothingOfASerialPortsGroupAndMode) {
  for (const char* name : {"64-tp100-bridges", "65-tp100"}) {
    std::ifstream file = open_rules(name);
    ASSERT_TRUE(file.is_open()) << name;
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with('#') || line.starts_with("SUBSYSTEM==\"misc\"")) continue;
      EXPECT_THAT(line, Not(ContainsRegex("(GROUP|MODE|OWNER)")));
    }
  }
}

}  // namespace
}  // namespace tp100::link
