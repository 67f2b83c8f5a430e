// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/code_exhibit.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/assess/mutation/mutation_counts.hpp"
#include "host/assess/mutation/mutation_table.hpp"
#include "host/base/csv_line.hpp"

namespace canproof::host {

namespace {

std::string reason_of(const MutationOutcome& outcome) {
    if (outcome.record != nullptr) {
        return outcome.record->reason;
    }
    return outcome.claimed ? "open" : "open: the mutant changes no computation in any test";
}

std::string sentence(const char* of_what, const MutationCount& count) {
    return fmt::format("{} mutants of {}, {:.1f} % noticed by a test; {} survive without a reason.", count.altered,
                       of_what, count.share_noticed(), count.open());
}

std::string survivors_csv(const std::vector<MutationOutcome>& outcomes) {
    std::string text = csv_line({"file", "place", "change", "reason"});
    for (const MutationOutcome& outcome : outcomes) {
        if (outcome.killed_by.empty()) {
            text += csv_line({outcome.cell.item, outcome.cell.cell, outcome.cell.change, reason_of(outcome)});
        }
    }
    return text;
}

std::string files_csv(const CountsByItem& counts) {
    std::string text = csv_line({"file", "altered", "noticed", "with a reason"});
    for (const auto& [file, count] : counts) {
        text += csv_line(
            {file, std::to_string(count.altered), std::to_string(count.noticed), std::to_string(count.justified)});
    }
    return text;
}

}  // namespace

std::map<std::string, std::string> code_exhibit(const std::vector<MutationOutcome>& outcomes) {
    const CountsByItem counts = count_by_item(outcomes);
    const MutationCount all = total_of(counts, false);
    const MutationCount host = total_of(counts, true);
    nlohmann::ordered_json exhibit{{"title", "Mutation of the firmware's code"},
                                   {"state", all.open() + host.open() == 0 ? "holds" : "open"},
                                   {"says", sentence("the firmware", all)},
                                   {"figures",
                                    {{"mutants", all.altered},
                                     {"noticed by a test", all.noticed},
                                     {"survive with a reason", all.justified},
                                     {"survive without a reason", all.open()}}}};
    if (host.altered != 0) {
        exhibit["says"] = sentence("the firmware", all) + " " + sentence("the host's buses and replay", host);
        exhibit["figures"]["mutants of the host"] = host.altered;
        exhibit["figures"]["mutants of the host noticed by a test"] = host.noticed;
        exhibit["figures"]["surviving mutants of the host program with a recorded reason"] = host.justified;
        exhibit["figures"]["surviving mutants of the host program without a recorded reason"] = host.open();
    }
    return {{"exhibit.json", exhibit.dump(1) + "\n"},
            {"survivors.csv", survivors_csv(outcomes)},
            {"files.csv", files_csv(counts)},
            {"operators.csv", operators_csv(outcomes)}};
}

}  // namespace canproof::host
