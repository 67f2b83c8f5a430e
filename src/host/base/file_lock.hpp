// A file that one process at a time may use.
#pragma once

#include <string>

namespace canproof::host {

/// False when somebody else has locked it. Throws std::system_error when the file system has no locks.
bool try_lock(int descriptor);
/// Who has locked that file, by flock: `process 4711 (canproof)`; `another process` when the system does not tell.
std::string lock_holder(int descriptor);

}  // namespace canproof::host
