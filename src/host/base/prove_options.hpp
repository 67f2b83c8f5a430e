// SPDX-License-Identifier: Apache-2.0
// The options of `canproof prove`. canproof-prove parses them. canproof, which starts canproof-prove, uses the list for
// its shell completion.
#pragma once

#include <array>
#include <string_view>

namespace canproof::host {

struct ProveOption {
    const char* name;
    bool takes_value;
    const char* help;
};

inline constexpr std::array<ProveOption, 18> prove_options{{
    {"--only", true, "prove only the theorems of this folder below properties/proofs, such as base"},
    {"--proofs", true, "folder with the proof harnesses"},
    {"--long", false, "prove the theorems of the folders *_long, too, most of which take a minute or more"},
    {"--theorem", true, "name of the only theorem to prove"},
    {"--timeout", true, "seconds of processor time for one theorem; after this time, the result is `unknown`"},
    {"--jobs", true, "number of processes that run at the same time"},
    {"--json", true, "file to write the results to"},
    {"--out", true, "folder to write the table to, for the evidence pack: build/exhibits/proofs"},
    {"--xml", true, "file to write verdicts to, for the audit: build/NAME/verdicts/proofs.xml"},
    {"--shard", true, "I/N: prove only part I of N of the theorems; write the results with --json for --merge"},
    {"--merge", true, "read the JSON files of all shards from this folder and prove nothing"},
    {"--faults", true, "table of seeded faults; each fault must make canproof-prove refute a theorem"},
    {"--every", true, "with --faults: use only every Nth fault of the table"},
    {"--seeds", true, "write counterexamples as inputs of fuzz targets to this folder, such as fuzz/corpus"},
    {"--kept", true, "folder with the verdicts of earlier runs: decide only theorems whose code has changed"},
    {"--no-replay", false, "do not run counterexamples natively"},
    {"--root", true, "the project's folder"},
    {"--build", true, "build folder of the project; without it, the folder that contains canproof-prove"},
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
