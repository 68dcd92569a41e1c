#pragma once
// What people note about a recorded run: a name, a note, tags. Kept as run.toml beside the
// recording. A run with this file is never deleted automatically (run_folder.h).

#include <optional>
#include <string>
#include <vector>

namespace tp100::runs {

inline constexpr const char* kRunNoteFile = "run.toml";
inline constexpr std::size_t kMaxRunName = 80, kMaxTags = 200, kMaxNote = 2000, kMaxMark = 80,
                             kMaxMarks = 8000;  ///< bytes

/// A moment of a run that a person marked.
struct Mark {
  double t_s = 0.0;  ///< as in the messages
  std::string text{};
};

struct RunNote {
  std::string name{};  ///< one line
  std::string note{};  ///< may have several lines
  std::string tags{};  ///< words between spaces
  /// Those that were made afterwards, each in a line: time, blank, text.
  std::string marks{};
  bool keep = false;  ///< not deleted, even without anything else

  bool empty() const {
    return name.empty() && note.empty() && tags.empty() && marks.empty() && !keep;
  }
};

/// A change of a note: absent fields stay as they are.
struct RunNoteChange {
  std::optional<std::string> name{}, note{}, tags{};
  std::optional<bool> keep{};
  std::optional<Mark> mark{};  ///< is added
};
RunNote changed(RunNote note, const RunNoteChange& change);

/// Why these texts are invalid, in one line: too long, not UTF-8, control characters; empty: they
/// are valid.
std::string why_not(const RunNote& note);
std::string why_not(const Mark& mark);

/// Lines that are no marks are left out.
std::vector<Mark> marks_of(const RunNote& note);

/// Throws UserError (file:line:column). `file` is only used in messages.
RunNote parse_run_note(const std::string& text, const std::string& file);
/// A file that parse_run_note() reads back.
std::string write_run_note(const RunNote& note);

}  // namespace tp100::runs
