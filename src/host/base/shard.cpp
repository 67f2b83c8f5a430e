// SPDX-License-Identifier: Apache-2.0
#include "host/base/shard.hpp"

#include <fmt/format.h>

#include <charconv>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

/// Parses a whole number up to max_shards. Returns 0 for any other text.
std::size_t count_in(const std::string& text) {
    std::size_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && rest == end && number <= max_shards ? number : 0;
}

}  // namespace

std::string Shard::text() const {
    return fmt::format("{}/{}", number, count);
}

Shard parse_shard(const std::string& text) {
    const auto slash = text.find('/');
    const Shard shard{count_in(text.substr(0, slash)),
                      slash == std::string::npos ? 0 : count_in(text.substr(slash + 1))};
    if (shard.number == 0 || shard.count == 0 || shard.number > shard.count) {
        throw InputError{
            fmt::format("`{}` is not a shard; write 1/3 for the first of three shards; at most {} shards are allowed",
                        text, max_shards)};
    }
    return shard;
}

void require_all_shards(const std::vector<Shard>& shards, const std::vector<std::string>& names) {
    if (shards.empty()) {
        throw InputError{"there is no shard to merge; run `--shard 1/N` to `--shard N/N` first"};
    }
    const std::size_t count = shards.front().count;
    std::vector<std::string> found(count);
    for (std::size_t at = 0; at < shards.size(); ++at) {
        if (shards[at].count != count) {
            throw InputError{fmt::format("{} is shard {} and {} is shard {}; merge shards of one run", names.front(),
                                         shards.front().text(), names[at], shards[at].text())};
        }
        std::string& name = found[shards[at].number - 1];
        if (!name.empty()) {
            throw InputError{
                fmt::format("{} and {} are both shard {}; remove one of them", name, names[at], shards[at].text())};
        }
        name = names[at];
    }
    for (std::size_t at = 0; at < count; ++at) {
        if (found[at].empty()) {
            throw InputError{fmt::format("shard {} is missing; run `--shard {}` first", Shard{at + 1, count}.text(),
                                         Shard{at + 1, count}.text())};
        }
    }
}

void require_same_sources(const std::vector<std::string>& sources, const std::vector<std::string>& names) {
    for (std::size_t at = 0; at < sources.size(); ++at) {
        if (sources[at] != sources.front()) {
            throw InputError{fmt::format("{} and {} come from different sources; run all shards from one commit",
                                         names.front(), names[at])};
        }
    }
}

std::size_t size_of_share(std::size_t all, const Shard& shard) {
    return (all + shard.count - shard.number) / shard.count;
}

}  // namespace canproof::host
