// SPDX-License-Identifier: Apache-2.0
// `canproof evidence`: makes missing evidence, writes the evidence pack, and verifies a pack.
#pragma once

#include <string>

namespace canproof::host {

struct EvidenceOptions {
    std::string root{"."};
    std::string out{"reports/out"};
    std::string verdicts;  ///< folder of test results; empty: the newest of build/{release,debug,coverage}/verdicts
    std::string coverage;  ///< coverage that tests/coverage measured; empty: build/coverage/coverage.json
    std::string exhibits;  ///< folder with the results of other tools (exhibits); empty: build/exhibits
    std::string key;       ///< file of a private key that signs the manifest; empty: no signature
    bool full{false};      ///< first makes the evidence that is absent, or older than a change of its sources
    bool json{false};
};

struct VerifyOptions {
    std::string pack{"reports/out"};
    std::string key;   ///< file of the public key; empty: checks the checksums only
    bool json{false};  ///< the faults as JSON instead of lines
};

/// Writes the pack and replaces the folder `out` as a whole. Returns the exit status: 1 when a step of --full fails.
int write_evidence(const EvidenceOptions& options);
/// Compares a pack with its manifest and, when a key is given, with its signature. Returns the exit status: 1 when they
/// differ.
int verify_evidence(const VerifyOptions& options);

}  // namespace canproof::host
