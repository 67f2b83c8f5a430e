// SPDX-License-Identifier: Apache-2.0
// The parameters of one PDO of the conformance slave and the rules for writing them (CiA 301, 7.5.2.35 to 7.5.2.38).
// The model knows which objects are mappable. It requires this order: make the PDO invalid, set sub-index 0 to 0, write
// the mapping entries, set sub-index 0 to their number, make the PDO valid. Shares no code with the firmware.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "properties/support/naive_pdo.hpp"

namespace canproof::naive_mapping {

using naive_pdo::Mappable;

// The results of a write: 0 when it is accepted, otherwise the abort code.
constexpr std::uint32_t done = 0;
constexpr std::uint32_t present_state = 0x08000022;
constexpr std::uint32_t too_high = 0x06090031;
constexpr std::uint32_t object_missing = 0x06020000;
constexpr std::uint32_t subindex_missing = 0x06090011;
constexpr std::uint32_t cannot_be_mapped = 0x06040041;
constexpr std::uint32_t longer_than_a_pdo = 0x06040042;

class Pdo {
  public:
    explicit Pdo(bool receives) : receives_{receives} {}

    std::uint32_t write_cob_id(unsigned identifier, bool valid) {
        if (valid_ && valid && identifier != identifier_) {
            return present_state;
        }
        valid_ = valid;
        identifier_ = identifier;
        return done;
    }
    std::uint32_t write_line(unsigned subindex, const Mappable& line) {
        if (subindex > lines_.size()) {
            return subindex_missing;
        }
        if (valid_ || count_ != 0) {
            return present_state;
        }
        const std::uint32_t refusal = is_empty(line) ? done : refusal_of(line);
        if (refusal == done) {
            lines_[subindex - 1] = line;
        }
        return refusal;
    }
    std::uint32_t write_count(unsigned count) {
        if (count > lines_.size()) {
            return too_high;
        }
        if (valid_) {
            return present_state;
        }
        naive_pdo::Mapping counted(lines_.begin(), lines_.begin() + count);
        if (std::any_of(counted.begin(), counted.end(), is_empty)) {
            return cannot_be_mapped;
        }
        if (naive_pdo::total_bits(counted) > 64) {
            return longer_than_a_pdo;
        }
        count_ = count;
        return done;
    }

    bool is_valid() const { return valid_; }
    unsigned count() const { return count_; }
    unsigned identifier() const { return identifier_; }
    const std::array<Mappable, 8>& lines() const { return lines_; }
    /// Returns the length of the PDO's frame in bytes.
    unsigned length() const { return naive_pdo::total_bytes({lines_.begin(), lines_.begin() + count_}); }

  private:
    static bool is_empty(const Mappable& line) { return line.index == 0 && line.subindex == 0 && line.bits == 0; }

    /// Returns 0 if a mapping entry is allowed, otherwise the abort code. An RPDO may map 2000h, 2002h and 2100h,
    /// a TPDO may map 2001h, 2003h and 2101h, and both may map 2206h and 2207h.
    std::uint32_t refusal_of(const Mappable& line) const {
        if (line.index < 0x1000) {
            constexpr std::array<unsigned, 8> dummy_bits{0, 1, 8, 16, 32, 8, 16, 32};
            const bool fits =
                line.index <= 7 && line.subindex == 0 && line.bits != 0 && line.bits == dummy_bits[line.index];
            return line.index > 7 ? object_missing : fits && receives_ ? done : cannot_be_mapped;
        }
        const unsigned family = line.index & ~1U;
        const unsigned bits = family == 0x2000 ? 8 : family == 0x2002 ? 1 : family == 0x2100 ? 16 : 0;
        if (bits != 0) {
            const unsigned subindices = family == 0x2100 ? 4 : 8;
            const bool direction = ((line.index & 1U) == 0) == receives_;
            return line.subindex > subindices                             ? subindex_missing
                   : line.subindex != 0 && line.bits == bits && direction ? done
                                                                          : cannot_be_mapped;
        }
        const bool both = line.index == 0x2207 || line.index == 0x2206;
        const unsigned wide = line.index == 0x2207 ? 32 : 64;
        if (both) {
            return line.subindex != 0 ? subindex_missing : line.bits == wide ? done : cannot_be_mapped;
        }
        return line.index == 0x1017 && line.subindex == 0 ? cannot_be_mapped : object_missing;
    }

    bool receives_;
    bool valid_{false};
    unsigned identifier_{0};
    unsigned count_{0};
    std::array<Mappable, 8> lines_{};
};

}  // namespace canproof::naive_mapping
