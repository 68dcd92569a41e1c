#include "sim/campaign/build_id.h"

#include <link.h>

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace tp100::sim {
namespace {

constexpr std::string_view kOwner("GNU\0", 4);

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

std::string hexadecimal(const char* bytes, std::size_t size) {
  std::string text;
  for (std::size_t i = 0; i < size; ++i) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", static_cast<unsigned char>(bytes[i]));
    text += digits;
  }
  return text;
}

/// Of a segment of notes.
std::string build_id(const char* notes, std::size_t size) {
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) head;
    std::memcpy(&head, notes, sizeof head);
    const std::size_t content = sizeof head + padded(head.n_namesz);
    const std::size_t whole = content + padded(head.n_descsz);
    if (whole > size) break;
    if (head.n_type == NT_GNU_BUILD_ID &&
        std::string_view(notes + sizeof head, head.n_namesz) == kOwner)
      return hexadecimal(notes + content, head.n_descsz);
    notes += whole;
    size -= whole;
  }
  return {};
}

int note(dl_phdr_info* object, std::size_t /*size*/, void* context) {
  auto& ids = *static_cast<std::map<std::string, std::string>*>(context);
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): so the loader tells it
    const auto* notes = reinterpret_cast<const char*>(object->dlpi_addr + segment.p_vaddr);
    const std::string id = build_id(notes, segment.p_memsz);
    if (!id.empty()) ids[std::filesystem::path(object->dlpi_name).filename()] = id;
  }
  return 0;
}

}  // namespace

std::map<std::string, std::string> build_ids() {
  std::map<std::string, std::string> ids;
  dl_iterate_phdr(note, &ids);
  return ids;
}

}  // namespace tp100::sim
