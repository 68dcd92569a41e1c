#include "doctor/host.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <optional>
#include <set>
#include <string_view>

#include "link/port_holder.h"

namespace tp100::doctor {
namespace {

// Slow to read, or too coarse for a loop of a millisecond.
constexpr auto kPoorClocks =
    std::to_array<std::string_view>({"hpet", "acpi_pm", "jiffies", "refined-jiffies", "pit"});

// A recording at 1 kHz takes about a tenth of it.
constexpr double kSlowDiskMbPerS = 20.0;
constexpr double kLittleSpaceMb = 500.0;

constexpr const char* kListening = "0A";

std::string text_of(double value, const char* unit) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.0f %s", value, unit);
  return text.data();
}

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

Findings real_time_findings(const std::vector<loop::Grant>& grants) {
  Findings findings;
  std::string granted;
  for (const loop::Grant& grant : grants) {
    if (grant.granted) {
      granted += (granted.empty() ? "" : ", ") + grant.what;
    } else {
      findings.push_back(
          {Severity::kWarning, "real-time", "not granted: " + grant.what, grant.remedy});
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
  return {{Severity::kWarning, "clock-source", *current + " is slow to read",
           better != others.end()
               ? "echo " + *better + " | sudo tee " + folder + "current_clocksource"
               : "boot with tsc=reliable if this processor's TSC is constant (grep constant_tsc "
                 "/proc/cpuinfo), else use another machine"}};
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
    return {ok("governor", "the processors' speed is not the kernel's to choose")};
  governors.erase("performance");
  if (governors.empty()) return {ok("governor", "performance")};
  std::string seen;
  for (const std::string& governor : governors) seen += (seen.empty() ? "" : ", ") + governor;
  return {{Severity::kWarning, "governor", seen + ": processors slow down between steps",
           "echo performance | sudo tee " + folder + "cpu*/cpufreq/scaling_governor"}};
}

Findings page_port_findings(const System& system, std::uint16_t port) {
  const std::string number = std::to_string(port);
  for (const char* const table : {"/proc/net/tcp", "/proc/net/tcp6"}) {
    const std::string inode = listener(system.text(table).value_or(""), port);
    if (inode.empty()) continue;
    const std::string holder =
        link::port_holder("socket:[" + inode + "]", system.file("/proc")).name;
    return {
        {Severity::kWarning, "page-port",
         "TCP port " + number + " of the page is taken" + (holder.empty() ? "" : " by " + holder),
         "end that program, or give another port with tp100d run --listen 127.0.0.1:0"}};
  }
  return {ok("page-port", "TCP port " + number + " is free")};
}

Findings disk_findings(const Disk& disk) {
  const std::string elsewhere = "record to another disk: record.directory in the configuration";
  if (!disk.error.empty())
    return {{Severity::kWarning, "disk", disk.folder + ": cannot be written (" + disk.error + ")",
             elsewhere}};
  const std::string figures =
      text_of(disk.written_mb_per_s, "MB/s") + ", " + text_of(disk.free_mb, "MB free");
  if (disk.free_mb < kLittleSpaceMb)
    return {{Severity::kWarning, "disk", disk.folder + ": little space, " + figures,
             "delete old recordings, or " + elsewhere}};
  if (disk.written_mb_per_s < kSlowDiskMbPerS)
    return {{Severity::kWarning, "disk", disk.folder + ": slow, " + figures, elsewhere}};
  return {ok("disk", disk.folder + ": " + figures)};
}

}  // namespace tp100::doctor
