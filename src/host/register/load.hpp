// SPDX-License-Identifier: Apache-2.0
// Reads and checks a requirements register.
#pragma once

#include <filesystem>
#include <optional>

#include "host/register/fault.hpp"
#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

struct LoadResult {
    Register content;
    Faults faults;  ///< in ascending order of file and line
};

/// Reads and checks the files. Reports all faults at once, but no other faults while a file is not TOML, because they
/// may only follow from what this file lacks. A register with faults must not be used.
LoadResult load_register(const SpecFiles& files);
/// Reads and checks the files of a folder. Throws InputError when the folder contains no files of a register.
LoadResult load_register(const std::filesystem::path& spec);
/// Reads all or some files of a register that was checked before, without checking it again. Returns nothing when the
/// given files cannot be read alone, for example because an item needs a file that is left out.
std::optional<Register> read_sound_register(const SpecFiles& files);

}  // namespace canproof::host
