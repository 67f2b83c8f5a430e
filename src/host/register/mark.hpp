// SPDX-License-Identifier: Apache-2.0
// The mark of a passage of a manual: a hash that identifies the words of the passage without containing them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace canproof::host {

/// A mark such as `132:3f9a0c1b2d4e`. It consists of the number of ASCII letters and digits in a passage, and of the
/// first 12 hexadecimal digits of the SHA-256 of these characters. Capital letters are converted to lower case first.
/// Layout, punctuation and other characters do not count.
struct Mark {
    static constexpr std::size_t longest = 99999;
    static constexpr std::size_t hash_digits = 12;

    std::size_t length{0};  ///< number of letters and digits, 1 to `longest`
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

/// Parses a mark. Returns nothing for a text in another form.
std::optional<Mark> read_mark(const std::string& text);

}  // namespace canproof::host
