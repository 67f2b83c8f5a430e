// SPDX-License-Identifier: Apache-2.0
// The objects of the naive SDO server: values in containers, access rights, and the abort codes of CiA 301 when an
// access is refused. Shares no code with the firmware.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace canproof::naive {

using Bytes = std::vector<std::uint8_t>;
using Message = std::array<std::uint8_t, 8>;

/// One entry of a dictionary.
struct Entry {
    enum class Kind { number, text, domain };
    Kind kind{Kind::number};
    std::size_t capacity{0};  ///< greatest length of the value in bytes; a number always has this length
    std::optional<Bytes> value{};
    bool readable{true};
    bool writable{true};
    bool has_memory{true};  ///< whether the object provides memory in which a download is collected
    /// Returns the abort code for a number that is not allowed; 0 when it is allowed.
    std::function<std::uint32_t(const Bytes&)> limits{[](const Bytes&) { return 0U; }};
};

using Objects = std::map<std::uint16_t, std::map<std::uint8_t, Entry>>;

inline std::uint16_t crc16(const Bytes& bytes) {
    std::uint32_t crc = 0;
    for (const std::uint8_t byte : bytes) {
        crc ^= static_cast<std::uint32_t>(byte) << 8;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 0x8000U) != 0 ? ((crc << 1) ^ 0x1021U) & 0xFFFFU : (crc << 1) & 0xFFFFU;
        }
    }
    return static_cast<std::uint16_t>(crc);
}

/// Splits a value into pieces of seven bytes, one for each segment. The last piece may be shorter; an empty value gives
/// one empty piece.
inline std::vector<Bytes> pieces_of_seven(const Bytes& value) {
    std::vector<Bytes> pieces;
    for (std::size_t from = 0; from < value.size(); from += 7) {
        const std::size_t to = std::min(from + 7, value.size());
        pieces.emplace_back(value.begin() + static_cast<std::ptrdiff_t>(from),
                            value.begin() + static_cast<std::ptrdiff_t>(to));
    }
    if (pieces.empty()) {
        pieces.emplace_back();
    }
    return pieces;
}

/// The values of a device, by index and sub-index.
class ObjectStore {
  public:
    explicit ObjectStore(const Objects& objects) : as_new_{objects}, objects_{objects} {}

    /// Restores every value to its initial value.
    void restore() {
        for (const auto& [index, subindex] : written_) {
            objects_[index][subindex].value = as_new_[index][subindex].value;
        }
        written_.clear();
    }
    const Objects& objects() const { return objects_; }

    /// Sets `entry` to the entry with this index and sub-index. Returns 0, or the abort code if there is none.
    std::uint32_t find(std::uint16_t index, std::uint8_t subindex, Entry*& entry) {
        const auto object = objects_.find(index);
        if (object == objects_.end()) {
            return 0x06020000;
        }
        const auto found = object->second.find(subindex);
        if (found == object->second.end()) {
            return 0x06090011;
        }
        entry = &found->second;
        return 0;
    }
    /// Reads an entry into `value`. Returns 0, or the abort code when the read is refused.
    std::uint32_t read(std::uint16_t index, std::uint8_t subindex, Bytes& value) {
        Entry* entry = nullptr;
        if (const std::uint32_t code = find(index, subindex, entry); code != 0) {
            return code;
        }
        if (!entry->readable) {
            return 0x06010001;
        }
        if (entry->kind == Entry::Kind::domain && !entry->has_memory) {
            return 0x06010000;
        }
        if (!entry->value) {
            return 0x08000024;
        }
        value = *entry->value;
        return 0;
    }
    /// Writes `value` to an entry. Returns 0, or the abort code when the write is refused.
    std::uint32_t write(std::uint16_t index, std::uint8_t subindex, Bytes value) {
        Entry* entry = nullptr;
        if (const std::uint32_t code = find(index, subindex, entry); code != 0) {
            return code;
        }
        if (!entry->writable) {
            return 0x06010002;
        }
        if (entry->kind == Entry::Kind::domain && !entry->has_memory) {
            return 0x05040005;
        }
        if (value.size() > entry->capacity) {
            return 0x06070012;
        }
        if (entry->kind == Entry::Kind::number && value.size() < entry->capacity) {
            return 0x06070013;
        }
        if (const std::uint32_t code = entry->limits(value); code != 0) {
            return code;
        }
        if (entry->kind == Entry::Kind::text) {
            value.erase(std::find(value.begin(), value.end(), 0), value.end());
        }
        entry->value = value;
        written_.emplace_back(index, subindex);
        return 0;
    }

  private:
    Objects as_new_;
    Objects objects_;
    std::vector<std::pair<std::uint16_t, std::uint8_t>> written_;
};

}  // namespace canproof::naive
