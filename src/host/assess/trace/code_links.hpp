// How code that names no requirement serves one all the same: through what was generated, and through inclusion.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host/assess/trace/evidence.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Files of the firmware that have no implements<> and that no file which has one includes, directly or by way of
/// others, the code that the compiler of the register writes among it. A header and the source file of the same name
/// are one.
std::vector<std::string> untraced_files(const std::filesystem::path& source, const Evidence& evidence);

/// Where the code names what was generated from an item: a table, a constant, an enumeration, an object's field, a
/// signal. By id, `src/…:line`, one place a file.
std::map<std::string, std::vector<std::string>> generated_uses(const std::filesystem::path& root,
                                                               const Register& content);

}  // namespace canproof::host
