// SPDX-License-Identifier: Apache-2.0
// Verdicts of earlier runs, for theorems whose code is the same.
#pragma once

#include <filesystem>
#include <optional>

#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// A folder with two files for each proven theorem; their names are the two hashes of the theorem's code
/// (code_hash.hpp). Without a folder, nothing is found and nothing is kept.
class KeptVerdicts {
  public:
    explicit KeptVerdicts(std::filesystem::path folder) : folder_{std::move(folder)} {}

    /// Returns the result of an earlier run, marked as kept. A file that cannot be read counts as absent.
    std::optional<TheoremResult> find(const std::string& code) const;
    /// Keeps a proven result. Other results are not kept, because more time may decide them.
    void keep(const std::string& code, const TheoremResult& result) const;
    bool is_used() const { return !folder_.empty(); }

  private:
    std::filesystem::path place_of(const std::string& code) const { return folder_ / (code + ".json"); }

    std::filesystem::path folder_;
};

}  // namespace canproof::host::prove
