#include <cstdio>
#include <string>
#include <vector>

#include "sim/faults/fault.h"
#include "sim/robot/options.h"
#include "sim/trials/commands.h"
#include "sim/trials/encoder_study.h"
#include "sim/trials/fault_study.h"
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

int drive_all(BoardKind board) {
  std::printf("| `--fault` | expected | seen |\n|---|---|---|\n");
  bool good = true;
  for (const FaultTrial& trial : fault_trials()) {
    if (trial.chip_only && board != BoardKind::kAvr) continue;
    const FaultOutcome outcome = try_fault(trial, board);
    good = good && outcome.as_expected;
    std::printf("| `%s` | %s | %s |\n", std::string(trial.fault).c_str(),
                expected_effect(trial).c_str(), seen_effect(trial, outcome).c_str());
    std::fflush(stdout);
  }
  return good ? 0 : 1;
}

int sweep_encoders(const FaultsCommand& command, BoardKind board) {
  EncoderStudy study(!command.firmware_alone);
  std::printf("%s", encoder_table_head().c_str());
  bool good = true;
  for (const EncoderFailure& failure : encoder_failures()) {
    std::vector<EncoderOutcome> row;
    for (const double speed_mps : encoder_speeds()) {
      row.emplace_back();
      for (const EncoderTrial& trial : encoder_trials(failure, speed_mps, board, true)) {
        const EncoderOutcome outcome = study.drive(trial);
        good = good && outcome.good();
        if (!outcome.good())
          std::fprintf(stderr, "%s at %.2f m/s, %s, %s: %s\n", std::string(failure.fault).c_str(),
                       speed_mps, to_string(trial.onset), std::string(trial.robot).c_str(),
                       outcome.end.c_str());
        row.back().merge(outcome);
      }
    }
    std::printf("%s", encoder_row(failure, row).c_str());
    std::fflush(stdout);
  }
  return good ? 0 : 1;
}

}  // namespace

int run_faults(const FaultsCommand& command) {
  Options options;
  options.board = command.board;
  const BoardKind board = load(options).board;
  if (command.drive) return drive_all(board);
  if (command.encoders) return sweep_encoders(command, board);
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
