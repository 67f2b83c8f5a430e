// SPDX-License-Identifier: Apache-2.0
#include "host/prove/kept_verdicts.hpp"

#include <nlohmann/json.hpp>

#include "host/base/files.hpp"
#include "host/base/read_file.hpp"
#include "host/prove/results.hpp"

namespace canproof::host::prove {

std::optional<TheoremResult> KeptVerdicts::find(const std::string& code) const {
    if (!is_used() || !std::filesystem::exists(place_of(code))) {
        return std::nullopt;
    }
    try {
        TheoremResult result = result_of(nlohmann::json::parse(read_file(place_of(code))));
        result.is_kept = true;
        return result.verdict == Verdict::proven ? std::optional{result} : std::nullopt;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

void KeptVerdicts::keep(const std::string& code, const TheoremResult& result) const {
    if (is_used() && !code.empty() && result.verdict == Verdict::proven && !result.is_kept) {
        write_file(place_of(code), json_of(result).dump(1) + "\n");
    }
}

}  // namespace canproof::host::prove
