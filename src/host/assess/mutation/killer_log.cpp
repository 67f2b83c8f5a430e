// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/killer_log.hpp"

#include "host/base/reading.hpp"

namespace canproof::host {

namespace {

/// Returns the key of a mutant. It does not contain the mutant's line number, because each edit above that line changes
/// it.
std::string key_of(const std::string& file, const std::string& place, const std::string& change) {
    return file + "\t" + place.substr(0, place.rfind(", line ")) + "\t" + change;
}

bool holds(const std::string& filter, const std::string& test) {
    return (":" + filter + ":").find(":" + test + ":") != std::string::npos;
}

}  // namespace

KillerLog::KillerLog(const std::filesystem::path& file) {
    std::ifstream in{file};
    for (std::string line; std::getline(in, line);) {
        const auto parts = tab_separated(line);
        // Skips a line without the name of a test: a signal ended the process with this mutant.
        if (parts.size() == 4 && parts[3].find('.') != std::string::npos) {
            std::string& filter = filters_[key_of(parts[0], parts[1], parts[2])];
            if (!holds(filter, parts[3])) {
                filter += (filter.empty() ? "" : ":") + parts[3];
            }
        }
    }
    check_read(in, file.string());
    out_.open(file, std::ios::app);
}

std::string KillerLog::filter(const AlteredCell& mutant) const {
    const auto found = filters_.find(key_of(mutant.item, mutant.cell, mutant.change));
    return found == filters_.end() ? "" : found->second;
}

void KillerLog::note(const MutationOutcome& outcome) {
    const std::scoped_lock lock{writing_};
    out_ << outcome.cell.item << '\t' << outcome.cell.cell << '\t' << outcome.cell.change << '\t' << outcome.killed_by
         << std::endl;
}

}  // namespace canproof::host
