#include "sim/board/avr_image.h"

#include <elf.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <system_error>

#include "core/error.h"

namespace tp100::sim {
namespace {

namespace fs = std::filesystem;

using Bytes = std::vector<std::uint8_t>;

// The linker's addresses of data lie beyond the flash; segments with a load address there are not
// programmed.
constexpr std::uint32_t kDataBase = 0x800000;

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw UserError(path + ": " + what + "; give the tp100.elf or tp100.hex of a build");
}

Bytes read_file(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) refuse(path, "is a directory");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(path, "cannot be opened");
  return Bytes(std::istreambuf_iterator<char>(file), {});
}

void program(AvrImage& image, std::uint64_t address, std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return;
  if (address + bytes.size() > AvrImage::kFlashSize) refuse(image.path, "larger than the flash");
  const auto first = static_cast<std::uint32_t>(address);
  if (image.flash.empty()) image.begin = first;
  if (first < image.begin) {
    image.flash.insert(image.flash.begin(), image.begin - first, 0xFF);
    image.begin = first;
  }
  const std::size_t offset = first - image.begin;
  if (image.flash.size() < offset + bytes.size()) image.flash.resize(offset + bytes.size(), 0xFF);
  std::copy(bytes.begin(), bytes.end(), image.flash.begin() + static_cast<std::ptrdiff_t>(offset));
}

template <class T>
std::optional<T> take(const Bytes& file, std::uint64_t offset) {
  if (offset + sizeof(T) > file.size()) return std::nullopt;
  T value;
  std::memcpy(&value, file.data() + offset, sizeof value);
  return value;
}

void read_symbols(AvrImage& image, const Bytes& file, const Elf32_Ehdr& header) {
  for (std::uint32_t i = 0; i < header.e_shnum; ++i) {
    const auto section =
        take<Elf32_Shdr>(file, header.e_shoff + std::uint64_t{i} * sizeof(Elf32_Shdr));
    if (!section || section->sh_type != SHT_SYMTAB) continue;
    const auto names = take<Elf32_Shdr>(
        file, header.e_shoff + std::uint64_t{section->sh_link} * sizeof(Elf32_Shdr));
    if (!names) continue;
    for (std::uint64_t at = 0; at + sizeof(Elf32_Sym) <= section->sh_size;
         at += sizeof(Elf32_Sym)) {
      const auto symbol = take<Elf32_Sym>(file, section->sh_offset + at);
      if (!symbol) return;
      std::string name;
      for (std::uint64_t c = names->sh_offset + std::uint64_t{symbol->st_name};
           c < file.size() && file[c] != 0; ++c) {
        name.push_back(static_cast<char>(file[c]));
      }
      if (!name.empty()) image.symbols.emplace(std::move(name), symbol->st_value);
    }
  }
}

void read_elf(AvrImage& image, const Bytes& file) {
  const auto header = take<Elf32_Ehdr>(file, 0);
  if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0 ||
      header->e_ident[EI_CLASS] != ELFCLASS32 || header->e_machine != EM_AVR) {
    refuse(image.path, "not an ELF file for an AVR");
  }
  for (std::uint32_t i = 0; i < header->e_phnum; ++i) {
    const auto part =
        take<Elf32_Phdr>(file, header->e_phoff + std::uint64_t{i} * sizeof(Elf32_Phdr));
    if (!part) refuse(image.path, "cut off");
    if (part->p_type != PT_LOAD || part->p_paddr >= kDataBase || part->p_filesz == 0) continue;
    if (std::uint64_t{part->p_offset} + part->p_filesz > file.size()) refuse(image.path, "cut off");
    program(image, part->p_paddr, std::span(file).subspan(part->p_offset, part->p_filesz));
  }
  read_symbols(image, file, *header);
}

int hex_digit(std::uint8_t c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

// One record: length, address (2), type, data, checksum. Empty if the line is not a record.
Bytes hex_record(std::span<const std::uint8_t> line) {
  Bytes record;
  if (line.empty() || line.front() != ':' || line.size() % 2 == 0) return {};
  for (std::size_t i = 1; i < line.size(); i += 2) {
    const int high = hex_digit(line[i]);
    const int low = hex_digit(line[i + 1]);
    if (high < 0 || low < 0) return {};
    record.push_back(static_cast<std::uint8_t>(high * 16 + low));
  }
  std::uint8_t sum = 0;
  for (const std::uint8_t byte : record) sum = static_cast<std::uint8_t>(sum + byte);
  return record.size() >= 5 && record.size() == record[0] + 5U && sum == 0 ? record : Bytes{};
}

void read_hex(AvrImage& image, const Bytes& file) {
  std::uint64_t base = 0;
  auto at = file.begin();
  while (at != file.end()) {
    const auto end = std::find_if(at, file.end(), [](auto c) { return c == '\n' || c == '\r'; });
    const std::span<const std::uint8_t> line(at, end);
    at = std::find_if(end, file.end(), [](auto c) { return c != '\n' && c != '\r'; });
    if (line.empty()) continue;
    const Bytes record = hex_record(line);
    if (record.empty()) refuse(image.path, "not an Intel HEX file");
    const std::span<const std::uint8_t> data = std::span(record).subspan(4, record[0]);
    const std::uint32_t word = data.size() == 2 ? data[0] * 256U + data[1] : 0U;
    switch (record[3]) {
      case 0:
        program(image, base + std::size_t{record[1]} * 256U + record[2], data);
        break;
      case 1:
        return;
      case 2:
        base = std::uint64_t{word} * 16;
        break;
      case 4:
        base = std::uint64_t{word} << 16U;
        break;
      default:  // start addresses mean nothing to a programmer
        break;
    }
  }
  refuse(image.path, "cut off");
}

}  // namespace

AvrImage read_avr_image(const std::string& path) {
  AvrImage image;
  image.path = path;
  const Bytes file = read_file(path);
  if (path.ends_with(".hex")) {
    read_hex(image, file);
  } else {
    read_elf(image, file);
  }
  if (image.flash.empty()) refuse(path, "holds no program");
  return image;
}

std::string built_firmware() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed =
        program.parent_path().parent_path() / "share" / "tp100" / "tp100.hex";
    if (fs::exists(installed, error)) return installed.string();
  }
  const fs::path built = fs::path(TP100_FIRMWARE_DIR) / "tp100.elf";
  if (fs::exists(built, error)) return built.string();
  throw UserError(built.string() +
                  ": no firmware image; build one with scripts/build dev tp100_image, or use "
                  "--board native");
}

std::string stock_bootloader() {
  std::string path =
      "/usr/share/arduino/hardware/arduino/avr/bootloaders/stk500v2/stk500boot_v2_mega2560.hex";
  std::error_code error;
  if (fs::exists(path, error)) return path;
  throw UserError(path + ": no bootloader; install the package arduino-core-avr");
}

}  // namespace tp100::sim
