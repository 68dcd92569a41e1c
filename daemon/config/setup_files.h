#pragma once
// The course and robot files among which an operator chooses: those that the program was started
// with, the bundled ones, and the user's own in a folder that may be written.

#include <optional>
#include <string>
#include <vector>

#include "config/run_setup.h"
#include "course/bundled_files.h"

namespace tp100::config {

/// The user's folder: `configured` (key library), else $XDG_DATA_HOME/tp100 or
/// ~/.local/share/tp100; empty if there is no home directory.
std::string library_folder(const std::string& configured);

/// "tp100" in the folder that this variable of the XDG base directories names, else in that one of
/// the home directory; empty: there is none.
std::string user_folder(const char* variable, const char* in_home);

/// `name_or_path` as in the configuration: a file, the name of one in the user's folder, or a
/// bundled name; the user's own hides a bundled one of that name. Throws UserError.
course::TextFile read_setup_file(course::Bundled kind, const std::string& name_or_path,
                                 const std::string& library);

/// The configuration and the files that it names, or, unless empty, the course and the robot of
/// these names. Throws UserError.
RunFiles named_files(course::TextFile configuration, const std::string& course_name = {},
                     const std::string& robot_name = {});

/// For each file in a folder of own ones (courses, robots) that is used in the place of a bundled
/// one of its name: "PATH: used, and not the bundled course of that name".
std::vector<std::string> hidden_files(const RunFiles& files);

/// Names are unique within a kind: a file that the program was started with hides the user's of
/// that name, and the user's a bundled one. Functions wait for the disk; any thread.
class SetupFiles {
 public:
  enum class From { kGiven, kBundled, kOwn };
  struct Entry {
    std::string name;
    From from = From::kBundled;
  };

  /// `library`: as library_folder() returns it.
  SetupFiles(std::string library, const RunFiles& given);

  /// Whether there is a folder to save into.
  bool may_save() const { return !library_.empty(); }
  /// Sorted by name; at most 500 of the user's own.
  std::vector<Entry> list(course::Bundled kind) const;
  /// The path in the result is NAME.toml, unless the file was given: viewers get no path of this
  /// machine. Throws UserError.
  course::TextFile read(course::Bundled kind, const std::string& name) const;
  /// Checks the text as `tp100d check` does, and writes the user's file of that name, whole or not
  /// at all; the one that it replaces stays beside it as NAME.toml.bak. Throws UserError: the
  /// text's first error as NAME.toml:line:column, a name that is not permitted or belongs to a file
  /// that is not the user's, or, without `replace`, an existing one.
  void save(course::Bundled kind, const std::string& name, const std::string& text,
            bool replace) const;
  /// Removes one of the user's files. Throws UserError.
  void remove(course::Bundled kind, const std::string& name) const;

 private:
  const course::TextFile& given(course::Bundled kind) const;
  /// Where the file of that name comes from; nothing: there is none.
  std::optional<From> origin(course::Bundled kind, const std::string& name) const;

  std::string library_;
  course::TextFile course_, robot_;  ///< as given
};

constexpr const char* to_string(SetupFiles::From from) {
  return from == SetupFiles::From::kGiven     ? "given"
         : from == SetupFiles::From::kBundled ? "bundled"
                                              : "own";
}

}  // namespace tp100::config
