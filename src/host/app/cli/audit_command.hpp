// `canproof audit`: what shows each item of the register, and what is missing.
#pragma once

#include <string>

#include "host/assess/trace/audit_filter.hpp"

namespace canproof::host {

struct AuditOptions {
    std::string root{"."};
    std::string subject;  ///< device, id, section, statement, source file, test or nothing
    std::string verdicts;
    AuditFilter filter;
    bool json{false};  ///< items, gaps, suspects and orphans as JSON instead of lines
};

/// 1 when something is open. Returns the exit status.
int audit(const AuditOptions& options);

}  // namespace canproof::host
