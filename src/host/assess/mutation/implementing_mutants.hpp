// The mutants of code that lie in the functions that implement an item.
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

/// By item the numbers of the mutants, sorted: those in the function below a link, in the functions that it calls of
/// its own file and of files that this includes, and in those that these call of their own file. An item that a shared
/// requirement does for a device has the mutants of that requirement. `root` is the project's folder.
std::map<std::string, std::vector<std::size_t>> implementing_mutants(const std::filesystem::path& root,
                                                                     const Register& content, const Evidence& evidence,
                                                                     const std::vector<AlteredCell>& mutants);

}  // namespace canproof::host
