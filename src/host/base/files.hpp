// SPDX-License-Identifier: Apache-2.0
// Opens and writes files for the commands. Each function throws InputError with the path when it cannot open or write
// the file.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace canproof::host {

std::ifstream open_input(const std::string& path);
/// Replaces the whole file, or leaves it unchanged on an error. Creates missing folders.
void write_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace canproof::host
