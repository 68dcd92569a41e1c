// Every service that a viewer may call: who may, in which state, with which arguments; and what
// becomes of requests about files. Motion: doors_test, tests/server.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

#include "../messages/fixtures.h"
#include "../support/eventually.h"
#include "../support/paths.h"
#include "../support/temporary_folder.h"
#include "course/bundled_files.h"
#include "daemon_rig.h"

namespace tp100::live {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using server::ServiceRow;
using ::testing::HasSubstr;

constexpr HostNs kNow = 100 * kNsPerS;

/// A recorded run and a folder for the user's files.
class Folder : public ::testing::Test {
 protected:
  config::RunFiles files() {
    config::RunFiles all;
    test::write_bytes(folder_.file("tp100.toml"),
                      "library = \"" + folder_.file("library") + "\"\n");
    all.configuration = course::read_text_file(folder_.file("tp100.toml"));
    all.course = course::read_bundled(course::Bundled::kCourses, "1-straight");
    all.robot = course::read_bundled(course::Bundled::kRobots, "end-loaded");
    all.setup = bridge::Setup::kStand;
    return all;
  }
  runs::ArchiveSettings archive() {
    fs::create_directories(folder_.path() / "runs/a");
    test::write_bytes(folder_.file("runs/a/run.mcap"), "0123");
    return {.folder = folder_.file("runs"), .program = {}};
  }

  test::TemporaryFolder folder_;
};

/// A daemon, whose robot is as told.
class Services : public Folder, protected DaemonRig {
 protected:
  Services() : DaemonRig(files(), config::parse_run(files()), archive()) { show(RunState::kIdle); }

  HostNs now() const override { return kNow; }
  void show(RunState state, StartRefusal drive_refusal = StartRefusal::kNone) {
    StepRecord record = messages::example_record();
    record.now_ns = kNow;
    record.snapshot.run_state = state;
    record.snapshot.start_refusal = StartRefusal::kNone;
    record.snapshot.drive_refusal = drive_refusal;
    publisher_.take(record);
  }
  /// The answer to a request, which may wait for a disk.
  json answered(const std::string& service, const json& request = json::object()) {
    json answer = call(1, service, request);
    EXPECT_TRUE(test::eventually([&] {
      if (answer.is_null()) answer = late_answer(1);
      return !answer.is_null();
    })) << service;
    return answer;
  }
  /// Why it is refused before anything waits; empty: it is not.
  std::string refused(const std::string& service, const json& request = json::object(),
                      server::Permission permission = server::Permission::kCommand) {
    const json answer = call(1, service, request, permission);
    return answer.is_object() ? answer.value("refused", "") : std::string();
  }
  /// The same, for a request as text, which may be no JSON; with a consent if it needs one.
  std::string refused_text(const std::string& service, const std::string& text) {
    const json request = json::parse(text, nullptr, false);
    if (request.is_object()) return refused(service, request);
    return send(1, service, text).value("refused", "");
  }
};

// Clients call a service by its number, which therefore must not change.
TEST_F(Services, AreNumberedNamedAndExplainedOnThePage) {
  std::string names;
  std::map<std::string, const ServiceRow*> rows;
  for (const ServiceRow& row : handler_.services()) {
    names += std::to_string(static_cast<unsigned>(row.service)) + " " + row.name + ", ";
    rows[row.name] = &row;
  }
  EXPECT_EQ(names,
            "1 start, 2 hold, 3 stop, 4 record_start, 5 record_stop, 6 drive_take, 7 drive, "
            "8 drive_release, 9 choose, 10 place, 11 file_save, 12 file_delete, 13 file_check, "
            "14 pause, 15 resume, 16 parameters_save, 17 parameters_restore, 18 run_note, "
            "19 run_delete, 20 run_report, 21 run_compare, 22 doctor, 23 run_identify, "
            "24 wheels_up_begin, 25 wheels_up_watch, 26 watch, 27 mark, ");
  const std::string page = test::read_bytes(source_path("daemon/messages/CHANNELS.md"));
  const std::size_t begin = page.find("| Name | Request | Response |");
  ASSERT_NE(begin, page.npos);
  std::istringstream table(page.substr(begin, page.find("\n\n", begin) - begin));
  std::string line;
  std::getline(table, line);
  std::getline(table, line);
  const std::regex cells(R"(\| `(\w+)` \| (.*?[^\\]) \| (.*) \|)");
  while (std::getline(table, line)) {
    std::smatch cell;
    ASSERT_TRUE(std::regex_match(line, cell, cells)) << line;
    const auto row = rows.find(cell[1]);
    ASSERT_NE(row, rows.end()) << line;
    const std::string request = cell[2];
    EXPECT_EQ(request.starts_with("consent"), row->second->rules.consents) << line;
    const json example = json::parse(row->second->request.json);
    for (const auto& [name, value] : example.items())
      EXPECT_THAT(request, HasSubstr("\"" + name + "\"")) << line;
    rows.erase(row);
  }
  for (const auto& [name, row] : rows) ADD_FAILURE() << name << " is not on the page";
}

// A page that may only watch would start, drive, change or delete something.
TEST_F(Services, WhoMayNotCommandMayStopAndWatchAndNothingElse) {
  for (const RunState state : {RunState::kIdle, RunState::kRunning}) {
    show(state);
    for (const ServiceRow& row : handler_.services()) {
      const std::string name = row.name;
      const bool open = name == "stop" || name == "watch";
      EXPECT_EQ(refused(name, json::object(), server::Permission::kStopOnly),
                open ? "" : "only stop is taken from this client (server.commands)")
          << name;
    }
  }
}

// A change of course, or tracks that run, under somebody who drives.
TEST_F(Services, WhatNeedsARobotAtRestIsRefusedInARun) {
  const std::map<std::string, json> calls = {{"choose", {{"course", "1-curve"}}},
                                             {"place", {{"at", "start"}}},
                                             {"doctor", {{"part", "machine"}}},
                                             {"wheels_up_begin", {{"tracks", "free"}}}};
  for (const RunState state : {RunState::kArming, RunState::kRunning, RunState::kDriving}) {
    show(state);
    for (const auto& [name, request] : calls)
      EXPECT_EQ(refused(name, request), server::kUnderWay) << name;
  }
  show(RunState::kIdle, StartRefusal::kNoSession);
  EXPECT_EQ(refused("pause"), "no run is under way");
  EXPECT_EQ(refused("resume"), "the run is not paused");
  EXPECT_EQ(refused("wheels_up_begin", calls.at("wheels_up_begin")),
            to_string(StartRefusal::kNoSession));
}

TEST_F(Services, ArgumentsAreChecked) {
  struct Bad {
    const char* service;
    std::string request;
    std::string why;
  };
  const auto named = [](const char* key, const std::string& name, const char* rest = "") {
    return R"({")" + std::string(key) + R"(":")" + name + "\"" + rest + "}";
  };
  std::vector<Bad> all = {
      {"hold", "[]", "must be a JSON object"},
      {"hold", R"({"x":null})", "no argument 'x'"},
      {"start", R"({"x":1})", "no argument 'x'"},
      {"start", R"({"from":"there"})", "from must be \"start\""},
      {"drive", R"({"token":"t","speed_mps":1,"yaw_rate_radps":1})", "input_ms are needed"},
      {"drive", R"({"token":1,"speed_mps":1,"yaw_rate_radps":1,"input_ms":1})", "a string"},
      {"drive", R"({"token":"t","speed_mps":true,"yaw_rate_radps":1,"input_ms":1})", "a number"},
      {"drive", R"({"token":"t","speed_mps":101,"yaw_rate_radps":1,"input_ms":1})", "range"},
      {"drive", R"({"token":"t","speed_mps":1,"yaw_rate_radps":-101,"input_ms":1})", "range"},
      {"drive", R"({"token":"t","speed_mps":1,"yaw_rate_radps":1,"input_ms":1e16})", "range"},
      {"drive", R"({"speed":1})", "no argument 'speed'"},
      {"drive_release", R"({"token":1})", "token must be a string"},
      {"wheels_up_begin", R"({"tracks":"perhaps"})", "tracks = \"free\""},
      {"wheels_up_watch", R"({"token":1,"input_ms":5})", "token must be a string"},
      {"doctor", R"({"part":"wheels"})", "part must be \"port\""},
      {"choose", "{}", "give a course"},
      {"choose", R"({"course":3})", "course must be a string"},
      {"choose", R"({"curse":"3"})", "no argument 'curse'"},
      {"place", "{}", "give x_m"},
      {"place", R"({"at":"start","x_m":1,"y_m":1})", "give x_m"},
      {"place", R"({"x_m":1,"y_m":1,"yaw_rad":"1"})", "yaw_rad must be a number"},
      {"place", R"({"x_m":101,"y_m":1,"yaw_rad":1})", "from -100 to 100"},
      {"place", R"({"x_m":1,"y_m":1,"yaw_rad":-101})", "from -100 to 100"},
      {"place", R"({"x_m":1e999,"y_m":1,"yaw_rad":1})", "JSON"},
      {"file_save", R"({"kind":"word","name":"a","text":""})", "kind must be"},
      {"file_save", R"({"kind":"course","name":"../a","text":""})", "name must be"},
      {"file_save", R"({"kind":"course","name":"a","text":"","replace":1})", "replace must be"},
      {"file_delete", R"({"kind":"course","name":"a","text":""})", "no argument 'text'"},
      {"file_check", R"({"kind":"map","name":"mine"})", "kind must be"},
      {"run_note", R"({"run":"a","name":1})", "name must be a string"},
      {"run_note", R"({"run":"a","keep":"yes"})", "keep must be true or false"},
      {"run_note", R"({"run":"a","name":"a\u0000b"})", "name takes"},
      {"run_note", R"({"run":"a","tags":"a\nb"})", "tags takes"},
      {"mark", R"({"text":""})", "1 to 80 bytes"},
      {"mark", R"({"text":"a\u000ab"})", "1 to 80 bytes"},
      {"mark", R"({"run":"a"})", "and t_s"},
      {"mark", R"({"run":"../a","t_s":1})", "and t_s"},
      {"run_delete", R"({"run":"a","with":"b"})", "no argument 'with'"},
      {"run_compare", R"({"run":"a"})", "names of runs"},
      {"run_identify", "{}", "one to 100 names"},
      {"run_identify", R"({"runs":"a","measured":1})", "measured must be a string"},
      {"record_start", R"({"name":1})", "name"},
      {"parameters_save", "{}", "give parameters and their values"},
      {"parameters_save", R"({"check":1,"loop.rate_hz":100})", "check must be true or false"},
      {"parameters_save", R"({"loop.rate":1})", "there is no parameter 'loop.rate'"},
      {"parameters_save", R"({"a\nb":1})", "there is no parameter 'a?b'"},
      {"parameters_save", R"({"server.listen":"0.0.0.0:80"})", "cannot be saved by viewers"},
      {"parameters_save", R"({"robot.model.wheelbase_m":0.3})", "the robot's file"},
      {"parameters_save", R"({"loop.rate_hz":1e6})", "loop.rate_hz ranges from"},
      {"parameters_save", R"({"loop.rate_hz":"12"})", "loop.rate_hz takes a number"},
      {"parameters_save", R"({"loop.rate_hz":null})", "takes no value of that type"},
      {"parameters_restore", R"({"check":null})", "check must be true or false"}};
  std::string many;
  for (int i = 0; i <= 100; ++i) many += "a ";
  for (const std::string& runs : {std::string("a ../b"), many})
    all.push_back({"run_identify", named("runs", runs), "one to 100 names"});
  for (const std::string& run :
       {std::string(), std::string("."), std::string("../a"), std::string("a/b"),
        std::string("a\\u0000b"), std::string("a%2Fb"), std::string(256, 'a')}) {
    for (const char* service : {"run_note", "run_delete", "run_report"})
      all.push_back({service, named("run", run), "run must be the name of a run"});
    all.push_back({"run_compare", named("with", run, R"(,"run":"a")"), "names of runs"});
  }
  for (const char* name : {"../x", "/x", ".x", "a b", "a/b", "\\u0000", "ü"})
    all.push_back({"record_start", named("name", name), "name"});
  for (const char* name : {R"(a\nb)", "../x", "/etc/passwd", R"(a\u0000)"})
    all.push_back({"parameters_save", named("course", name), "name must be 1 to 255 bytes"});
  for (const Bad& bad : all)
    EXPECT_THAT(refused_text(bad.service, bad.request), HasSubstr(bad.why)) << bad.request;
}

TEST_F(Services, FilesAreSavedCheckedAndDeletedAlsoDuringARun) {
  show(RunState::kRunning);
  const std::string robot = course::read_bundled(course::Bundled::kRobots, "worn").text;
  const json draft = {{"kind", "robot"}, {"name", "mine"}, {"text", robot}};
  EXPECT_EQ(answered("file_check", draft).at("error"), "");
  EXPECT_EQ(answered("file_save", draft).at("name"), "mine");
  const std::string saved = folder_.file("library/robots/mine.toml");
  EXPECT_EQ(test::read_bytes(saved), robot);
  EXPECT_THAT(answered("file_save", draft).at("refused"), HasSubstr("exists already"));
  json again = draft;
  again["replace"] = true;
  EXPECT_EQ(answered("file_save", again).at("name"), "mine");
  EXPECT_THAT(answered("file_delete", {{"kind", "robot"}, {"name", "end-loaded"}}).at("refused"),
              HasSubstr("is in use"));
  EXPECT_EQ(answered("file_delete", {{"kind", "robot"}, {"name", "mine"}}).at("name"), "mine");
  EXPECT_FALSE(fs::exists(saved));
}

TEST_F(Services, DuringARunOnlyWhatIsInForceAtOnceIsSaved) {
  show(RunState::kRunning);
  EXPECT_EQ(answered("parameters_save", {{"check", true}, {"loop.rate_hz", 100}}).at("written"),
            false);
  EXPECT_THAT(refused("parameters_save", {{"control.preview_s", 0.08}, {"loop.rate_hz", 100}}),
              HasSubstr("loop.rate_hz takes effect when"));
  EXPECT_EQ(answered("parameters_save", {{"control.preview_s", 0.08}}).at("written"), true);
  EXPECT_THAT(refused("parameters_restore"), HasSubstr("not during a run"));
  EXPECT_EQ(answered("parameters_restore", {{"check", true}}).at("written"), false);
}

TEST_F(Services, WithoutAFolderNothingIsRecorded) {
  EXPECT_THAT(answered("record_start").at("refused"), HasSubstr("nothing can be recorded"));
}

}  // namespace
}  // namespace tp100::live
