// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/campaign_files.hpp"

#include <algorithm>

#include "host/base/read_file.hpp"

namespace canproof::host {

TargetRecord& CampaignContext::record(const std::string& target) const {
    return *std::find_if(state.targets.begin(), state.targets.end(),
                         [&](const TargetRecord& one) { return one.name == target; });
}

std::map<std::string, std::string> fuzzer_environment(const CampaignFiles& files) {
    std::filesystem::create_directories(files.scratch());
    std::map<std::string, std::string> all{{"TMPDIR", files.scratch().string()},
                                           {"UBSAN_OPTIONS", "print_stacktrace=1"}};
    if (const char* const symbolizer = "/usr/bin/llvm-symbolizer-19"; std::filesystem::exists(symbolizer)) {
        all["ASAN_SYMBOLIZER_PATH"] = symbolizer;
        all["UBSAN_SYMBOLIZER_PATH"] = symbolizer;
    }
    return all;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder)) {
        for (const auto& entry : std::filesystem::directory_iterator{folder}) {
            if (entry.is_regular_file()) {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string read_text(const std::filesystem::path& file) {
    return std::filesystem::exists(file) ? read_file(file) : "";
}

}  // namespace canproof::host
