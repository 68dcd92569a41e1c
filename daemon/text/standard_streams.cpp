#include "text/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

#include "core/error.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::text {
int report_error(const char* program, std::string_view message, int status) {
  std::fprintf(stderr, "%s: %.*s\n", program, static_cast<int>(message.size()), message.data());
  return status;
}

namespace {

std::string unknown(const char* kind, const std::string& word,
                    const std::vector<std::string_view>& known) {
  return std::string("unknown ") + kind + " '" + one_line(word) + "'" + suggestion(word, known);
}

/// The first argument that looks like an option but is not one of `command`; empty: there is none.
std::string unknown_option(int argc, char** argv, const Subcommand& command) {
  for (int i = 2; i < argc; ++i) {
    const std::string word = std::string(argv[i]).substr(0, std::string_view(argv[i]).find('='));
    if (word == "--") return {};
    if (!word.starts_with("--") || std::ranges::count(command.options, word) > 0) continue;
    return unknown("option", word, {command.options.begin(), command.options.end()});
  }
  return {};
}

/// As a person writes it: CLI11 prints 0.100000.
std::string plain_number(std::string_view text) {
  const std::string copy(text);
  return text.find('.') == std::string_view::npos ? copy
                                                  : number_text(std::strtod(copy.c_str(), nullptr));
}

/// Rewords CLI11's message about a value outside its range: "--timeout: Value abc not in range 1 to
/// 2". Empty if the text has another form.
std::string wrong_value(std::string_view what) {
  constexpr std::string_view kValue = ": Value ", kRange = " not in range ", kTo = " to ";
  const std::size_t value = what.find(kValue), range = what.rfind(kRange), to = what.rfind(kTo);
  if (value == what.npos || range == what.npos || to == what.npos || range < value || to < range)
    return {};
  const std::size_t begin = value + kValue.size(), low = range + kRange.size();
  const std::string given(what.substr(begin, range - begin));
  char* end = nullptr;
  std::strtod(given.c_str(), &end);
  const bool number = !given.empty() && *end == '\0';
  return std::string(what.substr(0, value)) + " " + given + ": " +
         (number ? "out of range" : "not a number") + "; give " +
         plain_number(what.substr(low, to - low)) + " to " +
         plain_number(what.substr(to + kTo.size()));
}

/// CLI11's message about `argv`, in the words of our other messages.
std::string reworded(std::string_view what, int argc, char** argv) {
  constexpr std::string_view kNoNumber = "Could not convert: ";
  constexpr std::string_view kUnexpected = "The following argument was not expected: ";
  if (std::string better = wrong_value(what); !better.empty()) return better;
  if (what.starts_with(kNoNumber)) {
    const std::string_view rest = what.substr(kNoNumber.size());
    const std::size_t at = rest.find(" = ");
    if (at != std::string_view::npos)
      return std::string(rest.substr(0, at)) + " " + std::string(rest.substr(at + 3)) +
             ": not a number";
  }
  if (!what.starts_with(kUnexpected)) return std::string(what);
  const std::string word(what.substr(kUnexpected.size()));
  for (int i = 2; i < argc; ++i) {
    const std::string before = argv[i - 1];
    if (argv[i] == word && before.starts_with("--"))
      return word + ": unexpected argument; did you mean '" + before + "=" + word + "'?";
  }
  return word + ": unexpected argument";
}

}  // namespace

int report_usage_error(const char* program, std::string_view what, int argc, char** argv,
                       const std::vector<Subcommand>& known) {
  std::string help = program, better;
  const std::string first = argc < 2 ? "" : argv[1];
  const auto command = std::ranges::find(known, first, &Subcommand::name);
  if (command != known.end()) {
    help += " " + first;
    better = unknown_option(argc, argv, *command);
  } else if (!first.empty() && first[0] != '-') {
    std::vector<std::string_view> names;
    names.reserve(known.size());
    for (const Subcommand& each : known) names.emplace_back(each.name);
    better = unknown("subcommand", first, names);
  }
  return report_error(program, one_line(better.empty() ? reworded(what, argc, argv) : better, 500) +
                                   "; see " + help + " --help");
}

int run_program(const char* program, const std::function<int()>& run) {
  claim_standard_streams();
  try {
    return finish_standard_output(program, run());
  } catch (const UserError& error) {
    return report_error(program, error.what());
  } catch (const std::exception& error) {
    return report_error(program,
                        std::string("stopped: ") + error.what() +
                            "; start it again, and report it if it comes back",
                        3);
  }
}

void claim_standard_streams() {
  // The system assigns the lowest free number first.
  int fd = 0;
  while (fd >= 0 && fd <= STDERR_FILENO) fd = ::open("/dev/null", O_RDWR);
  if (fd > STDERR_FILENO) ::close(fd);
}

int finish_standard_output(const char* program, int status) {
  errno = 0;
  const bool failed_before = std::ferror(stdout) != 0;
  if (std::fflush(stdout) == 0 && !failed_before) return status;
  const char* reason = errno == 0 ? "an earlier line failed" : std::strerror(errno);
  std::fprintf(stderr, "%s: standard output: cannot be written (%s); check where it goes\n",
               program, reason);
  return status == 0 ? 2 : status;
}

std::string environment_variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : value;
}

}  // namespace tp100::text
