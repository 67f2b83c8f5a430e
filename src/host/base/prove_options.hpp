// SPDX-License-Identifier: Apache-2.0
// The options of `canproof prove`. Both canproof, for its shell completion, and canproof-prove, which it starts, use
// this list.
#pragma once

#include <array>
#include <string_view>

namespace canproof::host {

struct ProveOption {
    const char* name;
    bool takes_value;
    const char* help;
};

inline constexpr std::array<ProveOption, 16> prove_options{{
    {"--only", true, "proofs of this folder below properties/proofs, such as base"},
    {"--proofs", true, "folder of harnesses"},
    {"--theorem", true, "this one alone"},
    {"--timeout", true, "seconds of processor time for one theorem; unknown after that"},
    {"--jobs", true, "processes at once"},
    {"--json", true, "file to write the results to"},
    {"--out", true, "folder to write the table to, for the evidence pack: build/exhibits/proofs"},
    {"--xml", true, "file to write verdicts to, for the audit: build/NAME/verdicts/proofs.xml"},
    {"--shard", true, "I/N: only part I of N of the theorems; --json for --merge"},
    {"--merge", true, "folder of the JSON files of all shards, in place of proving"},
    {"--faults", true, "table of seeded faults: each must be refuted"},
    {"--every", true, "with --faults: only every Nth of the table"},
    {"--seeds", true, "folder of corpora, such as fuzz/corpus: counterexamples go there as inputs of fuzz targets"},
    {"--no-replay", false, "do not run counterexamples natively"},
    {"--root", true, "the project's folder"},
    {"--build", true, "a build of the project; where canproof-prove lies without it"},
}};

/// Returns the help text of an option; an empty text for a name that is not in the list.
constexpr const char* help_of_prove_option(std::string_view name) {
    for (const ProveOption& one : prove_options) {
        if (one.name == name) {
            return one.help;
        }
    }
    return "";
}

}  // namespace canproof::host
