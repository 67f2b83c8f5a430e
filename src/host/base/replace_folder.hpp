// Folders that are written as a whole.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace canproof::host {

/// `folder` holds these files, by relative path, and nothing else, on disk when it returns. Whatever ends the program
/// on the way, its old files or its new ones are there. Throws std::system_error when the disk refuses.
void replace_folder(const std::filesystem::path& folder, const std::map<std::string, std::string>& files);

}  // namespace canproof::host
