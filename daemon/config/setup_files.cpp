#include "config/setup_files.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/error.h"
#include "course/course.h"
#include "course/robot_file.h"
#include "text/atomic_file.h"
#include "text/file_name.h"
#include "text/format.h"
#include "text/standard_streams.h"

namespace tp100::config {
namespace {

namespace fs = std::filesystem;
using course::Bundled;

constexpr std::size_t kMaxName = 64;
constexpr std::size_t kMaxOwn = 500;
constexpr const char* kEnding = ".toml";

const char* noun(Bundled kind) { return kind == Bundled::kCourses ? "course" : "robot"; }

bool bundled(Bundled kind, const std::string& name) {
  const std::vector<std::string> names = course::bundled_names(kind);
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Links are not followed: only files in the user's folder may be read.
bool is_plain_file(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type() == fs::file_type::regular;
}

const char* folder_name(Bundled kind) { return kind == Bundled::kCourses ? "courses" : "robots"; }

std::string own_folder(const std::string& library, Bundled kind) {
  return library + "/" + folder_name(kind);
}

std::string own_path(const std::string& library, Bundled kind, const std::string& name) {
  return own_folder(library, kind) + "/" + name + kEnding;
}

}  // namespace

std::string library_folder(const std::string& configured) {
  if (!configured.empty()) return configured;
  return user_folder("XDG_DATA_HOME", "/.local/share");
}

std::string user_folder(const char* variable, const char* in_home) {
  if (const std::string folder = text::environment_variable(variable); !folder.empty())
    return folder + "/tp100";
  const std::string home = text::environment_variable("HOME");
  return home.empty() ? home : home + in_home + "/tp100";
}

RunFiles named_files(course::TextFile configuration, const std::string& course_name,
                     const std::string& robot_name) {
  const Configuration read = parse_configuration(configuration.text, configuration.path);
  const std::string library = library_folder(read.library);
  RunFiles files{.configuration = std::move(configuration),
                 .setup = read.parameters.setup,
                 .world = read.parameters.world.kind};
  const std::string& course = course_name.empty() ? read.course : course_name;
  if (!course.empty()) files.course = read_setup_file(Bundled::kCourses, course, library);
  files.robot =
      read_setup_file(Bundled::kRobots, robot_name.empty() ? read.robot : robot_name, library);
  return files;
}

course::TextFile read_setup_file(Bundled kind, const std::string& name_or_path,
                                 const std::string& library) {
  std::error_code error;
  const bool path = name_or_path.find('/') != std::string::npos;
  if (path || library.empty() || fs::exists(name_or_path, error))
    return course::read_bundled(kind, name_or_path);
  const bool ending = name_or_path.ends_with(kEnding);
  const std::string own = own_folder(library, kind) + "/" + name_or_path + (ending ? "" : kEnding);
  if (is_plain_file(own)) return course::read_text_file(own);
  if (fs::exists(fs::symlink_status(own, error)))
    throw UserError(own + ": a link or folder, which is not followed; copy the file there");
  try {
    return course::read_bundled(kind, name_or_path);
  } catch (const UserError& none) {
    throw UserError(std::string(none.what()) + "; your own are files NAME.toml in " +
                    own_folder(library, kind));
  }
}

std::vector<std::string> hidden_files(const RunFiles& files) {
  std::vector<std::string> notes;
  for (const auto& [kind, file] :
       {std::pair(Bundled::kCourses, &files.course), {Bundled::kRobots, &files.robot}})
    if (fs::path(file->path).parent_path().filename() == folder_name(kind) &&
        !file->path.starts_with(course::config_directory()) &&
        bundled(kind, course::file_stem(file->path)))
      notes.push_back(file->path + ": used, and not the bundled " + noun(kind) + " of that name");
  return notes;
}

SetupFiles::SetupFiles(std::string library, const RunFiles& given)
    : library_(std::move(library)), course_(given.course), robot_(given.robot) {}

const course::TextFile& SetupFiles::given(Bundled kind) const {
  return kind == Bundled::kCourses ? course_ : robot_;
}

std::vector<SetupFiles::Entry> SetupFiles::list(Bundled kind) const {
  std::vector<Entry> entries;
  const auto add = [&](const std::string& name, From from) {
    const bool known = std::any_of(entries.begin(), entries.end(),
                                   [&](const Entry& each) { return each.name == name; });
    if (!known) entries.push_back({name, from});
  };
  const std::string name = course::file_stem(given(kind).path);
  if (!name.empty() && origin(kind, name) == From::kGiven) add(name, From::kGiven);
  std::error_code error;
  std::size_t own = 0;
  if (!library_.empty()) {
    for (fs::directory_iterator file(own_folder(library_, kind), error), end;
         !error && file != end && own < kMaxOwn; file.increment(error)) {
      const std::string stem = file->path().stem().string();
      if (file->path().extension() != kEnding || !text::is_found_name(stem) ||
          !is_plain_file(file->path()))
        continue;
      add(stem, From::kOwn);
      ++own;
    }
  }
  for (const std::string& each : course::bundled_names(kind)) add(each, From::kBundled);
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.name < b.name; });
  return entries;
}

std::optional<SetupFiles::From> SetupFiles::origin(Bundled kind, const std::string& name) const {
  const std::string own = library_.empty() ? library_ : own_path(library_, kind, name);
  const std::string& at = given(kind).path;
  const bool is_bundled = bundled(kind, name);
  // A file that was given by its name, not by its path, is one of the others.
  const bool by_name = at == own || (is_bundled && at.starts_with(course::config_directory()));
  if (!at.empty() && !by_name && course::file_stem(at) == name) return From::kGiven;
  if (text::is_found_name(name) && is_plain_file(own)) return From::kOwn;
  return is_bundled ? std::optional(From::kBundled) : std::nullopt;
}

course::TextFile SetupFiles::read(Bundled kind, const std::string& name) const {
  const std::optional<From> from = origin(kind, name);
  if (from == From::kGiven) return given(kind);
  if (from) {
    course::TextFile file = *from == From::kBundled
                                ? course::read_bundled(kind, name + kEnding)
                                : course::read_text_file(own_path(library_, kind, name));
    file.path = name + kEnding;
    return file;
  }
  const std::vector<Entry> entries = list(kind);
  std::vector<std::string_view> names;
  names.reserve(entries.size());
  for (const Entry& entry : entries) names.push_back(entry.name);
  throw UserError(one_line(name, kMaxName) + ": no such " + noun(kind) +
                  text::suggestion(name, names) + "; GET /api/setup lists them");
}

void SetupFiles::save(Bundled kind, const std::string& name, const std::string& content,
                      bool replace) const {
  const std::optional<From> from = origin(kind, name);
  if (from && *from != From::kOwn)
    throw UserError(name + " is not one of your own files; give it another name");
  if (!from && !text::is_file_name(name)) throw UserError(text::kFileNameRule);
  if (from && !replace) throw UserError(name + " exists already; replace it, or give another name");
  if (library_.empty())
    throw UserError("there is no folder for your own files: set library in the configuration");
  const std::string path = own_path(library_, kind, name);
  std::error_code error;
  const fs::file_type there =
      from ? fs::file_type::not_found : fs::symlink_status(path, error).type();
  // Only a file that is certainly not there is made anew.
  if (there == fs::file_type::none)
    throw UserError(name + kEnding + ": " + error.message() +
                    "; check folder, permission and disk");
  if (there != fs::file_type::not_found)
    throw UserError(name + kEnding +
                    ": a link or folder, no plain file; delete it by hand, or give another name");
  if (kind == Bundled::kCourses) {
    course::parse_course(content, name + kEnding);
  } else {
    course::parse_robot(content, name + kEnding);
  }
  text::make_folder(own_folder(library_, kind));
  text::edit_file(path, content);
}

void SetupFiles::remove(Bundled kind, const std::string& name) const {
  const std::optional<From> from = origin(kind, name);
  if (!from) throw UserError(one_line(name, kMaxName) + ": no such " + noun(kind));
  if (*from != From::kOwn)
    throw UserError(name + " is not one of your own files and cannot be deleted");
  std::error_code error;
  if (!fs::remove(own_path(library_, kind, name), error) || error)
    throw UserError(name + ": cannot be deleted (" + error.message() + ")");
}

}  // namespace tp100::config
