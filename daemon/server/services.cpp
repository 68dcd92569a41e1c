#include "server/services.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include "messages/messages.h"
#include "runs/run_folder.h"
#include "text/file_name.h"
#include "text/format.h"
#include "text/json_writer.h"

namespace tp100::server {
namespace {

constexpr std::size_t kMaxShownArgument = 64;
constexpr const char* kSaved = R"({"file":"","written":true,"may_restore":true,)"
                               R"("differences":[{"name":"","before":"","after":""}]})";
constexpr std::size_t kMaxDrives = 100;
constexpr double kMaxPlaceM = 100.0, kMaxYawRad = 100.0;

struct Row {
  Service service;
  const char* name;
  const char* type;
  std::vector<std::string_view> arguments;
  const char* request;  ///< examples of both, from which the schemas are made
  const char* response;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> kRows = {
      {Service::kStart,
       "start",
       "Start",
       {"from", "stops", "t_s"},
       R"({"from":"","stops":1,"t_s":1.5})",
       R"({"accepted":true})"},
      {Service::kHold, "hold", "Hold", {}, "{}", R"({"accepted":true})"},
      {Service::kStop, "stop", "Stop", {}, "{}", R"({"acknowledged":true,"acknowledged_ms":1.5})"},
      {Service::kRecordStart,
       "record_start",
       "RecordStart",
       {"name"},
       R"({"name":""})",
       R"({"run":""})"},
      {Service::kRecordStop, "record_stop", "RecordStop", {}, "{}", R"({"run":"","bytes":1})"},
      {Service::kDriveTake,
       "drive_take",
       "DriveTake",
       {"stops", "t_s"},
       R"({"stops":1,"t_s":1.5})",
       R"({"token":""})"},
      {Service::kDrive,
       "drive",
       "Drive",
       {"token", "speed_mps", "yaw_rate_radps", "input_ms"},
       R"({"token":"","speed_mps":0.1,"yaw_rate_radps":0.1,"input_ms":1.5})",
       R"({"accepted":true})"},
      {Service::kDriveRelease,
       "drive_release",
       "DriveRelease",
       {"token"},
       R"({"token":""})",
       R"({"accepted":true})"},
      {Service::kChoose,
       "choose",
       "Choose",
       {"course", "robot", "setup"},
       R"({"course":"","robot":"","setup":""})",
       R"({"course":"","robot":"","setup":""})"},
      {Service::kPlace,
       "place",
       "Place",
       {"at", "x_m", "y_m", "yaw_rad"},
       R"({"at":"","x_m":1.5,"y_m":1.5,"yaw_rad":1.5})",
       R"({"x_m":1.5,"y_m":1.5,"yaw_rad":1.5})"},
      {Service::kFileSave,
       "file_save",
       "FileSave",
       {"kind", "name", "text", "replace"},
       R"({"kind":"","name":"","text":"","replace":true})",
       R"({"name":""})"},
      {Service::kFileDelete,
       "file_delete",
       "FileDelete",
       {"kind", "name"},
       R"({"kind":"","name":""})",
       R"({"name":""})"},
      {Service::kFileCheck,
       "file_check",
       "FileCheck",
       {"kind", "name", "text"},
       R"({"kind":"","name":"","text":""})",
       R"({"error":"","line":1,"column":1,"why_not":"","length_m":1.5,"duration_s":1.5})"},
      {Service::kPause, "pause", "Pause", {}, "{}", R"({"accepted":true})"},
      {Service::kResume,
       "resume",
       "Resume",
       {"stops", "t_s"},
       R"({"stops":1,"t_s":1.5})",
       R"({"accepted":true})"},
      {Service::kParametersSave,
       "parameters_save",
       "ParametersSave",
       {},
       R"({"check":true})",
       kSaved},
      {Service::kParametersRestore,
       "parameters_restore",
       "ParametersRestore",
       {"check"},
       R"({"check":true})",
       kSaved},
      {Service::kRunNote,
       "run_note",
       "RunNote",
       {"run", "name", "note", "tags", "keep"},
       R"({"run":"","name":"","note":"","tags":"","keep":true})",
       R"({"run":"","name":"","note":"","tags":"","keep":true})"},
      {Service::kRunDelete, "run_delete", "RunDelete", {"run"}, R"({"run":""})", R"({"run":""})"},
      {Service::kRunReport,
       "run_report",
       "RunReport",
       {"run"},
       R"({"run":""})",
       R"({"run":"","url":""})"},
      {Service::kRunCompare,
       "run_compare",
       "RunCompare",
       {"run", "with"},
       R"({"run":"","with":""})",
       R"({"run":"","url":""})"},
      {Service::kDoctor,
       "doctor",
       "Doctor",
       {"part"},
       R"({"part":""})",
       R"({"port":"","errors":1,"warnings":1,"notes":1,)"
       R"("findings":[{"severity":"","name":"","seen":"","fix":""}]})"},
      {Service::kRunIdentify,
       "run_identify",
       "RunIdentify",
       {"runs", "measured"},
       R"({"runs":"","measured":""})",
       R"({"found":{"robot":"","parameters":[{"name":"","unit":"","before":1.5,"found":true}],)"
       R"("errors_before":{"runs":[{"name":"","images":1,"rejected":1}]},)"
       R"("errors_after":{"runs":[{"name":"","images":1,"rejected":1}]},)"
       R"("condition":1.5,"warnings":[""]},"text":""})"},
      {Service::kWheelsUpBegin,
       "wheels_up_begin",
       "WheelsUpBegin",
       {"tracks", "stops", "t_s"},
       R"({"tracks":"","stops":1,"t_s":1.5})",
       R"({"token":""})"},
      {Service::kWheelsUpWatch,
       "wheels_up_watch",
       "WheelsUpWatch",
       {"token", "input_ms", "question", "answer"},
       R"({"token":"","input_ms":1.5,"question":1,"answer":""})",
       R"({"step":""})"},
      {Service::kWatch, "watch", "Watch", {}, "{}", R"({"accepted":true})"},
  };
  return kRows;
}

/// The text of an argument; nothing: it is absent or not a text.
std::optional<std::string> text_of(const Arguments& arguments, std::string_view name) {
  for (const RequestField& field : arguments)
    if (const auto* text = std::get_if<std::string>(&field.value); text && field.name == name)
      return *text;
  return std::nullopt;
}

/// Whether every argument is a text, except a truth value of that name.
bool texts_only(const Arguments& arguments, std::string_view truth = {}) {
  return std::all_of(arguments.begin(), arguments.end(), [&](const RequestField& field) {
    return field.name == truth ? std::holds_alternative<bool>(field.value)
                               : std::holds_alternative<std::string>(field.value);
  });
}

}  // namespace

const std::vector<ServiceText>& services() {
  static const std::vector<ServiceText> kServices = [] {
    std::vector<ServiceText> all;
    for (const Row& row : rows()) {
      const std::string type = std::string("tp100.") + row.type;
      all.push_back({static_cast<std::uint32_t>(row.service), row.name, type,
                     messages::schema_of(type + "Request", row.request),
                     messages::schema_of(type + "Response", row.response)});
    }
    return all;
  }();
  return kServices;
}

bool needs_consent(Service service) {
  const auto row = std::ranges::find(rows(), service, &Row::service);
  return row != rows().end() && std::ranges::count(row->arguments, "stops") > 0;
}

std::string unknown_argument(Service service, const Arguments& arguments) {
  // Its arguments are parameters.
  if (service == Service::kParametersSave) return {};
  const auto& known = rows().at(static_cast<std::size_t>(service) - 1).arguments;
  for (const RequestField& field : arguments)
    if (std::ranges::find(known, field.name) == known.end())
      return "there is no argument '" + text::one_line(field.name, kMaxShownArgument) + "'";
  return {};
}

std::string read_start(const Arguments& arguments, bool& here) {
  if (arguments.empty()) return {};
  const std::optional<std::string> from = text_of(arguments, "from");
  here = from == "here";
  return here || from == "start"
             ? ""
             : "from must be \"start\" (of the course) or \"here\" (where the last run ended)";
}

std::string read_record_name(const Arguments& arguments, std::string& name) {
  name = text_of(arguments, "name").value_or("");
  const bool wrong = !texts_only(arguments) || !(name.empty() || text::is_file_name(name));
  return wrong ? text::kFileNameRule : "";
}

std::string read_choice(const Arguments& arguments, SetupChoice& choice) {
  if (!texts_only(arguments)) return "course, robot and setup must be names";
  choice = {text_of(arguments, "course"), text_of(arguments, "robot"), text_of(arguments, "setup")};
  return arguments.empty() ? "give a course, robot or setup" : "";
}

std::string read_place(const Arguments& arguments, std::optional<Pose>& at) {
  if (arguments.size() == 1 && text_of(arguments, "at") == "start") return {};
  at.emplace();
  std::size_t given = 0;
  for (const RequestField& field : arguments) {
    const double* number = std::get_if<double>(&field.value);
    const bool angle = field.name == "yaw_rad";
    if (number == nullptr || !(std::abs(*number) <= (angle ? kMaxYawRad : kMaxPlaceM))) break;
    (angle ? at->yaw_rad : field.name == "x_m" ? at->x_m : at->y_m) = *number;
    ++given;
  }
  if (given == 3 && arguments.size() == 3) return {};
  return "give x_m, y_m and yaw_rad, each from -100 to 100, or {\"at\":\"start\"}";
}

std::string read_file(const Arguments& arguments, SetupFile& file) {
  const std::string kind = text_of(arguments, "kind").value_or("");
  if (!texts_only(arguments, "replace") || (kind != "course" && kind != "robot"))
    return "kind must be \"course\" or \"robot\", name and text strings, replace true or false";
  file.is_robot = kind == "robot";
  file.name = text_of(arguments, "name").value_or("");
  file.text = text_of(arguments, "text").value_or("");
  for (const RequestField& field : arguments)
    if (const bool* replace = std::get_if<bool>(&field.value)) file.replace = *replace;
  if (text::is_found_name(file.name)) return {};
  return text::kFoundNameRule;
}

std::string read_part(const Arguments& arguments, DoctorPart& part) {
  const std::string name = text_of(arguments, "part").value_or("");
  if (name == "port") {
    part = DoctorPart::kPort;
  } else if (name == "robot") {
    part = DoctorPart::kRobot;
  } else if (name == "machine") {
    part = DoctorPart::kMachine;
  } else {
    return "part must be \"port\", \"robot\" or \"machine\"";
  }
  return {};
}

std::string read_wheels_up(const Arguments& arguments) {
  return text_of(arguments, "tracks") == "free"
             ? ""
             : "somebody has to confirm that the tracks turn freely: send tracks = \"free\"";
}

std::string read_watch(const Arguments& arguments, WheelsUpWatch& watch) {
  bool timed = false;
  for (const RequestField& field : arguments) {
    const double* number = std::get_if<double>(&field.value);
    if (field.name == "input_ms" && number != nullptr && std::isfinite(*number)) {
      watch.input_ms = *number;
      timed = true;
    }
    if (field.name == "question" && number != nullptr && *number >= 0.0 && *number < 1e9)
      watch.question = static_cast<unsigned>(*number);
  }
  const auto token = text_of(arguments, "token");
  watch.token = token.value_or("");
  watch.answer = text_of(arguments, "answer");
  return token && timed ? "" : "token must be a string, input_ms a number";
}

std::string read_check(const Arguments& arguments, bool& check) {
  if (arguments.empty()) return {};
  const bool* value = std::get_if<bool>(&arguments.front().value);
  if (value == nullptr) return "check must be true or false";
  check = *value;
  return {};
}

std::string read_parameters(const Arguments& arguments,
                            const std::vector<messages::ParameterText>& known,
                            ParameterSave& asked) {
  for (const RequestField& field : arguments) {
    if (field.name == "check") {
      std::string why = read_check({field}, asked.check);
      if (!why.empty()) return why;
      continue;
    }
    const auto found = std::ranges::find(known, field.name, &messages::ParameterText::name);
    if (found == known.end())
      return "there is no parameter '" + text::one_line(field.name, kMaxShownArgument) + "'";
    if (!found->may_save)
      return field.name + (field.name.starts_with("robot.")
                               ? " is a value of the robot's file; change it there"
                               : " cannot be saved by viewers; set it in the file");
    messages::ParameterValue value;
    if (const auto* number = std::get_if<double>(&field.value)) value = *number;
    if (const auto* flag = std::get_if<bool>(&field.value)) value = *flag;
    if (const auto* words = std::get_if<std::string>(&field.value)) {
      value = *words;
      const bool name = found->type == messages::ParameterText::Type::kText;
      if (name && !words->empty() && !text::is_found_name(*words))
        return field.name + ": " + text::kFoundNameRule;
    }
    if (std::holds_alternative<RequestField::Other>(field.value))
      return field.name + " takes no value of that type";
    std::string why = messages::why_not(*found, value);
    if (!why.empty()) return why;
    asked.values.emplace_back(field.name, std::move(value));
  }
  return asked.values.empty() ? "give parameters and their values" : "";
}

namespace {

/// Reads the arguments of run_identify.
std::string read_drives(const Arguments& arguments, RunRequest& request) {
  request.what = RunRequest::What::kIdentify;
  request.measured = text_of(arguments, "measured").value_or("");
  std::istringstream words(text_of(arguments, "runs").value_or(""));
  for (std::string name; words >> name;) request.drives.push_back(name);
  const bool named = std::ranges::all_of(request.drives, text::is_found_name);
  if (texts_only(arguments) && named && !request.drives.empty() &&
      request.drives.size() <= kMaxDrives)
    return {};
  return "runs must be one to " + std::to_string(kMaxDrives) +
         " names of runs, separated by spaces, as GET /api/runs lists them; measured a string";
}

}  // namespace

std::string read_run(Service service, const Arguments& arguments, RunRequest& request) {
  if (service == Service::kRunIdentify) return read_drives(arguments, request);
  using What = RunRequest::What;
  if (!texts_only(arguments, "keep"))
    return "run, with, name, note and tags must be strings, keep true or false";
  request.what = service == Service::kRunNote     ? What::kNote
                 : service == Service::kRunDelete ? What::kDelete
                 : service == Service::kRunReport ? What::kReport
                                                  : What::kCompare;
  request.run = text_of(arguments, "run").value_or("");
  request.with = text_of(arguments, "with").value_or("");
  request.note = {.name = text_of(arguments, "name"),
                  .note = text_of(arguments, "note"),
                  .tags = text_of(arguments, "tags")};
  for (const RequestField& field : arguments)
    if (const bool* keep = std::get_if<bool>(&field.value)) request.note.keep = *keep;
  const bool compares = request.what == What::kCompare;
  if (!text::is_found_name(request.run) || (compares && !text::is_found_name(request.with)))
    return compares ? "run and with must be names of runs, as GET /api/runs lists them"
                    : "run must be the name of a run, as GET /api/runs lists it";
  return runs::why_not(runs::changed({}, request.note));
}

std::string stop_answer(const messages::StopFigures& stop) {
  std::string text;
  text::JsonWriter json(text);
  const bool acknowledged = stop.status == messages::StopFigures::Status::kAcknowledged;
  json.begin_object().field("acknowledged", acknowledged);
  if (acknowledged) json.field("acknowledged_ms", stop.acknowledged_ms);
  json.end_object();
  return text;
}

}  // namespace tp100::server
