#pragma once
// The user's files as viewers see and change them: courses, robots and the configuration.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "live/setup_changer.h"
#include "server/service.h"

namespace tp100::live {

/// file_save, file_delete and file_check. `changer` must outlive the rows.
std::vector<server::ServiceRow> file_services(SetupChanger& changer);

/// parameters_save changes the configuration file as it is on the disk then, and keeps the previous
/// file as FILE.bak; parameters_restore exchanges the two. `changer` must outlive the rows.
std::vector<server::ServiceRow> parameter_services(SetupChanger& changer);

/// GET of /api/setup, /courses/NAME.toml and /robots/NAME.toml; nothing: no such file. Waits for
/// the disk; any thread.
std::optional<std::string> setup_content(const SetupChanger& changer, std::string_view path);

}  // namespace tp100::live
