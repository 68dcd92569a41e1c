#pragma once
// Files and folders that a program is still writing: their names are .tp100-XXXXXX, which no list
// shows, and they are locked (flock) until they are closed, so that what a killed program has left
// can be told from what another one is writing. Any thread; the functions wait for the disk.

#include <string>

namespace tp100::text {

/// Makes a temporary file in `folder` and returns its descriptor, open for writing, and its path;
/// -1: errno tells why not. The caller closes and removes it, or renames it.
int make_temporary_file(const std::string& folder, std::string& path);
/// The same for a folder, open for reading.
int make_temporary_folder(const std::string& folder, std::string& path);

/// Removes the temporary files and folders directly in `folder` (empty: the working folder) that
/// this account has made and no program has open. Leaves links, other names, and everything on a
/// disk without locks. What cannot be removed stays.
void sweep_temporary(const std::string& folder);

}  // namespace tp100::text
