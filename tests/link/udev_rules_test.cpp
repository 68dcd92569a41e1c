// The package's udev rules prepare the ports of a Mega, those of bridges on request, and no others.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "link/port_discovery.h"
#include "support/paths.h"

namespace tp100::link {

void PrintTo(const UsbId& id, std::ostream* out) {
  *out << std::hex << id.vendor_id << ":" << id.product_id;
}

namespace {

using testing::ContainsRegex;
using testing::Not;
using testing::UnorderedElementsAreArray;

int number(const std::string& hex) { return std::stoi(hex, nullptr, 16); }

std::ifstream open_rules(const std::string& name) {
  return std::ifstream(source_path("config/udev/" + name + ".rules"));
}

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
      ids.push_back({number(found[1]), number(product)});
  }
  return ids;
}

std::vector<UsbId> known_ids_of(PortKind kind) {
  std::vector<UsbId> ids;
  for (const UsbId& id : known_ids()) {
    PortInfo port;
    port.vendor_id = id.vendor_id;
    port.product_id = id.product_id;
    if (classify(port) == kind) ids.push_back(id);
  }
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
