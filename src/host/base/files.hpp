// Files that the commands read and write. Each throws InputError with the path and the remedy.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace canproof::host {

std::ifstream open_input(const std::string& path);
/// Replaces the whole file, or leaves it as it was; folders on the way are made.
void write_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace canproof::host
