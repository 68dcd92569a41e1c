#include "doctor/usb.h"

#include <charconv>
#include <filesystem>
#include <optional>

namespace tp100::doctor {
namespace {

namespace fs = std::filesystem;

// The CH340 and CH341; the CH9102 is another design.
constexpr int kCh340Vendor = 0x1a86;
constexpr int kCh9102 = 0x55d4;

/// The folder in /sys of the USB device that the port belongs to.
std::optional<std::string> usb_device(const System& system, const std::string& tty) {
  fs::path at = system.real(tty);
  while (at.has_relative_path()) {
    if (system.exists(at.string() + "/idVendor")) return at.string();
    at = at.parent_path();
  }
  return std::nullopt;
}

std::string write_command(const std::string& value, const std::string& file) {
  return "echo " + value + " | sudo tee " + file;
}

void add_autosuspend(const System& system, const std::string& usb, Findings& findings) {
  const std::string file = usb + "/power/control";
  const auto control = system.text(file);
  if (!control) return;
  if (*control == "auto") {
    findings.push_back({Severity::kWarning, "autosuspend",
                        "the robot's USB device may be put to sleep (" + file + " is auto)",
                        write_command("on", file)});
  } else {
    findings.push_back(ok("autosuspend", "off for the robot's USB device"));
  }
}

void add_latency_timer(const System& system, const std::string& tty, Findings& findings) {
  const std::string file = tty + "/device/latency_timer";
  const auto text = system.text(file);
  if (!text) return;
  int ms = 0;
  std::from_chars(text->data(), text->data() + text->size(), ms);
  if (ms > 1) {
    findings.push_back({Severity::kWarning, "latency-timer",
                        "the bridge keeps bytes back for up to " + *text + " ms",
                        write_command("1", file)});
  } else {
    findings.push_back(ok("latency-timer", *text + " ms"));
  }
}

}  // namespace

Findings usb_findings(const System& system, const std::string& device, const link::PortInfo& info) {
  Findings findings;
  const std::string tty = "/sys/class/tty/" + fs::path(device).filename().string();
  const auto usb = usb_device(system, tty);
  if (!usb) return findings;
  add_autosuspend(system, *usb, findings);
  add_latency_timer(system, tty, findings);
  if (info.vendor_id == kCh340Vendor && info.product_id != kCh9102)
    findings.push_back({Severity::kNote, "bridge",
                        link::describe(info) + ": some of them lose bytes at 500000 baud",
                        "if the link test counts damaged frames, use a short cable without a hub "
                        "or another Mega"});
  return findings;
}

}  // namespace tp100::doctor
