// SPDX-License-Identifier: Apache-2.0
// Writes lines of comma-separated values.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

/// Returns the fields as one line in the form of RFC 4180: a field that contains a comma, a quote or a line break is in
/// quotes.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace canproof::host
