// SPDX-License-Identifier: Apache-2.0
// Reads a TOML file of records that people write. Reports the first fault with file, line and fix.
#pragma once

#include <filesystem>
#include <functional>

#include "host/register/toml_item.hpp"

namespace canproof::host {

/// Calls `read` with the table of the file. Throws InputError for a file that cannot be read, for invalid TOML, and for
/// the first fault that `read` has reported.
void read_toml_records(const std::filesystem::path& file, const std::function<void(TomlItem&)>& read);

}  // namespace canproof::host
