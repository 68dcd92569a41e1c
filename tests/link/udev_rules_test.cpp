// The package's udev rules prepare every port that the daemon finds likely, and no other.

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

int number(const std::string& hex) { return std::stoi(hex, nullptr, 16); }

/// A rule has one vendor and its products, separated by bars.
std::vector<UsbId> ids_of_the_rules() {
  const std::regex rule(
      "ATTRS\\{idVendor\\}==\"([0-9a-f]{4})\", ATTRS\\{idProduct\\}==\"([0-9a-f|]+)\", "
      "GOTO=\"tp100_board\"");
  std::ifstream file(TP100_SOURCE_DIR "/config/udev/65-tp100.rules");
  std::vector<UsbId> ids;
  for (std::string line; std::getline(file, line);) {
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

TEST(UdevRules, CoverWhatTheDaemonFindsLikely) {
  EXPECT_THAT(ids_of_the_rules(), ::testing::UnorderedElementsAreArray(known_ids()));
}

}  // namespace
}  // namespace tp100::link
