// What came of one alteration.
#pragma once

#include <string>

#include "host/assess/mutation/test_server.hpp"

namespace canproof::host {

/// Why alterations may survive: a record of reports/mutation.toml. `item` and `cell` may hold * and ?.
struct SurvivorRecord {
    std::string item;
    std::string cell;
    std::string change;
    std::string reason;
    unsigned line{0};
};

struct MutationOutcome {
    AlteredCell cell;
    std::string killed_by;                  ///< a test, or how it died; empty: survived
    bool claimed{false};                    ///< some test claims the item
    const SurvivorRecord* record{nullptr};  ///< why it may survive
    std::string killer_file{};              ///< source of that test; empty: not known
    bool open() const { return killed_by.empty() && record == nullptr; }
};

}  // namespace canproof::host
