// Decision tables out of the register's files.
#pragma once

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

/// One [[table]]; what is wrong with it is a fault of `item`.
Table read_table(TomlItem& item);

}  // namespace canproof::host
