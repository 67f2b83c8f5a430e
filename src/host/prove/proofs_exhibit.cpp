// SPDX-License-Identifier: Apache-2.0
#include "host/prove/proofs_exhibit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <set>

#include "host/base/csv_line.hpp"
#include "host/prove/results.hpp"

namespace canproof::host::prove {

namespace {

std::string theorems_csv(const std::vector<TheoremResult>& results) {
    std::string text = csv_line({"area", "theorem", "statement", "requirements", "verdict", "functions", "paths",
                                 "obligations", "seconds", "reason"});
    for (const TheoremResult& one : results) {
        text += csv_line({one.area, one.name, one.statement, fmt::format("{}", fmt::join(one.requirements, " ")),
                          name_of(one.verdict), std::to_string(one.functions.size()), paths_text(one.paths),
                          std::to_string(one.obligations), fmt::format("{:.1f}", one.seconds), one.reason});
    }
    return text;
}

std::string assumptions_csv(const std::vector<TheoremResult>& results) {
    std::string text = csv_line({"theorem", "assumes"});
    for (const TheoremResult& one : results) {
        for (const std::string& assumption : one.assumptions) {
            text += csv_line({one.name, assumption});
        }
    }
    return text;
}

}  // namespace

std::map<std::string, std::string> exhibit_of(const std::vector<TheoremResult>& results,
                                              const std::vector<std::string>& left_out) {
    std::set<std::string> functions;
    std::set<std::string> requirements;
    std::size_t obligations = 0;
    nlohmann::ordered_json open = nlohmann::ordered_json::array();
    for (const TheoremResult& one : results) {
        obligations += one.obligations;
        if (one.verdict != Verdict::proven) {
            open.push_back(fmt::format("{} is {}: {}.", one.name, name_of(one.verdict), one.reason));
            continue;
        }
        functions.insert(one.functions.begin(), one.functions.end());
        requirements.insert(one.requirements.begin(), one.requirements.end());
    }
    for (const std::string& file : left_out) {
        open.push_back(fmt::format("The theorems of {} were not run, because their proofs take long.", file));
    }
    const std::size_t proven = count(results, Verdict::proven);
    const nlohmann::ordered_json exhibit{
        {"title", "Theorems about the firmware"},
        {"state", proven == results.size() ? "holds" : "open"},
        {"says", fmt::format("{} of {} theorems are proven for all values; {} are refuted, {} unknown.", proven,
                             results.size(), count(results, Verdict::refuted), count(results, Verdict::unknown))},
        {"figures",
         {{"theorems", results.size()},
          {"proven", proven},
          {"refuted", count(results, Verdict::refuted)},
          {"unknown", count(results, Verdict::unknown)},
          {"files of theorems that were not run", left_out.size()},
          {"functions of the firmware in proven theorems", functions.size()},
          {"requirements that proven theorems name", requirements.size()},
          {"obligations", obligations}}},
        {"open", open},
        {"data", {"proofs.json"}}};
    return {{"exhibit.json", exhibit.dump(1) + "\n"},
            {"theorems.csv", theorems_csv(results)},
            {"assumptions.csv", assumptions_csv(results)},
            {"proofs.json", json_text(results)}};
}

}  // namespace canproof::host::prove
