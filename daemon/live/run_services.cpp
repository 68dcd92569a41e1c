#include <algorithm>
#include <functional>
#include <sstream>
#include <string>

#include "live/services.h"
#include "runs/run_archive.h"
#include "text/file_name.h"

namespace tp100::live {
namespace {

using server::Answer;
using server::Arguments;
using server::Request;
using server::Service;

constexpr std::size_t kMaxDrives = 100;

/// Whether these arguments are names of runs.
bool named(const Arguments& given, std::initializer_list<const char*> arguments) {
  return std::ranges::all_of(arguments, [&](const char* argument) {
    return text::is_found_name(given.text(argument).value_or(""));
  });
}

Result<> note(runs::RunArchive& runs, const std::string& run, const Arguments& given,
              const Answer& answer) {
  const runs::RunNoteChange change{.name = given.text("name"),
                                   .note = given.text("note"),
                                   .tags = given.text("tags"),
                                   .keep = given.flag("keep")};
  if (std::string why = runs::why_not(runs::changed({}, change)); !why.empty()) return Refusal{why};
  runs.change_note(run, change, answer);
  return Done{};
}

Result<> compare(runs::RunArchive& runs, const Request& request, const Answer& answer) {
  const Arguments& given = request.arguments;
  if (!named(given, {"run", "with"}))
    return Refusal{"run and with must be names of runs, as GET /api/runs lists them"};
  runs.compare(*given.text("run"), *given.text("with"), answer);
  return Done{};
}

Result<> identify(runs::RunArchive& runs, const Request& request, const Answer& answer) {
  std::vector<std::string> drives;
  std::istringstream words(request.arguments.text("runs").value_or(""));
  for (std::string name; words >> name;) drives.push_back(name);
  if (drives.empty() || drives.size() > kMaxDrives ||
      !std::ranges::all_of(drives, text::is_found_name))
    return Refusal{"runs must be one to " + std::to_string(kMaxDrives) +
                   " names of runs, separated by spaces, as GET /api/runs lists them"};
  runs.identify(drives, request.arguments.text("measured").value_or(""), answer);
  return Done{};
}

}  // namespace

std::vector<server::ServiceRow> run_services(runs::RunArchive& runs) {
  /// Of a request about one run.
  const auto about = [&runs](auto does) {
    return [&runs, does](const Request& request, const Answer& answer) -> Result<> {
      if (!named(request.arguments, {"run"}))
        return Refusal{"run must be the name of a run, as GET /api/runs lists it"};
      return does(runs, *request.arguments.text("run"), request.arguments, answer);
    };
  };
  const auto simple = [&](void (runs::RunArchive::*does)(const std::string&, const Answer&)) {
    return about([does](runs::RunArchive& of, const std::string& run, const Arguments&,
                        const Answer& answer) -> Result<> {
      (of.*does)(run, answer);
      return Done{};
    });
  };
  const auto compared = std::bind_front(compare, std::ref(runs));
  const auto identified = std::bind_front(identify, std::ref(runs));
  constexpr const char* kNote = R"({"run":"","name":"","note":"","tags":"","keep":true})";
  constexpr const char* kNoted =
      R"({"run":"","name":"","note":"","tags":"","keep":true,"marks":[{"t_s":1.5,"text":""}]})";
  constexpr const char* kRun = R"({"run":""})";
  constexpr const char* kTwo = R"({"run":"","with":""})";
  constexpr const char* kReport = R"({"run":"","url":""})";
  constexpr const char* kDrives = R"({"runs":"","measured":""})";
  constexpr const char* kFound =
      R"({"found":{"robot":"","parameters":[{"name":"","unit":"","before":1.5,"found":true}],)"
      R"("errors_before":{"runs":[{"name":"","images":1,"rejected":1}]},)"
      R"("errors_after":{"runs":[{"name":"","images":1,"rejected":1}]},)"
      R"("condition":1.5,"warnings":[""]},"text":""})";
  return {
      {Service::kRunNote, "run_note", kNote, kNoted, about(note)},
      {Service::kRunDelete, "run_delete", kRun, kRun, simple(&runs::RunArchive::remove)},
      {Service::kRunReport, "run_report", kRun, kReport, simple(&runs::RunArchive::report)},
      {Service::kRunCompare, "run_compare", kTwo, kReport, compared},
      {Service::kRunIdentify, "run_identify", kDrives, kFound, identified},
  };
}

}  // namespace tp100::live
