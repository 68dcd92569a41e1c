#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <system_error>
#include <utility>

#include "config/parameter_file.h"
#include "core/error.h"
#include "live/services.h"
#include "live/setup_changer.h"
#include "text/atomic_file.h"
#include "text/file_name.h"
#include "text/json_writer.h"

namespace tp100::live {
namespace {

namespace fs = std::filesystem;
using course::Bundled;
using server::Answer;
using server::Arguments;
using server::json_of;
using server::Request;
using server::Service;

/// One of the user's own files, as a viewer names it.
struct UserFile {
  Bundled kind{};
  std::string name, text;
  bool replace = false;
};

Result<UserFile> read_file(const Arguments& given) {
  const std::string kind = given.text("kind").value_or("");
  if (kind != "course" && kind != "robot") return Refusal{"kind must be \"course\" or \"robot\""};
  const std::string name = given.text("name").value_or("");
  if (!text::is_found_name(name)) return Refusal{text::kFoundNameRule};
  return UserFile{.kind = kind == "robot" ? Bundled::kRobots : Bundled::kCourses,
                  .name = name,
                  .text = given.text("text").value_or(""),
                  .replace = given.flag("replace").value_or(false)};
}

std::string check_file(const SetupChanger& changer, const UserFile& file) {
  return checked_file(changer.in_force()->loaded, file.kind, {file.name + ".toml", file.text}).json;
}

std::string save_file(const SetupChanger& changer, const UserFile& file) {
  changer.files().save(file.kind, file.name, file.text, file.replace);
  return json_of({{"name", file.name}});
}

std::string delete_file(const SetupChanger& changer, const UserFile& file) {
  const std::shared_ptr<const ActiveRun> now = changer.in_force();
  if (file.name == (file.kind == Bundled::kRobots ? now->loaded.setup.robot.name : now->course()))
    throw UserError(file.name + " is in use; choose another one first");
  changer.files().remove(file.kind, file.name);
  return json_of({{"name", file.name}});
}

bool is_file(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// Unless `check` or nothing differs, calls `write`, which replaces the configuration file by
/// `next`. Returns the answer.
std::string replaced(const course::TextFile& now, const std::string& next, bool check,
                     const std::function<void()>& write) {
  const auto differences = config::parameter_differences(now, {now.path, next});
  for (const config::ParameterDifference& each : differences)
    if (each.name == "robot" || each.name == "course" || each.name == "setup") {
      // A daemon that is started with this configuration alone must find its files.
      config::require_fit(config::parse_run(config::named_files({now.path, next})));
      break;
    }
  const bool written = !check && next != now.text;
  if (written) write();
  return text::json_object([&](text::JsonWriter& json) {
    json.field("file", fs::path(now.path).filename().string())
        .field("written", written)
        .field("may_restore", is_file(text::kept_path(now.path)));
    json.objects("differences", differences, [&](const config::ParameterDifference& each) {
      json.field("name", each.name).field("before", each.before).field("after", each.after);
    });
  });
}

/// Throws UserError.
course::TextFile configuration_file(const SetupChanger& changer) {
  const std::string path = changer.in_force()->loaded.files.configuration.path;
  if (path.empty())
    throw UserError("tp100d has no configuration file to save into: start it with --config FILE");
  if (!is_file(path))
    throw UserError(fs::path(path).filename().string() + ": the file no longer exists");
  return course::read_text_file(path);
}

/// Why a viewer may not save that value; its type is taken from the parameter.
Result<messages::ParameterValue> read_value(const messages::ParameterText& parameter,
                                            const server::NamedValue& given) {
  const std::string& name = parameter.name;
  if (!parameter.may_save)
    return Refusal{name + (name.starts_with("robot.")
                               ? " is a value of the robot's file; change it there"
                               : " cannot be saved by viewers; set it in the file")};
  if (!given.value) return Refusal{name + " takes no value of that type"};
  const auto* words = std::get_if<std::string>(&*given.value);
  if (words != nullptr && parameter.type == messages::ParameterText::Type::kText &&
      !words->empty() && !text::is_found_name(*words))
    return Refusal{name + ": " + text::kFoundNameRule};
  if (std::string why = messages::why_not(parameter, *given.value); !why.empty())
    return Refusal{why};
  return *given.value;
}

Result<config::ParameterValues> read_values(const std::vector<messages::ParameterText>& known,
                                            const Request& request, bool check) {
  config::ParameterValues values;
  for (const server::NamedValue& field : request.arguments.fields()) {
    if (field.name == "check") continue;
    const auto found = std::ranges::find(known, field.name, &messages::ParameterText::name);
    if (found == known.end()) return server::no_such("parameter", field.name);
    const Result<messages::ParameterValue> value = read_value(*found, field);
    if (!value) return value.refusal();
    if (!check && !found->live && request.under_way())
      return Refusal{field.name +
                     " takes effect when tp100d is started again, and is not saved during a run"};
    values.emplace_back(field.name, *value);
  }
  if (values.empty()) return Refusal{"give parameters and their values"};
  return values;
}

Result<> save_parameters(SetupChanger& changer, const Request& request, const Answer& answer) {
  const bool check = request.arguments.flag("check").value_or(false);
  const Result<config::ParameterValues> values =
      read_values(changer.in_force()->parameters, request, check);
  if (!values) return values.refusal();
  changer.disk().ask(answer, [&changer, check, values = *values] {
    const course::TextFile now = configuration_file(changer);
    const std::string next = config::with_parameters(now, values);
    return replaced(now, next, check, [&] { text::edit_file(now.path, next); });
  });
  return Done{};
}

Result<> restore_parameters(SetupChanger& changer, const Request& request, const Answer& answer) {
  const bool check = request.arguments.flag("check").value_or(false);
  if (!check && request.under_way()) return Refusal{"not during a run; stop it first"};
  changer.disk().ask(answer, [&changer, check] {
    const course::TextFile now = configuration_file(changer);
    const std::string kept = text::kept_path(now.path);
    if (!is_file(kept)) throw UserError("nothing was saved yet: there is no file to restore");
    return replaced(now, course::read_text_file(kept).text, check,
                    [&] { text::restore_file(now.path); });
  });
  return Done{};
}

}  // namespace

std::vector<server::ServiceRow> file_services(SetupChanger& changer) {
  const auto on_disk = [&changer](std::string (*does)(const SetupChanger&, const UserFile&)) {
    return [&changer, does](const Request& request, const Answer& answer) -> Result<> {
      const Result<UserFile> file = read_file(request.arguments);
      if (!file) return file.refusal();
      changer.disk().ask(answer, [&changer, does, file = *file] { return does(changer, file); });
      return Done{};
    };
  };
  constexpr const char* kName = R"({"name":""})";
  constexpr const char* kFile = R"({"kind":"","name":""})";
  constexpr const char* kDraft = R"({"kind":"","name":"","text":""})";
  constexpr const char* kNew = R"({"kind":"","name":"","text":"","replace":true})";
  constexpr const char* kChecked =
      R"({"error":"","line":1,"column":1,"why_not":"","length_m":1.5,"duration_s":1.5,)"
      R"("course":{}})";
  constexpr const char* kCheck = R"({"check":true})";
  constexpr const char* kSaved = R"({"file":"","written":true,"may_restore":true,)"
                                 R"("differences":[{"name":"","before":"","after":""}]})";
  const auto save = std::bind_front(save_parameters, std::ref(changer));
  const auto restore = std::bind_front(restore_parameters, std::ref(changer));
  return {
      {Service::kFileSave, "file_save", kNew, kName, on_disk(save_file)},
      {Service::kFileDelete, "file_delete", kFile, kName, on_disk(delete_file)},
      {Service::kFileCheck, "file_check", kDraft, kChecked, on_disk(check_file)},
      {Service::kParametersSave, "parameters_save", kCheck, kSaved, save, {.more_arguments = true}},
      {Service::kParametersRestore, "parameters_restore", kCheck, kSaved, restore}};
}

std::optional<std::string> setup_content(const SetupChanger& changer, std::string_view path) {
  if (path == "/api/setup") return setup_list(changer.files(), changer.in_force()->loaded);
  constexpr std::string_view kEnding = ".toml";
  for (const auto& [folder, kind] :
       {std::pair<std::string_view, Bundled>{"/courses/", Bundled::kCourses},
        {"/robots/", Bundled::kRobots}}) {
    if (!path.starts_with(folder) || !path.ends_with(kEnding)) continue;
    path.remove_prefix(folder.size());
    path.remove_suffix(kEnding.size());
    try {
      return changer.files().read(kind, std::string(path)).text;
    } catch (const UserError&) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace tp100::live
