#include "sim/faults/fault.h"

#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/time.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::sim {
namespace {

constexpr double kMaxS = 1e6;

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
  throw UserError("--fault " + one_line(std::string(text)) + ": " + why + "; see tp100-sim faults");
}

std::optional<double> number_of(std::string_view text) {
  const auto value = text::number_in<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Removes and returns the part before `mark`; also removes `mark`.
std::string_view cut(std::string_view& rest, char mark) {
  const std::size_t at = rest.find(mark);
  const std::string_view head = rest.substr(0, at);
  rest.remove_prefix(at == std::string_view::npos ? rest.size() : at + 1);
  return head;
}

FaultKind kind_named(std::string_view name, std::string_view whole) {
  std::vector<std::string_view> names;
  for (const InjectableFault& row : kInjectableFaults) {
    if (row.name == name) return names.size();
    names.push_back(row.name);
  }
  refuse(whole, "no such fault" + text::suggestion(name, names));
}

bool take_word(std::string_view word, FaultWord kind, PlannedFault& fault) {
  if (kind == FaultWord::kDirection && (word == "to-host" || word == "to-robot")) {
    fault.to_host = word == "to-host";
    fault.to_robot = !fault.to_host;
    return true;
  }
  if (kind == FaultWord::kSide && (word == "left" || word == "right")) {
    fault.left = word == "left";
    fault.right = !fault.left;
    return true;
  }
  return false;
}

void take_number(std::string_view word, const InjectableFault& row, std::string_view whole,
                 PlannedFault& fault) {
  const std::optional<double> number = row.number.empty() ? std::nullopt : number_of(word);
  if (!number)
    refuse(whole,
           "'" + one_line(std::string(word)) + "' says nothing about " + std::string(row.name));
  if (*number < row.least || *number > row.most)
    refuse(whole, std::string(row.number) + " is out of range");
  fault.number = *number;
}

HostNs time_of(std::string_view text, std::string_view whole) {
  const std::optional<double> seconds = number_of(text);
  if (!seconds || *seconds < 0.0 || *seconds > kMaxS)
    refuse(whole, "'" + one_line(std::string(text)) + "' is no time in seconds");
  return from_s(*seconds);
}

}  // namespace

PlannedFault parse_fault(std::string_view whole) {
  std::string_view when = whole;
  std::string_view what = cut(when, '@');
  const bool timed = what.size() < whole.size();
  const FaultKind kind = kind_named(cut(what, ':'), whole);
  const InjectableFault& row = kInjectableFaults[kind];
  PlannedFault fault{.kind = kind, .number = row.standard};
  while (!what.empty()) {
    const std::string_view word = cut(what, ':');
    if (!take_word(word, row.word, fault)) take_number(word, row, whole, fault);
  }
  if (!timed) return fault;
  const bool ends = when.find('+') != std::string_view::npos;
  fault.begin_ns = time_of(cut(when, '+'), whole);
  if (ends && row.at_once) refuse(whole, "happens once and does not last");
  if (ends) fault.end_ns = fault.begin_ns + time_of(when, whole);
  return fault;
}

std::vector<PlannedFault> parse_faults(const std::vector<std::string>& texts) {
  std::vector<PlannedFault> faults;
  faults.reserve(texts.size());
  for (const std::string& text : texts) faults.push_back(parse_fault(text));
  return faults;
}

}  // namespace tp100::sim
