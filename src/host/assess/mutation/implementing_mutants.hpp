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

/// Returns the sorted numbers of the mutants of each item. These are the mutants in the function below a link of the
/// item, and in functions that it calls. A called function counts in the same file, in an included header, or in that
/// header's source file. So does a function that a called function calls in its own file. An item of a device that a
/// shared requirement implements has the mutants of that requirement. `root` is the project's folder.
std::map<std::string, std::vector<std::size_t>> implementing_mutants(const std::filesystem::path& root,
                                                                     const Register& content, const Evidence& evidence,
                                                                     const std::vector<AlteredCell>& mutants);

}  // namespace canproof::host
