// Which test noticed a mutant last time: asked first the next time, it spares most of the others. No verdict rests on
// it.
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
    /// Reads what earlier runs left in the file, and goes on with it. Lines `file TAB place TAB change TAB test`.
    explicit KillerLog(const std::filesystem::path& file);

    /// Tests that noticed this mutant, or one of the same change in its function, as a filter of GoogleTest; empty when
    /// none is known.
    std::string filter(const AlteredCell& mutant) const;
    /// Thread-safe.
    void note(const MutationOutcome& outcome);

  private:
    std::map<std::string, std::string> filters_;
    std::ofstream out_;
    std::mutex writing_;
};

}  // namespace canproof::host
