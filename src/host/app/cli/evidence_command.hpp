// `canproof evidence`: writes the evidence pack.
#pragma once

#include <string>

namespace canproof::host {

struct EvidenceOptions {
    std::string root{"."};
    std::string out{"reports/out"};
    std::string verdicts;  ///< folders and files; where the builds leave them when empty
    std::string coverage;
    std::string exhibits;
};

/// Replaces the folder `out` as a whole. Returns the exit status.
int write_evidence(const EvidenceOptions& options);

}  // namespace canproof::host
