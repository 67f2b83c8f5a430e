// `canproof evidence`: makes what is missing, writes the evidence pack, verifies one.
#pragma once

#include <string>

namespace canproof::host {

struct EvidenceOptions {
    std::string root{"."};
    std::string out{"reports/out"};
    std::string verdicts;  ///< folders and files; where the builds leave them when empty
    std::string coverage;
    std::string exhibits;
    std::string key;   ///< file of a private key that signs the manifest; empty: not signed
    bool full{false};  ///< what is absent or stale is made first
    bool json{false};
};

struct VerifyOptions {
    std::string pack{"reports/out"};
    std::string key;  ///< file of the public key; empty: sums alone
};

/// Replaces the folder `out` as a whole. Returns the exit status: 1 when a step of --full fails.
int write_evidence(const EvidenceOptions& options);
/// Holds a pack against its manifest and its signature. Returns 1 when they differ.
int verify_evidence(const VerifyOptions& options);

}  // namespace canproof::host
