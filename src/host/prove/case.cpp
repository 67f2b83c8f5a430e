// SPDX-License-Identifier: Apache-2.0
#include "host/prove/case.hpp"

#include <fmt/format.h>

namespace canproof::host::prove {

unsigned Case::number(std::size_t place, unsigned count) {
    if (place == digits_.size()) {
        digits_.push_back({0U, count});
    }
    return digits_[place].number;
}

bool Case::next() {
    while (!digits_.empty()) {
        Digit& last = digits_.back();
        if (++last.number < last.count) {
            return true;
        }
        digits_.pop_back();
    }
    return false;
}

std::string Case::text() const {
    std::string text;
    for (const Digit& one : digits_) {
        text += fmt::format("{}{} of {}", text.empty() ? "" : ", ", one.number, one.count);
    }
    return text;
}

}  // namespace canproof::host::prove
