// SPDX-License-Identifier: Apache-2.0
#include "host/assess/manual/find_marks.hpp"

#include <fmt/format.h>

#include <string_view>

#include "host/base/sha256.hpp"

namespace canproof::host {

namespace {

using Places = std::map<Mark, std::vector<std::size_t>>;

/// The marks (hashes) of all passages of one length; the key is the hash as a number.
using ByHash = std::map<std::uint64_t, Mark>;

std::map<std::size_t, ByHash> by_length(const std::set<Mark>& marks) {
    std::map<std::size_t, ByHash> all;
    constexpr int hexadecimal = 16;
    for (const Mark& mark : marks) {
        all[mark.length][std::stoull(mark.hash, nullptr, hexadecimal)] = mark;
    }
    return all;
}

enum class Ends { at_words, anywhere };

/// Adds to `places` the positions at which the passages of the marks begin. At each start of a word, hashes the text
/// that begins there, once for each length of a passage. Computes each hash in full, because SHA-256 cannot be updated
/// for a moved passage.
void search(const ManualText& text, const std::set<Mark>& marks, const Ends ends, Places& places) {
    const auto lengths = by_length(marks);
    const std::string_view whole{text.letters()};
    Sha256 hash;
    for (const std::size_t begin : text.word_begins()) {
        for (const auto& [length, known] : lengths) {
            if (begin + length > whole.size()) {
                break;
            }
            if (ends == Ends::at_words && !text.is_word_end(begin + length)) {
                continue;
            }
            const auto found = known.find(hash.first_bytes(whole.substr(begin, length), Mark::hash_digits / 2));
            if (found != known.end()) {
                places[found->second].push_back(begin);
            }
        }
    }
}

}  // namespace

Places find_marks(const ManualText& text, const std::set<Mark>& marks) {
    Places places;
    search(text, marks, Ends::at_words, places);
    std::set<Mark> left;
    for (const Mark& mark : marks) {
        if (places.count(mark) == 0) {
            left.insert(mark);
        }
    }
    search(text, left, Ends::anywhere, places);
    return places;
}

}  // namespace canproof::host
