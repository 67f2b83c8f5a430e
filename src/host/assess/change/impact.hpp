// What a change touches: items, the decisions, code and tests linked to them, and verdicts.
#pragma once

#include <string>
#include <vector>

#include "host/assess/change/register_diff.hpp"
#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

struct VerdictChange {
    std::string id;
    std::string before;  ///< passed, failed or none
    std::string after;
};

/// Items whose tests as a whole went from one to another of passed, failed, none.
std::vector<VerdictChange> verdict_changes(const Evidence& before, const Evidence& after);

struct Impact {
    std::vector<ItemChange> items;
    std::vector<std::string> files;  ///< of code and tests
    std::vector<VerdictChange> verdicts;
};

/// Each change with what is linked to it, as text.
std::string write_impact(const Impact& impact, const Register& content, const Evidence& evidence);

/// The same changes as JSON.
std::string impact_json(const Impact& impact);

}  // namespace canproof::host
