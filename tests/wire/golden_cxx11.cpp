// Checks the golden frames in the firmware's dialect: C++11 without exceptions and run-time types.
#include <stdio.h>

#include "golden.h"

int main(int, char** arguments) {
  const std::vector<tp100::golden::Line> lines = tp100::golden::read_lines(arguments[1]);
  int wrong = 0;
  for (size_t i = 0; i < lines.size(); ++i) {
    const std::string error = tp100::golden::check(lines[i]);
    if (error.empty()) continue;
    fprintf(stderr, "%s\n", error.c_str());
    ++wrong;
  }
  if (lines.size() != 13) {
    fprintf(stderr, "%u golden frames instead of 13\n", static_cast<unsigned>(lines.size()));
    return 1;
  }
  return wrong == 0 ? 0 : 1;
}
