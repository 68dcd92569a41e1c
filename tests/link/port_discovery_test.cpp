#include "link/port_discovery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tp100::link {
namespace {

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

TEST(PortDiscovery, PutsMegasBeforeBridgesAndLeavesTheRestOut) {
  const auto result =
      candidates({port("/dev/ttyS0", -1, -1), port("/dev/ttyUSB1", 0x0403, 0x6001),
                  port("/dev/ttyACM1", 0x2a03, 0x0042), port("/dev/ttyUSB0", 0x1a86, 0x7523),
                  port("/dev/ttyACM9", 0x1d6b, 0x0104), port("/dev/ttyACM0", 0x2341, 0x0042)});
  EXPECT_THAT(paths(result), ::testing::ElementsAre("/dev/ttyACM0", "/dev/ttyACM1", "/dev/ttyUSB0",
                                                    "/dev/ttyUSB1"));
}

TEST(PortDiscovery, EqualBoardsComeInTheOrderOfTheirPaths) {
  const auto result =
      candidates({port("/dev/ttyACM2", 0x2341, 0x0042), port("/dev/ttyACM1", 0x2341, 0x0042)});
  EXPECT_THAT(paths(result), ::testing::ElementsAre("/dev/ttyACM1", "/dev/ttyACM2"));
}

TEST(PortDiscovery, NamesWhatItKnows) {
  EXPECT_EQ(describe(port("a", 0x2341, 0x0042)), "Arduino Mega 2560");
  EXPECT_EQ(describe(port("a", 0x2341, 0x0242)), "Arduino Mega 2560");
  EXPECT_EQ(describe(port("a", 0x1a86, 0x7523)), "CH340 bridge");
  EXPECT_EQ(classify(port("a", -1, -1)), PortKind::kOther);
}

TEST(PortDiscovery, ListsThisMachinesPortsWithoutFailing) {
  for (const PortInfo& info : list_ports()) EXPECT_FALSE(info.path.empty());
}

}  // namespace
}  // namespace tp100::link
