// Objects out of the register's files.
#pragma once

#include <string>
#include <vector>

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

/// One [[object]]: a list, because `repeat` makes one for each n.
std::vector<Object> read_objects(TomlItem& item, const std::string& prefix);

}  // namespace canproof::host
