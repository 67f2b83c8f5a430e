// SPDX-License-Identifier: Apache-2.0
// `canproof spec check` and `canproof spec statements`: faults of the requirements register, and the statements of a
// manual.
#pragma once

#include <string>

namespace canproof::host {

struct SpecCheckOptions {
    std::string spec{"spec"};
    bool strict{false};  ///< a warning causes exit status 1, as a fault does
    bool json{false};    ///< faults and warnings as JSON instead of lines
};

/// Prints every fault and warning of the requirements register in the folder `options.spec`. Returns the exit status: 1
/// when there is a fault or, with `strict`, a warning.
int check_spec(const SpecCheckOptions& options);

struct StatementsOptions {
    std::string key;   ///< key of the manual in the requirements register, such as AX130751
    std::string text;  ///< file with the manual's text; empty: no comparison
    std::string spec{"spec"};
};

/// Prints the statements (demands) of a manual by section. Returns the exit status: 1 when a statement has neither an
/// item nor a reason, or when a normative section has no statement. With `text`, prints instead the statements'
/// passages that the manual's text does not contain (each named by its mark, a hash), and the text that no statement
/// covers. Then returns 1 when a passage is not in the text.
int list_statements(const StatementsOptions& options);

}  // namespace canproof::host
