// SPDX-License-Identifier: Apache-2.0
// Stores a device's memory in a file.
#pragma once

#include <filesystem>

#include "host/sim/bus/bus.hpp"
#include "host/sim/devices/memory.hpp"

namespace canproof::host {

/// Fills `memory` from `file`, and writes each commit to the file before the commit returns. Creates a missing file.
/// The file is locked as long as the memory exists. `tell` receives the reason of a failed commit. Throws InputError
/// when the file is in use, cannot be read, created or locked, or is no image of this memory; the file then stays
/// unchanged.
void keep_in_file(Memory& memory, const std::filesystem::path& file, NoticeListener tell);

}  // namespace canproof::host
