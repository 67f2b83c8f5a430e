// SPDX-License-Identifier: Apache-2.0
// A hash of a project's sources. Two checkouts of one commit have the same hash, on any machine and in any folder.
#pragma once

#include <filesystem>
#include <string>

namespace canproof::host {

/// Returns the SHA-256 of the sources of the project in `root`, as 64 hexadecimal digits: names and contents of the
/// .cpp, .hpp, .py, .toml, .cmake and CMakeLists.txt files of src, spec, tests, properties and fuzz. Reviews are left
/// out, because no program is built from them. Throws InputError for a file that it cannot read.
std::string source_hash(const std::filesystem::path& root);

}  // namespace canproof::host
