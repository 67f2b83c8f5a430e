// SPDX-License-Identifier: Apache-2.0
// Records which test noticed each mutant. The next run starts with this test and so rarely needs other tests. No result
// depends on the record.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <string>

#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/assess/mutation/test_server.hpp"

namespace canproof::host {

class KillerLog {
  public:
    /// Reads the results of earlier runs from the file and opens it for appending. Each line contains file, place,
    /// change and test, separated by tabs.
    explicit KillerLog(const std::filesystem::path& file);

    /// Returns, as a GoogleTest filter, the tests that noticed this mutant, or a mutant with the same change in the
    /// same function. Returns an empty text when the record contains none.
    std::string filter(const AlteredCell& mutant) const;
    /// Appends the outcome of a mutant to the file. Several threads may call this function at the same time.
    void note(const MutationOutcome& outcome);

  private:
    std::map<std::string, std::string> filters_;
    std::ofstream out_;
    std::mutex writing_;
};

}  // namespace canproof::host
