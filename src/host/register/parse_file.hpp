// SPDX-License-Identifier: Apache-2.0
// The first step of reading a file of the register: from its text to a table of TOML.
#pragma once

#include <toml++/toml.h>

#include <functional>
#include <string>

#include "host/register/fault.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

/// Passes the file's table to `read`. Adds a fault instead when the text is not TOML or is nested too deeply.
void parse_file(const std::string& path, const std::string& text, Faults& faults,
                const std::function<void(const toml::table&)>& read);

/// Returns the faults of those files that are not TOML or are nested too deeply.
Faults syntax_faults(const SpecFiles& files);

}  // namespace canproof::host
