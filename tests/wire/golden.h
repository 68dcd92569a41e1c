#pragma once
// The golden frames, one of each message: text lines `name | field=value ... | frame in hex`.

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/paths.h"

namespace tp100::golden {

struct Line {
  std::string name;
  std::map<std::string, std::string> values;  ///< field -> text; array elements by commas
  std::string hex;                            ///< upper case, without spaces
};

inline std::vector<Line> read_lines() {
  std::ifstream file(source_path("tests/wire/golden_frames.txt"));
  std::vector<Line> lines;
  for (std::string text; std::getline(file, text);) {
    if (text.empty() || text.starts_with('#')) continue;
    std::istringstream words(text);
    Line line;
    std::string word;
    words >> line.name >> word;
    while (words >> word && word != "|") {
      const std::size_t equals = word.find('=');
      line.values[word.substr(0, equals)] = word.substr(equals + 1);
    }
    words >> line.hex;
    lines.push_back(line);
  }
  return lines;
}

}  // namespace tp100::golden
