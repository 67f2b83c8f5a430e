// SPDX-License-Identifier: Apache-2.0
#include "host/prove/contracts.hpp"

#include <algorithm>
#include <set>

namespace canproof::host::prove {

namespace {

using Names = std::set<std::string>;

/// Returns the first theorem which proves a contract that `one` uses, and which is not in `accepted`; nullptr if there
/// is none.
const std::string* first_missing(const TheoremResult& one, const Names& accepted) {
    const auto missing = std::find_if(one.used_theorems.begin(), one.used_theorems.end(),
                                      [&](const std::string& name) { return accepted.count(name) == 0; });
    return missing == one.used_theorems.end() ? nullptr : &*missing;
}

/// Returns the names of theorems that no result has, and that other theorems use.
Names not_selected(const std::vector<TheoremResult>& results) {
    Names names;
    for (const TheoremResult& one : results) {
        names.insert(one.used_theorems.begin(), one.used_theorems.end());
    }
    for (const TheoremResult& one : results) {
        names.erase(one.name);
    }
    return names;
}

}  // namespace

void check_contracts(std::vector<TheoremResult>& results, bool has_all) {
    const Names assumed = has_all ? Names{} : not_selected(results);
    Names accepted = assumed;
    for (bool grows = true; grows;) {  // theorems that use each other in a circle are never accepted
        grows = false;
        for (const TheoremResult& one : results) {
            if (one.verdict == Verdict::proven && first_missing(one, accepted) == nullptr) {
                grows = accepted.insert(one.name).second || grows;
            }
        }
    }
    for (TheoremResult& one : results) {
        const std::string* missing = first_missing(one, accepted);
        if (one.verdict == Verdict::proven && missing != nullptr) {
            one.verdict = Verdict::unknown;
            one.reason = "uses a contract that is not proven: theorem " + *missing;
        }
        for (const std::string& name : one.used_theorems) {
            if (assumed.count(name) != 0) {
                one.assumptions.push_back("the contract that theorem " + name + " proves, which this run leaves out");
            }
        }
    }
}

}  // namespace canproof::host::prove
