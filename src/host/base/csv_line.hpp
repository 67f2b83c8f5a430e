// Lines of comma-separated values.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

/// RFC 4180: a field is in quotes where a comma, a quote or a break stands in it.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace canproof::host
