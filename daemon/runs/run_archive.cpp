#include "runs/run_archive.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <deque>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include "core/error.h"
#include "course/bundled_files.h"
#include "record/recording_file.h"
#include "text/atomic_file.h"
#include "text/file_name.h"
#include "text/json_writer.h"
#include "text/temporary.h"

namespace tp100::runs {
namespace {

namespace fs = std::filesystem;

// Of the name of the other run in the name of a comparison.
constexpr std::size_t kMaxCompared = 128;
constexpr auto kFresh = std::chrono::seconds(1);

std::string address(const std::string& run, const std::string& file) {
  return "/runs/" + text::percent_encoded(run) + "/" + text::percent_encoded(file);
}

void write_note(text::JsonWriter& json, const RunNote& note) {
  json.field("name", note.name)
      .field("note", note.note)
      .field("tags", note.tags)
      .field("keep", note.keep)
      .objects("marks", marks_of(note),
               [&](const Mark& mark) { json.field("t_s", mark.t_s).field("text", mark.text); });
}

void write_run(text::JsonWriter& json, const Run& run, bool active) {
  json.field("run", run.folder);
  write_note(json, run.note);
  if (run.result)
    json.object("result", [&] {
      json.field("outcome", run.result->outcome)
          .field("cause", run.result->cause)
          .field("course", run.result->course)
          .field("robot", run.result->robot)
          .field("duration_s", run.result->duration_s)
          .field("distance_m", run.result->distance_m)
          .field("largest_m", run.result->largest_m)
          .field("by_hand", run.result->by_hand);
    });
  json.field("note_error", run.note_error)
      .field("modified_unix_s", run.recorded_unix_s)
      .field("bytes", run.bytes)
      .field("active", active)
      .objects("files", run.files, [&](const RunFile& file) {
        json.field("name", file.name)
            .field("bytes", file.bytes)
            .field("url", address(run.folder, file.name))
            .field("kind", kind_of(file.name).kind);
      });
}

/// A temporary folder within `folder`, which no list shows; removed at the end.
class WorkFolder {
 public:
  /// Throws UserError.
  explicit WorkFolder(const std::string& folder)
      : open_(text::make_temporary_folder(folder, path_)) {
    if (!open_)
      throw UserError(std::string("no folder for the report can be made (") + std::strerror(errno) +
                      "); check permission and free space");
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  const Descriptor open_;  // tells other programs that the folder is in use
};

/// Puts a file in the place of another, or of a link. Throws UserError.
void move_file(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error)
    throw UserError(to.filename().string() + ": cannot be kept beside the run (" + error.message() +
                    ")");
}

std::string report_json(const std::string& run, const std::string& url) {
  return text::json_object(
      [&](text::JsonWriter& json) { json.field("run", run).field("url", url); });
}

std::string without(std::string text, const std::string& part) {
  for (std::size_t at; (at = text.find(part)) != std::string::npos;) text.erase(at, part.size());
  return text;
}

void require_run(const std::vector<Run>& runs, const std::string& name, const std::string& active) {
  const auto found =
      std::find_if(runs.begin(), runs.end(), [&](const Run& each) { return each.folder == name; });
  if (found == runs.end())
    throw UserError(one_line(name) + ": no such run; GET /api/runs lists them");
  if (name == active) throw UserError(name + " is being recorded; end the recording first");
  if (!found->has_recording) throw UserError(name + ": has no recording run.mcap");
}

}  // namespace

std::string RunArchive::json() {
  const std::string active = settings_.active();
  std::uint64_t changes = 0;
  std::string making;
  {
    const std::lock_guard lock(mutex_);
    const bool known = active == active_ && changes_ == listed_;
    if (!json_.empty() && known && std::chrono::steady_clock::now() - read_ < kFresh) return json_;
    changes = changes_;
    making = making_;
  }
  const std::vector<Run> runs = list_runs(settings_.folder);
  std::uint64_t bytes = 0;
  for (const Run& run : runs) bytes += run.bytes;
  const std::string name = fs::path(settings_.folder + "/").parent_path().filename();
  std::string text = text::json_object([&](text::JsonWriter& json) {
    json.field("directory", settings_.folder.empty() ? "" : name)
        .field("bytes", bytes)
        .field("free_bytes", free_bytes(settings_.folder))
        .field("quota_bytes", settings_.quota_bytes)
        .field("making", making)
        .objects(
            "runs", std::span(runs).first(std::min(runs.size(), kMaxListedRuns)),
            [&](const Run& run) { write_run(json, run, !active.empty() && run.folder == active); });
  });
  const std::lock_guard lock(mutex_);
  json_ = text;
  active_ = active;
  listed_ = changes;
  // The time is taken after reading, so that a slow disk is not read continuously.
  read_ = std::chrono::steady_clock::now();
  return text;
}

RunArchive::Answer RunArchive::without_paths(Answer answer) {
  return [this, answer = std::move(answer)](const std::string& why, const std::string& json) {
    {
      const std::lock_guard lock(mutex_);
      ++changes_;
    }
    answer(without(without(why, settings_.folder + "/"), "tp100d: "), json);
  };
}

void RunArchive::change_note(const std::string& run, const RunNoteChange& change,
                             const Answer& answer) {
  disk_.ask(without_paths(answer), [this, run, change] {
    const RunNote note = runs::change_note(settings_.folder, run, change);
    return text::json_object([&](text::JsonWriter& json) {
      json.field("run", run);
      write_note(json, note);
    });
  });
}

void RunArchive::remove(const std::string& run, const Answer& answer) {
  disk_.ask(without_paths(answer), [this, run] {
    if (run == settings_.active()) throw UserError(run + " is being recorded; end that first");
    delete_run(settings_.folder, run);
    return text::json_object([&](text::JsonWriter& json) { json.field("run", run); });
  });
}

void RunArchive::report(const std::string& run, const Answer& answer) {
  in_process(run, answer, [this, run] { return report_json(run, make_report(run, "")); });
}

void RunArchive::compare(const std::string& run, const std::string& with, const Answer& answer) {
  in_process(run, answer, [this, run, with] { return report_json(run, make_report(run, with)); });
}

void RunArchive::identify(const std::vector<std::string>& runs, const std::string& measured,
                          const Answer& answer) {
  in_process(runs.empty() ? "" : runs.front(), answer,
             [this, runs, measured] { return make_robot(runs, measured); });
}

void RunArchive::in_process(const std::string& of, const Answer& answer,
                            std::function<std::string()> job) {
  std::string busy;
  {
    const std::lock_guard lock(mutex_);
    busy = making_;
    if (busy.empty()) {
      making_ = of.empty() ? "?" : of;
      ++changes_;
    }
  }
  if (!busy.empty())
    return answer("a report of " + one_line(busy) + " is being made; try again when it is done",
                  "");
  const auto made = [this, answer = without_paths(answer)](const std::string& why,
                                                           const std::string& json) {
    {
      const std::lock_guard lock(mutex_);
      making_.clear();
    }
    answer(why, json);
  };
  reports_.ask(made, std::move(job));
}

std::string RunArchive::recording(const std::string& run) const {
  return settings_.folder + "/" + run + "/" + record::kRecordingFile;
}

std::string RunArchive::make_report(const std::string& run, const std::string& with) {
  const std::vector<Run> runs = list_runs(settings_.folder);
  const std::string active = settings_.active();
  require_run(runs, run, active);
  if (!with.empty()) require_run(runs, with, active);
  if (with == run) throw UserError("compare needs two different runs");
  // Marks the recordings as in use until the program has opened them.
  const record::UsedFile used(recording(run)), other(recording(with.empty() ? run : with));
  const WorkFolder work(settings_.folder);
  std::vector<std::string> arguments = {settings_.program, with.empty() ? "report" : "compare",
                                        "--background",    "--out",
                                        work.path(),       settings_.folder + "/" + run};
  if (!with.empty()) arguments.push_back(settings_.folder + "/" + with);
  if (const std::string why = process_.run(arguments, settings_.limit); !why.empty())
    throw UserError(why);
  const fs::path beside = fs::path(settings_.folder) / run;
  if (!with.empty()) {
    const std::string name = "compare-" + text::file_name_of(with, kMaxCompared) + ".html";
    move_file(fs::path(work.path()) / "compare.html", beside / name);
    return address(run, name);
  }
  std::error_code error;
  for (fs::directory_iterator at(work.path(), error), end; !error && at != end; at.increment(error))
    move_file(at->path(), beside / at->path().filename());
  return address(run, "report.html");
}

std::string RunArchive::make_robot(const std::vector<std::string>& names,
                                   const std::string& measured) {
  const std::vector<Run> runs = list_runs(settings_.folder);
  const std::string active = settings_.active();
  const WorkFolder work(settings_.folder);
  const std::string found = work.path() + "/found.json", robot = work.path() + "/robot.toml";
  std::vector<std::string> arguments = {settings_.program, "identify", "--background",
                                        "--json",          "--out",    robot};
  if (!measured.empty()) {
    const std::string file = work.path() + "/measured.csv";
    text::write_file(file, measured);
    arguments.insert(arguments.end(), {"--measured", file});
  }
  std::deque<record::UsedFile> used;
  for (const std::string& name : names) {
    require_run(runs, name, active);
    used.emplace_back(recording(name));
    arguments.push_back(settings_.folder + "/" + name);
  }
  if (const std::string why = process_.run(arguments, settings_.limit, found); !why.empty())
    throw UserError(without(why, work.path() + "/"));
  return text::json_object([&](text::JsonWriter& json) {
    json.key("found").raw(course::read_text_file(found).text);
    json.field("text", course::read_text_file(robot).text);
  });
}

}  // namespace tp100::runs
