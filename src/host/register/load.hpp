// SPDX-License-Identifier: Apache-2.0
// Reads and checks a register.
#pragma once

#include <filesystem>
#include <optional>

#include "host/register/fault.hpp"
#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

struct LoadResult {
    Register content;
    Faults faults;  ///< ascending by file and line
};

/// Reads and checks the files. It reports all faults at once; a register with faults must not be used.
LoadResult load_register(const SpecFiles& files);
/// Reads and checks the files of a folder. Throws InputError when there are none.
LoadResult load_register(const std::filesystem::path& spec);
/// Reads all or some files of a register that was checked before, without checking them again. Returns nothing when an
/// item needs another file.
std::optional<Register> read_sound_register(const SpecFiles& files);

}  // namespace canproof::host
