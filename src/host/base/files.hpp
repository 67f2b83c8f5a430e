// SPDX-License-Identifier: Apache-2.0
// Opens and writes files and folders for the commands. Each function throws InputError with the path when it cannot
// open or write the file or folder.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace canproof::host {

std::ifstream open_input(const std::string& path);
/// Replaces the whole file, or leaves it unchanged on an error. Creates missing folders.
void write_file(const std::filesystem::path& path, const std::string& bytes);
/// Returns the entries of a folder.
std::filesystem::directory_iterator open_folder(const std::filesystem::path& folder);
/// Creates the folder and the folders above it, as far as they do not exist.
void make_folder(const std::filesystem::path& folder);
/// Throws InputError when `folder`, or a folder above it, is a file.
void check_folder_place(const std::filesystem::path& folder);

}  // namespace canproof::host
