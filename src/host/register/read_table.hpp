// SPDX-License-Identifier: Apache-2.0
// Reads the decision tables in the register's files.
#pragma once

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

/// Reads one [[table]]. Adds its faults to those of `item`.
Table read_table(TomlItem& item);

}  // namespace canproof::host
