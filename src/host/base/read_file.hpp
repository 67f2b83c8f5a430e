// SPDX-License-Identifier: Apache-2.0
// Reads whole files in bounded memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace canproof::host {

/// Greatest length in bytes of a file of the requirements register, or of another TOML file.
constexpr std::size_t longest_toml_file = std::size_t{16} << 20U;

/// Greatest length in bytes of any other file that is read as a whole.
constexpr std::size_t longest_file = std::size_t{256} << 20U;

/// Returns the content of `path`, at most `most` bytes. Throws InputError with the path and the remedy when the file
/// cannot be opened or read, is a folder or an empty pipe, or has more bytes. Does not wait until a writer opens a
/// pipe. Reads at most `most` + 1 bytes.
std::string read_file(const std::filesystem::path& path, std::size_t most = longest_file);

}  // namespace canproof::host
