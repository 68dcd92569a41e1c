#include "doctor/host_checks.h"

#include <stdlib.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/clock.h"
#include "core/time.h"
#include "link/port_holder.h"
#include "text/format.h"
#include "text/temporary.h"

namespace tp100::doctor {

namespace {

// Clocks that are slow to read, or too coarse for a loop with a period of a millisecond.
constexpr auto kPoorClocks =
    std::to_array<std::string_view>({"hpet", "acpi_pm", "jiffies", "refined-jiffies", "pit"});

// A recording at 1 kHz needs about a tenth of it.
constexpr double kSlowDiskMbPerS = 20.0;
constexpr double kLittleSpaceMb = 500.0;

constexpr const char* kListening = "0A";

std::string text_of(double value, const char* unit) { return text::format("%.0f %s", value, unit); }

/// The socket that listens on `port` by a table of /proc/net; empty: none. Columns: entry, local
/// address:port, remote, state, queues, timer, retransmits, owner, time-out, inode.
std::string listener(const std::string& table, std::uint16_t port) {
  for (const std::string& line : lines(table)) {
    std::vector<std::string> fields = split(line, ' ');
    std::erase(fields, "");
    if (fields.size() < 10 || fields[3] != kListening) continue;
    const std::string& address = fields[1];
    const std::size_t colon = address.rfind(':');
    if (colon == std::string::npos) continue;
    unsigned number = 0;
    std::from_chars(address.data() + colon + 1, address.data() + address.size(), number, 16);
    if (number == port) return fields[9];
  }
  return {};
}

bool is_processor(const std::string& name) {
  return name.size() > 3 && name.rfind("cpu", 0) == 0 &&
         name.find_first_not_of("0123456789", 3) == std::string::npos;
}

}  // namespace

Findings real_time_findings(const std::vector<loop::Privilege>& privileges) {
  Findings findings;
  std::string granted;
  for (const loop::Privilege& privilege : privileges) {
    if (privilege.granted) {
      granted += (granted.empty() ? "" : ", ") + privilege.what;
    } else {
      findings.push_back(warning("real-time", "not granted: " + privilege.what, privilege.fix));
    }
  }
  if (!granted.empty()) findings.insert(findings.begin(), ok("real-time", granted));
  return findings;
}

Findings clock_source_findings(const System& system) {
  const std::string folder = "/sys/devices/system/clocksource/clocksource0/";
  const auto current = system.text(folder + "current_clocksource");
  if (!current) return {};
  if (std::find(kPoorClocks.begin(), kPoorClocks.end(), *current) == kPoorClocks.end())
    return {ok("clock-source", *current)};
  const std::vector<std::string> others =
      split(system.text(folder + "available_clocksource").value_or(""), ' ');
  const auto better = std::find_if(others.begin(), others.end(), [](const std::string& other) {
    return std::find(kPoorClocks.begin(), kPoorClocks.end(), other) == kPoorClocks.end();
  });
  return {
      warning("clock-source", *current + " is slow to read",
              better != others.end()
                  ? "echo " + *better + " | sudo tee " + folder + "current_clocksource"
                  : "boot with tsc=reliable if this processor's TSC is constant (grep constant_tsc "
                    "/proc/cpuinfo), else use another machine")};
}

Findings governor_findings(const System& system) {
  const std::string folder = "/sys/devices/system/cpu/";
  std::set<std::string> governors;
  for (const std::string& name : system.names(folder)) {
    if (!is_processor(name)) continue;
    const auto governor = system.text(folder + name + "/cpufreq/scaling_governor");
    if (governor) governors.insert(*governor);
  }
  if (governors.empty())
    return {ok("governor", "the kernel does not control the processors' frequency")};
  governors.erase("performance");
  if (governors.empty()) return {ok("governor", "performance")};
  std::string seen;
  for (const std::string& governor : governors) seen += (seen.empty() ? "" : ", ") + governor;
  return {warning("governor", seen + ": processors slow down between steps",
                  "echo performance | sudo tee " + folder + "cpu*/cpufreq/scaling_governor")};
}

Findings load_findings(const System& system) {
  const std::string text = system.text("/proc/loadavg").value_or("");
  const auto load = text::number_in<double>(text.substr(0, text.find(' ')));
  const std::vector<std::string> names = system.names("/sys/devices/system/cpu/");
  const auto processors = std::ranges::count_if(names, is_processor);
  if (!load || processors == 0) return {};
  const std::string seen = text::format("%.1f programs want %zu processors", *load,
                                        static_cast<std::size_t>(processors));
  if (*load <= static_cast<double>(processors)) return {ok("load", seen)};
  return {warning("load", seen + ": the loop may be late", "end other programs; top lists them")};
}

Findings page_port_findings(const System& system, std::uint16_t port) {
  const std::string number = std::to_string(port);
  for (const char* const table : {"/proc/net/tcp", "/proc/net/tcp6"}) {
    const std::string inode = listener(system.text(table).value_or(""), port);
    if (inode.empty()) continue;
    const std::string holder =
        link::port_holder("socket:[" + inode + "]", system.file("/proc")).name;
    return {warning(
        "page-port",
        "TCP port " + number + " of the page is taken" + (holder.empty() ? "" : " by " + holder),
        "end that program, or give another port with tp100d run --listen 127.0.0.1:0")};
  }
  return {ok("page-port", "TCP port " + number + " is free")};
}

Findings disk_findings(const Disk& disk) {
  const std::string elsewhere = "record to another disk: record.directory in the configuration";
  if (!disk.error.empty())
    return {warning("disk", disk.folder + ": cannot be written (" + disk.error + ")", elsewhere)};
  const std::string figures =
      text_of(disk.written_mb_per_s, "MB/s") + ", " + text_of(disk.free_mb, "MB free");
  if (disk.free_mb < kLittleSpaceMb)
    return {warning("disk", disk.folder + ": little space, " + figures,
                    "delete old recordings, or " + elsewhere)};
  if (disk.written_mb_per_s < kSlowDiskMbPerS)
    return {warning("disk", disk.folder + ": slow, " + figures, elsewhere)};
  return {ok("disk", disk.folder + ": " + figures)};
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPieceBytes = 1U << 20U;
constexpr int kPieces = 16;

std::string existing(const std::string& folder) {
  std::error_code error;
  fs::path at = folder.empty() ? fs::current_path(error) : fs::absolute(folder, error);
  while (at.has_relative_path() && !fs::is_directory(at, error)) at = at.parent_path();
  return at;
}

bool write_all(int fd) {
  const std::vector<char> piece(kPieceBytes, 'x');
  for (int i = 0; i < kPieces; ++i) {
    for (std::size_t done = 0; done < piece.size();) {
      const ssize_t n = ::write(fd, piece.data() + done, piece.size() - done);
      if (n < 0) return false;
      done += static_cast<std::size_t>(n);
    }
  }
  return ::fsync(fd) == 0;
}

}  // namespace

doctor::Disk try_disk(const std::string& folder) {
  doctor::Disk disk;
  disk.folder = existing(folder);
  std::string name;
  const int fd = text::make_temporary_file(disk.folder, name);
  if (fd < 0) {
    disk.error = std::strerror(errno);
    return disk;
  }
  ::unlink(name.c_str());
  struct statvfs space {};
  if (::fstatvfs(fd, &space) == 0)
    disk.free_mb = static_cast<double>(space.f_bavail) * static_cast<double>(space.f_frsize) * 1e-6;
  const HostNs begun = monotonic_now();
  if (!write_all(fd)) disk.error = std::strerror(errno);
  const double took_s = to_s(monotonic_now() - begun);
  ::close(fd);
  if (took_s > 0.0)
    disk.written_mb_per_s = kPieces * static_cast<double>(kPieceBytes) * 1e-6 / took_s;
  return disk;
}

}  // namespace tp100::doctor
