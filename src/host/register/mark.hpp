// SPDX-License-Identifier: Apache-2.0
// The mark of a passage: it identifies words of a manual without containing them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace canproof::host {

/// `132:3f9a0c1b2d4e`: the number of ASCII letters and digits of a passage, and the first 12 hexadecimal digits of the
/// SHA-256 over these characters in lower case. Layout, punctuation and other characters do not count.
struct Mark {
    static constexpr std::size_t longest = 99999;
    static constexpr std::size_t hash_digits = 12;

    std::size_t length{0};  ///< 1 to `longest`
    std::string hash;

    std::string text() const { return std::to_string(length) + ":" + hash; }
    bool operator<(const Mark& other) const {
        return length != other.length ? length < other.length : hash < other.hash;
    }
    bool operator==(const Mark& other) const { return length == other.length && hash == other.hash; }
};

/// Returns the ASCII letters and digits of a passage in lower case.
std::string reduced(const std::string& passage);

/// Returns the mark of a passage. A passage without letters and digits has a mark of length 0, which read_mark()
/// refuses.
Mark mark_of(const std::string& passage);

/// Parses a mark; returns nothing for a malformed text.
std::optional<Mark> read_mark(const std::string& text);

}  // namespace canproof::host
