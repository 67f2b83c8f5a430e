// SPDX-License-Identifier: Apache-2.0
// Reads a TOML file of records that people write; the first fault is reported with file, line and remedy.
#pragma once

#include <filesystem>
#include <functional>

#include "host/register/toml_item.hpp"

namespace canproof::host {

/// Passes the file's table to `read`. Throws InputError for invalid TOML, and for the first fault that `read` reported.
void read_toml_records(const std::filesystem::path& file, const std::function<void(TomlItem&)>& read);

}  // namespace canproof::host
