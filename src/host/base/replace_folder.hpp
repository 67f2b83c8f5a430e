// SPDX-License-Identifier: Apache-2.0
// Replaces folders as a whole.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace canproof::host {

/// Replaces `folder` by one that contains exactly these files by relative path; it is on disk when it returns. If the
/// program stops meanwhile, the old or the new files exist. Throws std::system_error on a write error.
void replace_folder(const std::filesystem::path& folder, const std::map<std::string, std::string>& files);

}  // namespace canproof::host
