// What a revision in git holds, read without checking it out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

/// The files of spec/ as they were. Throws InputError when there is no such revision, or git is missing.
SpecFiles spec_files_at(const std::filesystem::path& root, const std::string& revision);

/// Files below these folders that differ from the revision, those not yet committed included.
std::vector<std::string> files_changed_since(const std::filesystem::path& root, const std::string& revision,
                                             const std::vector<std::string>& folders);

}  // namespace canproof::host
