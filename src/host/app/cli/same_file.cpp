// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/same_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

bool same_file(const std::string& one, const std::string& other) {
    std::error_code none;
    if (fs::exists(one, none) || fs::exists(other, none)) {
        return fs::is_regular_file(one, none) && fs::equivalent(one, other, none);
    }
    return fs::weakly_canonical(fs::absolute(one), none) == fs::weakly_canonical(fs::absolute(other), none);
}

}  // namespace

void refuse_same_file(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
    std::vector<std::string> taken = inputs;
    taken.insert(taken.end(), {"/proc/self/fd/0", "/proc/self/fd/1", "/proc/self/fd/2"});
    for (const std::string& output : outputs) {
        if (output.empty()) {
            continue;
        }
        if (std::any_of(taken.begin(), taken.end(),
                        [&](const auto& one) { return !one.empty() && same_file(output, one); })) {
            throw InputError{
                fmt::format("{} is named twice, as an output and as another file; name another file to write", output)};
        }
        taken.push_back(output);
    }
}

}  // namespace canproof::host
