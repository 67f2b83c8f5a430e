// A device's memory in a file that outlives the program.
#pragma once

#include <filesystem>

#include "host/sim/bus/bus.hpp"
#include "host/sim/devices/memory.hpp"

namespace canproof::host {

/// Fills `memory` from `file` and writes each commit there: on disk before the commit returns. The file is made when
/// there is none, and is locked as long as the memory lives. `tell` hears why a commit failed.
/// Throws InputError when the file is in use, cannot be read or is no image of this memory; it then stays as it is.
void keep_in_file(Memory& memory, const std::filesystem::path& file, NoticeListener tell);

}  // namespace canproof::host
