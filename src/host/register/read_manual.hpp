// SPDX-License-Identifier: Apache-2.0
// Reads the manuals and their statements in spec/manuals.
#pragma once

#include <vector>

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

/// First part of the paths of the files with manuals and statements.
inline const std::string manuals_folder = "spec/manuals/";

/// Reads a manual from spec/manuals/NAME.toml, or statements of that manual from a file in spec/manuals/NAME/. The file
/// of the manual must be read first.
void read_manual_file(TomlItem& item, std::vector<Manual>& manuals);

/// Numbers the statements of each section, table, figure and object from 1, in the order in which they were read.
void number_statements(std::vector<Manual>& manuals);

}  // namespace canproof::host
