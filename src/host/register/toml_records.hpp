// A file of records in TOML that people write: read as a whole, its first fault told with file, line and remedy.
#pragma once

#include <filesystem>
#include <functional>

#include "host/register/toml_item.hpp"

namespace canproof::host {

/// Hands the file's table to `read`. Throws InputError for what is no TOML, and for the first fault that `read` noted.
void read_toml_records(const std::filesystem::path& file, const std::function<void(TomlItem&)>& read);

}  // namespace canproof::host
