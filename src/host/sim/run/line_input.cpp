// SPDX-License-Identifier: Apache-2.0
#include "host/sim/run/line_input.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>

namespace canproof::host {

std::vector<std::string> LineInput::read_lines() {
    std::array<char, longest_line> piece{};
    const ssize_t count = read(descriptor_, piece.data(), piece.size());
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) {
        return {};
    }
    open_ = count > 0;
    pending_.append(piece.data(), count > 0 ? static_cast<std::size_t>(count) : 0U);
    if (!open_) {
        pending_ += '\n';
    }
    std::vector<std::string> lines;
    for (auto end = pending_.find('\n'); end != std::string::npos; end = pending_.find('\n')) {
        std::string line = pending_.substr(0, end);
        pending_.erase(0, end + 1);
        if (!line.empty() && line.back() == '\r') {
            line.pop_back();
        }
        if (!line.empty()) {
            lines.push_back(std::move(line));
        }
    }
    if (pending_.size() > longest_line) {
        pending_.clear();
    }
    return lines;
}

}  // namespace canproof::host
