// SPDX-License-Identifier: Apache-2.0
// Finds the items to which code without implements<> belongs: by the generated names that the code uses, and by the
// files that include it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host/assess/trace/evidence.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the files of the firmware that have no implements<> and that no file with implements<> includes, directly or
/// indirectly. Inclusion by code that is generated from the register counts as well. A header and its source file of
/// the same name form one unit.
std::vector<std::string> untraced_files(const std::filesystem::path& source, const Evidence& evidence);

/// Returns, by the id of an item, the places where code names what is generated from the item: a table, a constant, an
/// enumeration, an object's field or a signal. A place is `src/…:line`; only the first place in each file is returned.
std::map<std::string, std::vector<std::string>> generated_uses(const std::filesystem::path& root,
                                                               const Register& content);

}  // namespace canproof::host
