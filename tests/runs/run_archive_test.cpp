// What a viewer may ask of the recorded runs: lists, notes, deletions, and reports, which another
// program makes; and that program.

#include "runs/run_archive.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "../support/as_nobody.h"
#include "../support/temporary_folder.h"
#include "runs/report_process.h"

namespace tp100::runs {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Json = nlohmann::json;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// The answer to a request.
struct Answered {
  std::string why;
  Json json;
};

class RunArchiveTest : public ::testing::Test {
 protected:
  RunArchiveTest() {
    for (const char* name : {"a", "b"}) write(std::string("runs/") + name + "/run.mcap", "0123");
    settings_ = {.folder = folder_.file("runs"),
                 .quota_bytes = 5'000'000,
                 .program = folder_.file("tp100d"),
                 .active = [this] { return active_; }};
    // Stands in for `tp100d report --background --out FOLDER RUN`, and compare.
    program("echo page > $4/report.html; echo '{}' > $4/metrics.json; echo page > $4/compare.html");
  }
  void write(const std::string& path, const std::string& text) const {
    fs::create_directories(fs::path(folder_.file(path)).parent_path());
    test::write_bytes(folder_.file(path), text);
  }
  void program(const std::string& script) const {
    write("tp100d", "#!/bin/sh\n" + script + "\n");
    ::chmod(folder_.file("tp100d").c_str(), 0700);
  }
  RunArchive& archive() {
    if (!archive_) archive_.emplace(settings_, disk_);
    return *archive_;
  }
  /// Calls `ask` with an answer, and waits for it.
  static Answered asked(const std::function<void(const RunArchive::Answer&)>& ask) {
    const auto promise = std::make_shared<std::promise<Answered>>();
    ask([promise](const std::string& why, const std::string& json) {
      promise->set_value({why, json.empty() ? Json() : Json::parse(json)});
    });
    return promise->get_future().get();
  }
  Answered report(const std::string& run) {
    return asked([&](const auto& answer) { archive().report(run, answer); });
  }
  Answered compare(const std::string& run, const std::string& with) {
    return asked([&](const auto& answer) { archive().compare(run, with, answer); });
  }
  Answered remove(const std::string& run) {
    return asked([&](const auto& answer) { archive().remove(run, answer); });
  }
  bool there(const std::string& path) const { return fs::exists(folder_.file("runs/" + path)); }
  /// Begins a report of run a; returns its answer once its program runs.
  std::future<std::string> begin_report(const std::string& rest_of_program) {
    program("touch " + folder_.file("begun") + "; " + rest_of_program);
    const auto promise = std::make_shared<std::promise<std::string>>();
    archive().report(
        "a", [promise](const std::string& why, const std::string&) { promise->set_value(why); });
    while (!fs::exists(folder_.file("begun"))) std::this_thread::sleep_for(1ms);
    return promise->get_future();
  }
  /// Everything in the folder of the runs.
  std::vector<std::string> in_folder() const {
    std::vector<std::string> names;
    for (const auto& each : fs::directory_iterator(folder_.file("runs")))
      names.push_back(each.path().filename());
    return names;
  }

  test::TemporaryFolder folder_;
  std::string active_;
  ArchiveSettings settings_;
  std::optional<RunArchive> archive_;
  Worker disk_{"disk"};  // its jobs use the archive
};

TEST_F(RunArchiveTest, ListsRunsWithoutAPath) {
  active_ = "b";
  write("runs/a/run.toml", "name = \"Wet\"\ntags = \"x y\"\n");
  const std::string text = archive().json();
  EXPECT_THAT(text, Not(HasSubstr(folder_.path().string())));
  const Json list = Json::parse(text);
  EXPECT_EQ(list["directory"], "runs");
  EXPECT_EQ(list["quota_bytes"], 5'000'000);
  EXPECT_GT(list["bytes"], 8);
  for (const Json& run : list["runs"]) {
    EXPECT_EQ(run["active"], run["run"] == "b");
    EXPECT_EQ(run["name"], run["run"] == "a" ? "Wet" : "");
    EXPECT_EQ(run["files"][0]["url"], "/runs/" + std::string(run["run"]) + "/run.mcap");
    EXPECT_EQ(run["files"][0]["kind"], "recording");
  }
  EXPECT_EQ(list["runs"].size(), 2U);
}

// A folder that this account may list but not search, as on a stick that another account wrote,
// would end the daemon in the middle of a run.
TEST_F(RunArchiveTest, AFolderThatCannotBeSearchedIsAnError) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become another account; run it as root";
  fs::permissions(folder_.path(), fs::perms::all);
  for (const char* denied : {"runs/a", "runs"}) {
    const fs::perms before = fs::status(folder_.file(denied)).permissions();
    fs::permissions(folder_.file(denied), fs::perms::owner_all | fs::perms::others_read);
    archive_.reset();
    {
      const test::AsNobody nobody;
      const auto note = [&](const auto& answer) {
        archive().change_note("a", {.name = "x"}, answer);
      };
      EXPECT_THAT(asked(note).why, AnyOf(HasSubstr("ermission"), HasSubstr("no such run")))
          << denied;
      EXPECT_NE(remove("a").why, "");
      EXPECT_NE(report("a").why, "");
      EXPECT_NE(compare("a", "b").why, "");
      EXPECT_NO_THROW(Json::parse(archive().json()));
    }
    fs::permissions(folder_.file(denied), before);
    EXPECT_FALSE(there("a/run.toml"));
    EXPECT_TRUE(there("a/run.mcap"));
  }
}

TEST_F(RunArchiveTest, TheListIsReadFromTheDiskOnceASecondAndAfterAChange) {
  const auto count = [&] { return Json::parse(archive().json())["runs"].size(); };
  // If the machine pauses for a second in between, nothing can be compared, so the check is
  // repeated.
  for (bool seen = false; !seen;) {
    const auto began = std::chrono::steady_clock::now();
    const std::size_t before = count();
    write("runs/" + std::to_string(before) + "/run.mcap", "");
    const std::size_t after = count();
    seen = std::chrono::steady_clock::now() - began < 1s;
    if (seen) {
      EXPECT_EQ(after, before);
    }
    while (count() == before) std::this_thread::sleep_for(10ms);
  }
  const std::size_t before = count();
  EXPECT_EQ(remove("a").why, "");
  EXPECT_EQ(count(), before - 1);
  active_ = "b";
  write("runs/more/run.mcap", "");
  EXPECT_EQ(count(), before);
}

TEST_F(RunArchiveTest, AReportIsKeptBesideItsRunAndAComparisonIsNamedAfterTheOtherRun) {
  EXPECT_EQ(compare("a", "b").json["url"], "/runs/a/compare-b.html");
  EXPECT_TRUE(there("a/compare-b.html"));
  EXPECT_FALSE(there("a/report.html"));
  EXPECT_THAT(compare("a", "a").why, HasSubstr("two different"));
  EXPECT_THAT(compare("a", "../a").why, HasSubstr("no such run"));
  // A link is replaced and not followed.
  write("secret", "secret");
  fs::create_symlink(folder_.file("secret"), folder_.file("runs/a/report.html"));
  const Answered answer = report("a");
  EXPECT_EQ(answer.why, "");
  EXPECT_EQ(answer.json["url"], "/runs/a/report.html");
  EXPECT_TRUE(there("a/report.html") && there("a/metrics.json"));
  EXPECT_EQ(test::read_bytes(folder_.file("secret")), "secret");
  EXPECT_FALSE(fs::is_symlink(folder_.file("runs/a/report.html")));
  EXPECT_THAT(in_folder(), ::testing::UnorderedElementsAre("a", "b"));
}

TEST_F(RunArchiveTest, AFailureIsSaidWithoutAPathAndAnotherReportMayFollow) {
  program("echo \"tp100d: $5/run.mcap: not a recording (no MCAP file)\" >&2; exit 2");
  EXPECT_EQ(report("a").why, "a/run.mcap: not a recording (no MCAP file)");
  EXPECT_FALSE(there("a/report.html"));
  for (const char* name : {"..", "", "none", "/etc"})
    EXPECT_THAT(report(name).why, HasSubstr("no such run")) << name;
  active_ = "a";
  EXPECT_THAT(report("a").why, HasSubstr("is being recorded"));
  EXPECT_THAT(remove("a").why, HasSubstr("is being recorded"));
  EXPECT_TRUE(there("a/run.mcap"));
}

TEST_F(RunArchiveTest, OneReportIsMadeAtATimeAndItsRunIsNotDeletedMeanwhile) {
  auto first = begin_report("while [ ! -e " + folder_.file("go") + " ]; do sleep 0.01; done");
  EXPECT_THAT(report("b").why, HasSubstr("a report of a is being made"));
  EXPECT_EQ(Json::parse(archive().json())["making"], "a");
  EXPECT_THAT(remove("a").why, HasSubstr("is open"));
  write("go", "");
  EXPECT_EQ(first.get(), "");
  EXPECT_EQ(Json::parse(archive().json())["making"], "");
  EXPECT_EQ(report("b").why, "");
}

TEST_F(RunArchiveTest, AReportEndsWithTheDaemon) {
  auto first = begin_report("exec sleep 600");
  archive_.reset();
  EXPECT_EQ(first.get(), "the daemon is shutting down");
}

TEST_F(RunArchiveTest, ARobotIsIdentifiedFromRunsAndNothingStaysInTheirFolder) {
  // Stands in for `tp100d identify --background --json --out FILE [--measured FILE] RUN...`.
  program("echo \"{\\\"arguments\\\":\\\"$*\\\"}\"; cat \"$7\" > $5");
  const auto identify = [&](const std::vector<std::string>& runs, const std::string& measured) {
    return asked([&](const auto& answer) { archive().identify(runs, measured, answer); });
  };
  const Answered answer = identify({"a", "b"}, "run,distance_m\n1,2\n");
  EXPECT_EQ(answer.why, "");
  EXPECT_EQ(answer.json["text"], "run,distance_m\n1,2\n") << "the robot file is what it wrote";
  const std::string arguments = answer.json["found"]["arguments"];
  EXPECT_THAT(arguments, HasSubstr("identify --background --json --out"));
  EXPECT_TRUE(arguments.ends_with(folder_.file("runs/a") + " " + folder_.file("runs/b")));
  EXPECT_THAT(in_folder(), ::testing::UnorderedElementsAre("a", "b"));

  EXPECT_THAT(identify({"a", "none"}, "").why, HasSubstr("none: no such run"));
  program("echo \"tp100d: $6/run.mcap: no drive\" >&2; exit 2");
  EXPECT_EQ(identify({"a"}, "").why, "a/run.mcap: no drive");
  program("echo \"tp100d: $7:2: no number\" >&2; exit 2");
  EXPECT_EQ(identify({"a"}, "x").why, "measured.csv:2: no number");
  active_ = "b";
  EXPECT_THAT(identify({"a", "b"}, "").why, HasSubstr("b is being recorded"));
}

TEST_F(RunArchiveTest, ANoteIsAnsweredAsItIsThen) {
  const auto noted = [&](const RunNoteChange& change) {
    return asked([&](const auto& reply) { archive().change_note("a", change, reply); });
  };
  EXPECT_EQ(noted({.name = "Wet", .keep = true}).json,
            Json::parse(R"({"run":"a","name":"Wet","note":"","tags":"","keep":true,"marks":[]})"));
  EXPECT_THAT(noted({.name = "a\nb"}).why, HasSubstr("name takes"));
}

std::string run(ReportProcess& process, const std::string& script,
                std::chrono::milliseconds limit = 60s) {
  return process.run({"/bin/sh", "-c", script}, limit);
}

TEST(ReportProcess, SaysWhyAProgramFailedOrWasKilled) {
  ReportProcess process;
  EXPECT_EQ(run(process, "echo out; echo note >&2"), "") << "of one that is done nothing is said";
  EXPECT_EQ(run(process, "echo first >&2; echo 'the reason' >&2; exit 2"), "the reason");
  EXPECT_THAT(run(process, "exit 2"), HasSubstr("status 2"));
  EXPECT_THAT(run(process, "kill -SEGV $$"), HasSubstr("killed"));
  EXPECT_THAT(process.run({"/none/tp100d"}, 60s), HasSubstr("/none/tp100d: cannot be started"));
  EXPECT_THAT(run(process, "exec sleep 600", 50ms), HasSubstr("not done after"));
  const std::string long_text = run(process, "head -c 100000 /dev/zero | tr '\\0' x >&2; exit 1");
  EXPECT_LT(long_text.size(), 1000U);
}

TEST(ReportProcess, RunsAtTheLowestPriorityWithoutOurFiles) {
  ReportProcess process;
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out");
  const int ours = ::open(folder.file("ours").c_str(), O_CREAT | O_RDWR, 0600);
  // The priority is set when the program has begun.
  EXPECT_EQ(run(process,
                "until chrt -p $$ | grep -q SCHED_IDLE; do sleep 0.01; done; ls -l "
                "/proc/$$/fd > " +
                    out),
            "");
  ::close(ours);
  EXPECT_THAT(test::read_bytes(out), ::testing::Not(HasSubstr("ours")));
}

}  // namespace
}  // namespace tp100::runs
