// A register, read and checked.
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

/// Reads and checks. Everything that is wrong is told at once; a register with faults is not to be used.
LoadResult load_register(const SpecFiles& files);
/// The same for the files of a folder. Throws InputError when it has none.
LoadResult load_register(const std::filesystem::path& spec);
/// Reads files that were found sound before, or some of them: half the work. Nothing when an item needs another file.
std::optional<Register> read_sound_register(const SpecFiles& files);

}  // namespace canproof::host
