// SPDX-License-Identifier: Apache-2.0
#include "host/assess/source/linked_function.hpp"

#include <algorithm>

namespace canproof::host {

namespace {

/// Returns the number of opening braces minus the number of closing braces.
int depth_of(const std::string& line) {
    return static_cast<int>(std::count(line.begin(), line.end(), '{')) -
           static_cast<int>(std::count(line.begin(), line.end(), '}'));
}

/// Returns the number of the line after the static_assert that begins at line `at`; returns `at` when none begins
/// there.
std::size_t behind_link(const std::vector<std::string>& lines, std::size_t at) {
    if (lines[at].find("static_assert(") == std::string::npos) {
        return at;
    }
    while (at < lines.size() && lines[at].find(';') == std::string::npos) {
        ++at;
    }
    return at + 1;
}

}  // namespace

std::pair<std::size_t, std::size_t> function_below(const std::vector<std::string>& lines, std::size_t link) {
    std::size_t first = link == 0 ? lines.size() : link - 1;
    // The static_assert may have several lines, and implements<> may be on any of them. This loop goes to the end of
    // the static_assert.
    while (first < lines.size() && lines[first].find(';') == std::string::npos) {
        ++first;
    }
    ++first;
    for (std::size_t next = first; first < lines.size(); first = next) {
        next = behind_link(lines, first);
        if (next == first) {
            break;
        }
    }
    int depth = 0;
    bool opened = false;
    for (std::size_t at = first; at < lines.size(); ++at) {
        depth += depth_of(lines[at]);
        opened = opened || lines[at].find('{') != std::string::npos;
        if (opened && depth <= 0) {
            return {first + 1, at + 1};
        }
    }
    return {0, 0};
}

}  // namespace canproof::host
