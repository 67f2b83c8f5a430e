// A new project with one device: what `canproof new` writes.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

struct NewProject {
    std::string name;         ///< of folder and device: small letters, digits, single dashes
    std::string prefix;       ///< of its ids: capital letters and digits; empty: from the name
    std::string manual;       ///< its manual's title; empty: from the device
    std::string date;         ///< of the manual, 2026-11-22
    std::optional<Part> eds;  ///< identity and objects from a data sheet; the template's own without one
};

/// The files by path. Throws InputError when a name cannot be used.
std::map<std::string, std::string> project_files(const NewProject& project);

}  // namespace canproof::host
