// SPDX-License-Identifier: Apache-2.0
#include "host/assess/coverage/coverage_json.hpp"

#include <nlohmann/json.hpp>

namespace canproof::host {

namespace {

using Json = nlohmann::ordered_json;

Json count_json(const CoverageCount& count) {
    return {{"covered", count.covered}, {"total", count.total}};
}

}  // namespace

std::string coverage_json(const std::vector<FileCoverage>& files, const CoverageVerdict& verdict) {
    const CoverageTotals totals = totals_of(files);
    Json of_files = Json::array();
    for (const auto& file : files) {
        if (!file.is_host()) {
            of_files.push_back({{"file", file.file},
                                {"lines", count_json(file.line_count())},
                                {"branches", count_json(file.branches)},
                                {"conditions", count_json(file.conditions)}});
        }
    }
    Json gaps = Json::array();
    for (const auto& [gap, reason] : verdict.gaps) {
        gaps.push_back({{"kind", gap.kind},
                        {"file", gap.file},
                        {"line", gap.line},
                        {"code", gap.code},
                        {"missing", gap.missing},
                        {"reason", reason}});
    }
    const Json json{{"lines", count_json(totals.lines)},
                    {"branches", count_json(totals.branches)},
                    {"conditions", count_json(totals.conditions)},
                    {"files", of_files},
                    {"gaps", gaps},
                    {"holds", verdict.holds()}};
    return json.dump(2) + "\n";
}

}  // namespace canproof::host
