// SPDX-License-Identifier: Apache-2.0
// Reads the files of a git revision without a check-out, and lists the files that have changed since.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

/// Returns the files of spec/ at this git revision. Throws InputError when the revision does not exist or git is
/// missing.
SpecFiles spec_files_at(const std::filesystem::path& root, const std::string& revision);

/// Returns the files below these folders that differ from the git revision, as sorted paths relative to `root`.
/// Includes uncommitted changes and untracked files. Throws InputError when the revision does not exist or git is
/// missing.
std::vector<std::string> files_changed_since(const std::filesystem::path& root, const std::string& revision,
                                             const std::vector<std::string>& folders);

}  // namespace canproof::host
