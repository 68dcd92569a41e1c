#include <cstdio>
#include <string>
#include <string_view>

#include "sim/faults/fault.h"
#include "sim/trials/commands.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

std::string_view words(FaultWord word) {
  switch (word) {
    case FaultWord::kDirection:
      return "to-host|to-robot";
    case FaultWord::kSide:
      return "left|right";
    case FaultWord::kNone:
      break;
  }
  return "";
}

void print_row(const InjectableFault& row) {
  std::string usage(row.name);
  if (!row.number.empty()) usage += text::format(":%g", row.standard);
  if (row.word != FaultWord::kNone) usage += "[:" + std::string(words(row.word)) + "]";
  std::printf("  %-36s %s%s%.*s%s\n", usage.c_str(), std::string(row.what).c_str(),
              row.number.empty() ? "" : " [", static_cast<int>(row.number.size()),
              row.number.data(), row.number.empty() ? "" : "]");
}

}  // namespace

int run_faults() {
  std::printf(
      "--fault NAME[:NUMBER][:WORD][@T[+D]], from T s after the port was opened (0) for D s "
      "(for ever)\n");
  std::string_view group;
  for (const InjectableFault& row : kInjectableFaults) {
    if (row.group != group)
      std::printf("\n%.*s\n", static_cast<int>(row.group.size()), row.group.data());
    group = row.group;
    print_row(row);
  }
  return 0;
}

}  // namespace tp100::sim
