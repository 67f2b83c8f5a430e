// SPDX-License-Identifier: Apache-2.0
// The results of all theorems, as a table and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

nlohmann::json json_of(const TheoremResult& result);
/// Converts the JSON of json_of() back to results. Throws nlohmann's exceptions.
TheoremResult result_of(const nlohmann::json& json);

std::size_t count(const std::vector<TheoremResult>& results, Verdict verdict);
/// Returns a count of paths as text; from a million on only its order of magnitude.
std::string paths_text(double paths);

std::string table_of(const std::vector<TheoremResult>& results);
std::string json_text(const std::vector<TheoremResult>& results);

}  // namespace canproof::host::prove
