// `canproof spec check` and `canproof spec statements`.
#pragma once

#include <string>

namespace canproof::host {

struct SpecCheckOptions {
    std::string spec{"spec"};
    bool strict{false};  ///< warnings end with 1 as faults do
    bool json{false};    ///< faults and warnings as JSON instead of lines
};

/// Every fault and warning of the register in this folder; 1 when there is a fault. Returns the exit status.
int check_spec(const SpecCheckOptions& options);

struct StatementsOptions {
    std::string key;   ///< of the manual
    std::string text;  ///< a text version of the manual; empty: the statements alone
    std::string spec{"spec"};
};

/// The statements of a manual by section: 1 when one is open, or a normative section has none. With a text of the
/// manual: the marks that are not in it and the text that no statement covers; 1 when a mark is not in it.
int list_statements(const StatementsOptions& options);

}  // namespace canproof::host
