// Whole files, in bounded memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace canproof::host {

/// A text file of the register, or a record beside it, is never longer.
constexpr std::size_t longest_toml_file = std::size_t{16} << 20U;

/// More than any other file has that is read as a whole.
constexpr std::size_t longest_file = std::size_t{256} << 20U;

/// Everything that `path` holds, at most `most` bytes. Throws InputError with the path and the remedy: for a folder,
/// for a pipe that nobody writes to (it does not wait for a writer), for what cannot be read to its end, and for what
/// is longer, of which it reads no more than `most` and a byte.
std::string read_file(const std::filesystem::path& path, std::size_t most = longest_file);

}  // namespace canproof::host
