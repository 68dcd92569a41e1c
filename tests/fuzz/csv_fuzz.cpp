// Fuzzes the tables that users write: recorded drives and measured distances.

#include "byte_source.h"
#include "core/error.h"
#include "identify/drive_file.h"

namespace tp100 {
namespace {

using fuzz::require;

void read_drive(const std::string& text) {
  const std::string written = identify::write_drive(identify::parse_drive(text, "fuzz"));
  require(identify::write_drive(identify::parse_drive(written, "fuzz")) == written,
          "a drive comes back as it was");
}

void read_measured(const std::string& text) {
  std::vector<identify::RecordedDrive> drives(3);
  identify::add_measured(text, "fuzz", drives);
}

}  // namespace
}  // namespace tp100

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 20000) return 0;
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const auto read : {tp100::read_drive, tp100::read_measured}) {
    try {
      read(text);
    } catch (const tp100::UserError& error) {
      tp100::fuzz::require_message(error.what());
    }
  }
  return 0;
}
