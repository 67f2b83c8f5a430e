// SPDX-License-Identifier: Apache-2.0
// Hashes of a project's files. Two checkouts of one commit have the same hashes, on any machine and in any folder.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace canproof::host {

using FileHashes = std::map<std::string, std::string>;  ///< SHA-256 by path relative to the project's folder

/// Returns the hashes of the regular files below `folders` of `root` for which `accepts` returns true. Leaves out a
/// folder that does not exist. Throws InputError for a file that it cannot read.
FileHashes file_hashes(const std::filesystem::path& root, const std::vector<std::string>& folders,
                       const std::function<bool(const std::filesystem::path&)>& accepts);

/// Returns the SHA-256 of the sources of the project in `root`, as 64 hexadecimal digits. It covers the names and
/// contents of the .cpp, .hpp, .py, .toml, .cmake and CMakeLists.txt files of src, spec, tests, properties and fuzz.
/// Reviews are left out, because no program is built from them. Throws InputError for a file that it cannot read.
std::string source_hash(const std::filesystem::path& root);

}  // namespace canproof::host
