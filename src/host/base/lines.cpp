// SPDX-License-Identifier: Apache-2.0
#include "host/base/lines.hpp"

#include <algorithm>

#include "host/base/read_file.hpp"

namespace canproof::host {

std::vector<std::string> split_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const auto end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

std::vector<std::string> read_lines(const std::filesystem::path& path) {
    return split_lines(read_file(path));
}

}  // namespace canproof::host
