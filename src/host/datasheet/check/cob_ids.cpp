// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/check/cob_ids.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace canproof::host {

bool is_off(std::uint64_t cob_id) {
    return (cob_id & 0x80000000U) != 0;
}

bool is_extended(std::uint64_t cob_id) {
    return (cob_id & 0x20000000U) != 0;
}

unsigned identifier(const EdsNumber& cob_id, unsigned node_id) {
    return static_cast<unsigned>((cob_id.bits + (cob_id.node_id ? node_id : 0U)) & 0x7FFU);
}

bool is_reserved(unsigned identifier) {
    constexpr std::array<std::pair<unsigned, unsigned>, 7> ranges{{{0x000, 0x07F},
                                                                   {0x101, 0x180},
                                                                   {0x581, 0x5FF},
                                                                   {0x601, 0x67F},
                                                                   {0x6E0, 0x6FF},
                                                                   {0x701, 0x77F},
                                                                   {0x780, 0x7FF}}};
    return std::any_of(ranges.begin(), ranges.end(), [identifier](const auto& range) {
        return identifier >= range.first && identifier <= range.second;
    });
}

}  // namespace canproof::host
