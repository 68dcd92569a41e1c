#include "doctor/account.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <optional>

namespace tp100::doctor {
namespace {

/// A line of /etc/group.
struct Group {
  std::string name;
  std::vector<std::string> members;
};

std::optional<Group> group_of(const System& system, gid_t gid) {
  for (const std::string& line : lines(system.text("/etc/group").value_or(""))) {
    const std::vector<std::string> fields = split(line, ':');
    if (fields.size() < 3 || fields[2] != std::to_string(gid)) continue;
    return Group{fields[0], fields.size() > 3 ? split(fields[3], ',') : std::vector<std::string>()};
  }
  return std::nullopt;
}

bool granted(mode_t mode, mode_t both) { return (mode & both) == both; }

std::string mode_text(mode_t mode) {
  char text[8];
  std::snprintf(text, sizeof text, "%04o", static_cast<unsigned>(mode & 07777U));
  return text;
}

}  // namespace

Findings permission_findings(const System& system, const std::string& device,
                             const Account& account, bool usable) {
  const std::optional<DeviceFile> file = system.device(device);
  if (!file) return {};
  if (usable) return {ok("permission", device + ": " + account.name + " may read and write it")};
  const std::optional<Group> group = group_of(system, file->gid);
  const std::string name = group ? group->name : std::to_string(file->gid);
  if (!granted(file->mode, S_IRGRP | S_IWGRP))
    return {
        {Severity::kError, "permission",
         device + ": mode " + mode_text(file->mode) + " lets nobody but its owner use it",
         "unplug the robot and plug it in again; if that does not help: sudo chmod 660 " + device}};
  const bool in_group =
      std::find(account.groups.begin(), account.groups.end(), file->gid) != account.groups.end();
  // With an access list, the mode's middle is the list's mask and not what the group may.
  if (in_group)
    return {{Severity::kError, "permission",
             device + ": the kernel refuses it to " + account.name + ", who is in group " + name,
             "look at its access list with getfacl " + device + "; sudo setfacl -b " + device +
                 " takes it away"}};
  const bool member = group && std::find(group->members.begin(), group->members.end(),
                                         account.name) != group->members.end();
  if (member)
    return {{Severity::kError, "group",
             account.name + " is in group " + name + ", but not in this session",
             "log out and in again, or only here: newgrp " + name}};
  return {{Severity::kError, "permission",
           device + ": " + account.name + " is not in group " + name + ", which may use it",
           "sudo adduser " + account.name + " " + name + ", then log out and in again"}};
}

}  // namespace tp100::doctor
