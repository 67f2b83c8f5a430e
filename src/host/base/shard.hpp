// SPDX-License-Identifier: Apache-2.0
// A part of a list of work that several machines share: `2/3` is the second of three parts. Element k of the list,
// counted from 0, belongs to part k mod 3 + 1, so that long and short tasks spread evenly.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace canproof::host {

struct Shard {
    std::size_t number{1};  ///< from 1 to count
    std::size_t count{1};   ///< from 1 to max_shards

    /// Returns the shard as text: `2/3`.
    std::string text() const;
    /// Returns whether the element at position `place`, counted from 0, belongs to this shard.
    bool holds(std::size_t place) const { return place % count == number - 1; }
};

constexpr std::size_t max_shards = 10'000;

/// Parses a text such as `2/3`. Throws InputError for any other text, and when the number is larger than the count.
Shard parse_shard(const std::string& text);

/// Throws InputError unless the shards are 1/n to n/n, each once. `names` contains the origin of each shard, for the
/// message.
void require_all_shards(const std::vector<Shard>& shards, const std::vector<std::string>& names);

/// Throws InputError unless all shards come from the same sources. `sources` contains the source_hash() of each shard,
/// `names` its origin.
void require_same_sources(const std::vector<std::string>& sources, const std::vector<std::string>& names);

/// Sorts elements by the number in their member `shard`, then by their member `name`.
template <typename Read>
void sort_shards(std::vector<Read>& all) {
    std::sort(all.begin(), all.end(), [](const Read& a, const Read& b) {
        return std::tie(a.shard.number, a.name) < std::tie(b.shard.number, b.name);
    });
}

/// Throws InputError unless the elements belong to the shards 1/n to n/n, one to each, of the same sources. An element
/// has the members `shard`, `name` (its origin) and `sources` (the source_hash() of the tree that made it).
template <typename Read>
void require_all_shards(const std::vector<Read>& all) {
    std::vector<Shard> shards;
    std::vector<std::string> names;
    std::vector<std::string> sources;
    for (const Read& one : all) {
        shards.push_back(one.shard);
        names.push_back(one.name);
        sources.push_back(one.sources);
    }
    require_all_shards(shards, names);
    require_same_sources(sources, names);
}

/// Returns the elements that belong to a shard, in their original order.
template <typename T>
std::vector<T> share_of(const std::vector<T>& all, const Shard& shard) {
    std::vector<T> share;
    for (std::size_t place = shard.number - 1; place < all.size(); place += shard.count) {
        share.push_back(all[place]);
    }
    return share;
}

/// Returns how many of `all` elements belong to a shard.
std::size_t size_of_share(std::size_t all, const Shard& shard);

}  // namespace canproof::host
