// Texts and files as lists of lines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// The lines of a text without their ends; a last line without an end counts.
std::vector<std::string> split_lines(const std::string& text);

/// The lines of a file. Throws InputError as read_file() does.
std::vector<std::string> read_lines(const std::filesystem::path& path);

}  // namespace canproof::host
