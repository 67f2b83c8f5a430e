// SPDX-License-Identifier: Apache-2.0
// `canproof audit`: the evidence for each item of the requirements register, and the gaps.
#pragma once

#include <string>

#include "host/assess/trace/audit_filter.hpp"

namespace canproof::host {

struct AuditOptions {
    std::string root{"."};
    std::string subject;  ///< device, id, section, statement, source file or test; empty: everything
    std::string verdicts;
    AuditFilter filter;
    bool json{false};  ///< items, gaps, suspects and orphans as JSON instead of lines
};

/// Prints the audit. Returns the exit status: 1 when something is open, suspect, failed or not shown; always 0 for a
/// list of conditions of use.
int audit(const AuditOptions& options);

}  // namespace canproof::host
