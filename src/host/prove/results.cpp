// SPDX-License-Identifier: Apache-2.0
#include "host/prove/results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace canproof::host::prove {

namespace {

Verdict verdict_named(const std::string& name) {
    for (const Verdict one : {Verdict::proven, Verdict::refuted}) {
        if (name_of(one) == name) {
            return one;
        }
    }
    return Verdict::unknown;
}

void append_details(std::string& text, const TheoremResult& one) {
    if (one.verdict == Verdict::proven) {
        return;
    }
    text += fmt::format("  {}\n", one.reason);
    for (std::size_t i = 0; i < one.inputs.size(); ++i) {
        text += fmt::format("  value {}: {}\n", i + 1, fmt::join(one.inputs[i], " "));
    }
    if (!one.replay.empty()) {
        text += fmt::format("  {}\n", one.replay);
    }
}

}  // namespace

std::size_t count(const std::vector<TheoremResult>& results, Verdict verdict) {
    return static_cast<std::size_t>(
        std::count_if(results.begin(), results.end(), [verdict](const auto& one) { return one.verdict == verdict; }));
}

std::string paths_text(double paths) {
    constexpr double most_written_out = 999999.0;
    return paths > most_written_out ? fmt::format("{:.1e}", paths) : fmt::format("{:.0f}", paths);
}

nlohmann::json json_of(const TheoremResult& one) {
    return {{"name", one.name},
            {"file", one.file},
            {"area", one.area},
            {"statement", one.statement},
            {"requirements", one.requirements},
            {"verdict", name_of(one.verdict)},
            {"reason", one.reason},
            {"functions", one.functions},
            {"assumptions", one.assumptions},
            {"uses", one.used_theorems},
            {"paths", one.paths},
            {"obligations", one.obligations},
            {"questions", one.questions},
            {"seconds", one.seconds},
            {"kept", one.is_kept},
            {"rests_on_base", one.rests_on_base},
            {"counterexample", one.inputs},
            {"replay", one.replay}};
}

TheoremResult result_of(const nlohmann::json& json) {
    TheoremResult one;
    one.name = json.at("name");
    one.file = json.at("file");
    one.area = json.at("area");
    one.statement = json.at("statement");
    json.at("requirements").get_to(one.requirements);
    one.verdict = verdict_named(json.at("verdict"));
    one.reason = json.at("reason");
    json.at("functions").get_to(one.functions);
    json.at("assumptions").get_to(one.assumptions);
    json.at("uses").get_to(one.used_theorems);
    one.paths = json.at("paths");
    one.obligations = json.at("obligations");
    one.questions = json.at("questions");
    one.seconds = json.at("seconds");
    one.is_kept = json.at("kept");
    one.rests_on_base = json.at("rests_on_base");
    json.at("counterexample").get_to(one.inputs);
    one.replay = json.at("replay");
    return one;
}

std::string table_of(const std::vector<TheoremResult>& results) {
    std::string text = fmt::format("{:<8} {:>9} {:>8} {:>11} {:>8}  {}\n", "verdict", "functions", "paths",
                                   "obligations", "time", "theorem");
    std::string area;
    for (const TheoremResult& one : results) {
        if (one.area != area) {
            area = one.area;
            text += fmt::format("{}\n", area);
        }
        text +=
            fmt::format("{:<8} {:>9} {:>8} {:>11} {:>6.1f} s  {}: {}{}\n", name_of(one.verdict), one.functions.size(),
                        paths_text(one.paths), one.obligations, one.seconds, one.name, one.statement,
                        one.requirements.empty() ? "" : fmt::format(" [{}]", fmt::join(one.requirements, " ")));
        append_details(text, one);
    }
    const auto kept = std::count_if(results.begin(), results.end(), [](const auto& one) { return one.is_kept; });
    if (kept != 0) {
        text +=
            fmt::format("{} verdict(s) kept from earlier runs of the same code, with the time of those runs\n", kept);
    }
    const auto resting =
        std::count_if(results.begin(), results.end(), [](const auto& one) { return one.rests_on_base; });
    if (resting != 0) {
        text += fmt::format(
            "{} of them rest on the theorems about src/firmware/base, which has changed and is proven\n", resting);
    }
    text += fmt::format("{} proven, {} refuted, {} unknown\n", count(results, Verdict::proven),
                        count(results, Verdict::refuted), count(results, Verdict::unknown));
    return text;
}

std::string json_text(const std::vector<TheoremResult>& results) {
    nlohmann::json all = nlohmann::json::array();
    for (const TheoremResult& one : results) {
        all.push_back(json_of(one));
    }
    const nlohmann::json document{{"theorems", all},
                                  {"proven", count(results, Verdict::proven)},
                                  {"refuted", count(results, Verdict::refuted)},
                                  {"unknown", count(results, Verdict::unknown)}};
    return document.dump(1) + "\n";
}

}  // namespace canproof::host::prove
