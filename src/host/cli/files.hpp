// Files that the commands read and write. Each throws InputError with the path and the remedy.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "host/devices/memory.hpp"

namespace canproof::host {

std::ifstream open_input(const std::string& path);
/// The image of a device's non-volatile memory; a file that does not exist leaves it blank.
void load_memory(Memory& memory, const std::string& path);
void save_memory(Memory& memory, const std::string& path);
/// Writes the whole file; folders on the way are made.
void write_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace canproof::host
