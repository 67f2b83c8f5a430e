// SPDX-License-Identifier: Apache-2.0
// The mutants of code in the functions that implement an item.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host/assess/mutation/test_server.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the sorted numbers of the mutants by item. They lie in the function below a link and in the functions that
/// it calls, in its own file or in files that this file includes. Functions called by those, in their own file, count
/// as well. An item that a shared requirement implements for a device has the mutants of that requirement. `root` is
/// the project's folder.
std::map<std::string, std::vector<std::size_t>> implementing_mutants(const std::filesystem::path& root,
                                                                     const Register& content, const Evidence& evidence,
                                                                     const std::vector<AlteredCell>& mutants);

}  // namespace canproof::host
