// The mark of a passage: which words of a manual are meant, without the words themselves.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace canproof::host {

/// `132:3f9a0c1b2d4e`: how many ASCII letters and digits a passage has, and the first 12 hexadecimal digits of the
/// SHA-256 of these, in lower case. Layout, punctuation and other characters do not count.
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

/// The ASCII letters and digits of a passage in lower case.
std::string reduced(const std::string& passage);

/// The mark of a passage. Of one without letters and digits it has the length 0, and no reader takes it.
Mark mark_of(const std::string& passage);

/// A mark as it is written; nothing when it is malformed.
std::optional<Mark> read_mark(const std::string& text);

}  // namespace canproof::host
