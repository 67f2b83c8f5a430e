// SPDX-License-Identifier: Apache-2.0
// `canproof audit`: the evidence for each item of the requirements register, and the gaps.
#pragma once

#include <string>

#include "host/assess/trace/audit_filter.hpp"

namespace canproof::host {

struct AuditOptions {
    std::string root{"."};
    std::string subject;  ///< device, id of an item, section, statement, source file or test; empty: everything
    std::string verdicts;
    AuditFilter filter;
    /// items, gaps, suspects (items that have changed since their review) and orphans (code or tests without a
    /// requirement) as JSON instead of lines
    bool json{false};
};

/// Prints the audit. Returns the exit status. It is 1 when an item is not proven by a passed test, has changed since
/// its review or has a failed test. It is also 1 when the audit finds another gap, such as code without a requirement.
/// It is always 0 for a list of conditions of use.
int audit(const AuditOptions& options);

}  // namespace canproof::host
