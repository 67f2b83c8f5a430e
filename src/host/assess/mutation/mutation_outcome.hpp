// SPDX-License-Identifier: Apache-2.0
// The outcome of one alteration: the test that noticed it, or the record that explains why none did.
#pragma once

#include <string>

#include "host/assess/mutation/test_server.hpp"

namespace canproof::host {

/// A record of reports/mutation.toml: the reason why some alterations may survive. `item`, `cell` and `change` may
/// contain the wildcards * and ?.
struct SurvivorRecord {
    std::string item;
    std::string cell;
    std::string change;
    std::string reason;
    unsigned line{0};
};

struct MutationOutcome {
    AlteredCell cell;
    std::string killed_by;  ///< the failing test, or how the process ended; empty: the alteration survived
    bool claimed{false};    ///< whether at least one test verifies the item of the cell
    const SurvivorRecord* record{nullptr};  ///< the record that explains why the alteration survives; nullptr: none
    std::string killer_file{};              ///< source file of the test in `killed_by`; empty: unknown
    bool open() const { return killed_by.empty() && record == nullptr; }
};

}  // namespace canproof::host
