#include "core/error.h"

namespace tp100 {

std::string one_line(std::string_view text, std::size_t most) {
  std::string line(text.substr(0, most));
  for (char& c : line)
    if (c < 0x20 || c > 0x7e) c = '?';
  return text.size() > most ? line + "..." : line;
}

}  // namespace tp100
