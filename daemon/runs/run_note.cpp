#include "runs/run_note.h"

#include <array>
#include <span>
#include <sstream>

#include "text/format.h"
#include "text/json_writer.h"
#include "text/key.h"

namespace tp100::runs {
namespace {

std::span<const text::Key<RunNote>> keys() {
  using T = RunNote;
  static const std::array<text::Key<T>, 5> kKeys = {{
      {"name", &T::name, {}, "Name of the run"},
      {"tags", &T::tags, {}, "Tags for searching, separated by spaces"},
      {"note", &T::note, {}, "Notes about the run"},
      {"marks", &T::marks, {}, "Moments marked afterwards, each in a line: time in s, text"},
      {"keep", &T::keep, {}, "Never delete the run to stay within record.quota_mb"},
  }};
  return kKeys;
}

/// Valid UTF-8 without control characters, and without line breaks unless `lines`.
bool is_text(std::string_view text, bool lines) {
  while (!text.empty()) {
    const std::size_t length = text::utf8_length(text);
    const auto first = static_cast<unsigned char>(text.front());
    const bool control = first < 0x20 || first == 0x7f;
    if (length == 0 || (control && !(lines && (first == '\n' || first == '\t')))) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace

RunNote changed(RunNote note, const RunNoteChange& change) {
  note.name = change.name.value_or(note.name);
  note.note = change.note.value_or(note.note);
  note.tags = change.tags.value_or(note.tags);
  note.keep = change.keep.value_or(note.keep);
  if (change.mark) note.marks += text::format("%.3f ", change.mark->t_s) + change.mark->text + "\n";
  return note;
}

std::string why_not(const RunNote& note) {
  const auto wrong = [](const char* what, std::string_view text, std::size_t most, bool lines) {
    if (text.size() <= most && is_text(text, lines)) return std::string();
    return std::string(what) + " takes text without control characters, at most " +
           std::to_string(most) + " bytes";
  };
  std::string why = wrong("name", note.name, kMaxRunName, false);
  if (why.empty()) why = wrong("tags", note.tags, kMaxTags, false);
  if (why.empty()) why = wrong("note", note.note, kMaxNote, true);
  if (why.empty()) why = wrong("marks", note.marks, kMaxMarks, true);
  return why;
}

std::string why_not(const Mark& mark) {
  if (!mark.text.empty() && mark.text.size() <= kMaxMark && is_text(mark.text, false)) return {};
  return "the text of a mark has 1 to " + std::to_string(kMaxMark) +
         " bytes without control characters";
}

std::vector<Mark> marks_of(const RunNote& note) {
  std::vector<Mark> marks;
  std::istringstream lines(note.marks);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Mark mark;
    if (words >> mark.t_s && words.get() == ' ' && std::getline(words, mark.text))
      marks.push_back(mark);
  }
  return marks;
}

RunNote parse_run_note(const std::string& text, const std::string& file) {
  const text::TomlDocument document(text, file);
  text::TomlTable root = document.root();
  RunNote note;
  text::read_keys(root, keys(), note);
  root.finish();
  if (const std::string why = why_not(note); !why.empty()) root.fail("", why);
  return note;
}

std::string write_run_note(const RunNote& note) {
  return text::toml_comment("Notes about this run; the page of tp100d shows and edits them.") +
         "\n" + text::write_keys(keys(), note);
}

}  // namespace tp100::runs
