// SPDX-License-Identifier: Apache-2.0
#include "host/assess/manual/manual_text.hpp"

#include "host/base/lines.hpp"
#include "host/register/mark.hpp"

namespace canproof::host {

std::string without_markup(const std::string& line) {
    std::size_t at = 0;
    while (at < line.size()) {
        if (line.compare(at, 3, "<b>") == 0) {
            at += 3;
        } else if (std::string{"#* \t"}.find(line[at]) != std::string::npos) {
            ++at;
        } else {
            break;
        }
    }
    return line.substr(at);
}

ManualText::ManualText(const std::string& text) : lines_{split_lines(text)} {
    word_end_.push_back(false);
    for (const std::string& line : lines_) {
        line_begins_.push_back(letters_.size());
        bool within = false;
        for (const char c : line) {
            const std::string kept = reduced(std::string(1, c));
            if (!kept.empty() && !within) {
                word_begins_.push_back(letters_.size());
            } else if (kept.empty() && within) {
                word_end_.back() = true;
            }
            within = !kept.empty();
            if (within) {
                letters_ += kept;
                word_end_.push_back(false);
            }
        }
        word_end_.back() = word_end_.back() || within;
    }
    line_begins_.push_back(letters_.size());
}

}  // namespace canproof::host
