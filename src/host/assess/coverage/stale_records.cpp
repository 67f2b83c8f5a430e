// SPDX-License-Identifier: Apache-2.0
// Compares the records of reports/coverage.toml with the sources, without a measurement.
#include "host/assess/coverage/stale_records.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "host/assess/coverage/coverage_records.hpp"
#include "host/base/reading.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

/// Returns the text with one space for every run of spaces and line breaks, as in the text of a coverage gap.
std::string on_one_line(std::istream& in) {
    std::string text;
    for (std::string word; in >> word;) {
        text += (text.empty() ? "" : " ") + word;
    }
    return text;
}

/// Returns the file `place`, or all files below it when it is a folder.
std::vector<fs::path> sources_of(const fs::path& place) {
    std::vector<fs::path> files;
    if (fs::is_directory(place)) {
        for (const auto& entry : fs::recursive_directory_iterator{place}) {
            if (entry.is_regular_file()) {
                files.push_back(entry.path());
            }
        }
    } else if (fs::is_regular_file(place)) {
        files.push_back(place);
    }
    return files;
}

/// Returns the text that the source must contain for the record to be valid: the record's code, or `curve(` for the
/// function `canproof::curve`.
std::string written(const CoverageRecord& record) {
    if (record.kind != "function") {
        std::istringstream code{record.code};
        return on_one_line(code);
    }
    const auto scope = record.code.rfind(':');
    return record.code.substr(scope == std::string::npos ? 0 : scope + 1) + "(";
}

}  // namespace

std::vector<CoverageRecord> stale_records(const std::vector<CoverageRecord>& records, const fs::path& root) {
    std::vector<CoverageRecord> stale;
    std::copy_if(records.begin(), records.end(), std::back_inserter(stale), [&root](const CoverageRecord& record) {
        const std::vector<fs::path> files = sources_of(root / record.file);
        const std::string code = written(record);
        return std::none_of(files.begin(), files.end(), [&code](const fs::path& file) {
            std::ifstream in{file};
            const std::string text = on_one_line(in);
            check_read(in, file.string());
            return text.find(code) != std::string::npos;
        });
    });
    return stale;
}

}  // namespace canproof::host
