// SPDX-License-Identifier: Apache-2.0
// Replaces folders as a whole.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace canproof::host {

/// Replaces `folder` by a folder that contains exactly these files, given by relative path. When the function returns,
/// the files are on disk. If the program stops earlier, `folder` contains the old or the new files. On a file system
/// that cannot exchange two folders in one step, `folder` can then be missing. In this case, the old files are in
/// `.NAME.new.old` beside it, and the next call restores them first. Throws std::system_error on a write error.
void replace_folder(const std::filesystem::path& folder, const std::map<std::string, std::string>& files);

/// Checks that replace_folder() can write beside `folder`: makes and removes a temporary folder there. Throws
/// InputError.
void check_replaceable(const std::filesystem::path& folder);

}  // namespace canproof::host
