// SPDX-License-Identifier: Apache-2.0
// Splits texts and files into lines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// Returns the lines of a text without their line breaks; a last line without a line break counts as well.
std::vector<std::string> split_lines(const std::string& text);

/// Returns the lines of a file. Throws InputError as read_file() does.
std::vector<std::string> read_lines(const std::filesystem::path& path);

}  // namespace canproof::host
