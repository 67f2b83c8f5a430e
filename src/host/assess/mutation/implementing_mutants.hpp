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

namespace canproof::host {

/// Returns the sorted numbers of the mutants of each item, by its id. The item has the mutants of the function or
/// statements below each of its links (implements<> assertions), of the condition on which these statements run, and of
/// the functions that this code calls. These called functions are searched in the same file, in the headers that it
/// includes and in the source files of these headers. The functions that a called function calls in its own file count
/// as well. An item of a device that a shared requirement implements has the mutants of that requirement. `root` is the
/// project's folder.
std::map<std::string, std::vector<std::size_t>> implementing_mutants(const std::filesystem::path& root,
                                                                     const Evidence& evidence,
                                                                     const std::vector<AlteredCell>& mutants);

}  // namespace canproof::host
