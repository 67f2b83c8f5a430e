// SPDX-License-Identifier: Apache-2.0
// Reads the objects in the register's files.
#pragma once

#include <string>
#include <vector>

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

/// Reads one [[object]]. Returns one object or, if the [[object]] has `repeat`, one object for each number of the
/// family. Returns none when the index is missing or invalid.
std::vector<Object> read_objects(TomlItem& item, const std::string& prefix);

}  // namespace canproof::host
