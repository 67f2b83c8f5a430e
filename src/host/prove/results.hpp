// SPDX-License-Identifier: Apache-2.0
// Writes the results of all theorems as a table and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

nlohmann::json json_of(const TheoremResult& result);
/// Converts JSON that json_of() has written to a result. Throws nlohmann's exceptions for other JSON.
TheoremResult result_of(const nlohmann::json& json);

std::size_t count(const std::vector<TheoremResult>& results, Verdict verdict);
/// Returns a number of paths as text; from a million on, with two significant digits.
std::string paths_text(double paths);

std::string table_of(const std::vector<TheoremResult>& results);
std::string json_text(const std::vector<TheoremResult>& results);

}  // namespace canproof::host::prove
