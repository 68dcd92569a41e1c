#include "sim/faults/planned_fault.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/time.h"
#include "text/nearest.h"
#include "text/toml_document.h"

namespace tp100::sim {
namespace {

constexpr double kMostS = 1e6;

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
  throw SetupError("--fault " + text::one_line(std::string(text)) + ": " + why +
                   "; see tp100-sim faults");
}

std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// Up to `mark`, which is taken away with it.
std::string_view cut(std::string_view& rest, char mark) {
  const std::size_t at = rest.find(mark);
  const std::string_view head = rest.substr(0, at);
  rest.remove_prefix(at == std::string_view::npos ? rest.size() : at + 1);
  return head;
}

const FaultText& kind_named(std::string_view name, std::string_view whole) {
  std::vector<std::string_view> names;
  for (const FaultText& text : fault_texts()) {
    if (text.name == name) return text;
    names.push_back(text.name);
  }
  const std::string_view meant = text::nearest_name(std::string(name), names);
  refuse(whole,
         "no such fault" + (meant.empty() ? "" : "; did you mean '" + std::string(meant) + "'?"));
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

void take_number(std::string_view word, const FaultText& text, std::string_view whole,
                 PlannedFault& fault) {
  const std::optional<double> number = text.number.empty() ? std::nullopt : number_of(word);
  if (!number)
    refuse(whole, "'" + text::one_line(std::string(word)) + "' says nothing about " +
                      std::string(text.name));
  if (*number < text.least || *number > text.most)
    refuse(whole, std::string(text.number) + " is out of range");
  fault.number = *number;
}

std::int64_t time_of(std::string_view text, std::string_view whole) {
  const std::optional<double> seconds = number_of(text);
  if (!seconds || *seconds < 0.0 || *seconds > kMostS)
    refuse(whole, "'" + text::one_line(std::string(text)) + "' is no time in seconds");
  return from_s(*seconds);
}

}  // namespace

PlannedFault parse_fault(std::string_view whole) {
  std::string_view when = whole;
  std::string_view what = cut(when, '@');
  const bool timed = what.size() < whole.size();
  const FaultText& text = kind_named(cut(what, ':'), whole);
  PlannedFault fault{.kind = text.kind, .number = text.standard};
  while (!what.empty()) {
    const std::string_view word = cut(what, ':');
    if (!take_word(word, text.word, fault)) take_number(word, text, whole, fault);
  }
  if (!timed) return fault;
  const bool ends = when.find('+') != std::string_view::npos;
  fault.begin_ns = time_of(cut(when, '+'), whole);
  if (ends && text.at_once) refuse(whole, "happens once and does not last");
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
