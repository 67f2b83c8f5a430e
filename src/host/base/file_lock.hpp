// SPDX-License-Identifier: Apache-2.0
// Locks a file, so that one process at a time uses it.
#pragma once

#include <string>

namespace canproof::host {

/// Locks the file. Returns false when another process has locked it. Throws std::system_error when the file cannot be
/// locked, for example because the file system has no locks.
bool try_lock(int descriptor);
/// Locks the file or folder; waits while another process has locked it. Returns false when it cannot be locked, for
/// example because the file system has no locks.
bool wait_for_lock(int descriptor);
/// Returns the process that has locked the file with flock: `process 4711 (canproof)`. Returns `another process` when
/// the system does not report it.
std::string lock_holder(int descriptor);

}  // namespace canproof::host
