// SPDX-License-Identifier: Apache-2.0
// The slave of the fuzz target `pdo`, with its PDOs and its mappable values as read from its dictionary. It reads PDO
// parameters only after a change and looks up each entry once, because the target runs thousands of inputs per second.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "fuzz/support/frame_probe.hpp"
#include "fuzz/support/require_consistent.hpp"
#include "host/sim/devices/generic_device.hpp"
#include "host/sim/devices/memory.hpp"
#include "properties/support/naive_pdo.hpp"
#include "tests/support/slave_register.hpp"

namespace canproof::fuzz {

constexpr unsigned pdo_count = 4;

/// The parameters of one PDO, as read from the dictionary.
struct Pdo {
    std::uint32_t cob_id{0};
    std::uint32_t type{0};
    naive_pdo::Mapping mapping{};

    std::uint32_t id() const { return cob_id & 0x7FF; }
    bool is_valid() const { return (cob_id >> 31) == 0; }
    bool has_remote() const { return ((cob_id >> 30) & 1) == 0; }
};

/// The values of all mappable entries by index and sub-index. Every other index and sub-index has the value 0.
class PdoValues {
  public:
    std::uint64_t& operator[](const std::pair<unsigned, unsigned>& address) {
        const auto [index, subindex] = address;
        if ((index & ~3U) == 0x2000U && subindex >= 1 && subindex <= 8) {
            return at_[(index & 3U) * 8 + subindex - 1];
        }
        if ((index & ~1U) == 0x2100U && subindex >= 1 && subindex <= 4) {
            return at_[32 + (index & 1U) * 4 + subindex - 1];
        }
        for (std::size_t i = 0; i < singles.size() && subindex == 0; ++i) {
            if (singles[i] == index) {
                return at_[40 + i];
            }
        }
        return other_ = 0;
    }
    void erase(const std::pair<unsigned, unsigned>& address) { (*this)[address] = 0; }
    bool operator==(const PdoValues& other) const { return at_ == other.at_; }

    /// Calls `visit(index, subindex)` for each mappable entry.
    template <typename Visit>
    static void for_each(const Visit& visit) {
        for (unsigned i = 0; i < 32; ++i) {
            visit(0x2000 + i / 8, i % 8 + 1);
        }
        for (unsigned i = 0; i < 8; ++i) {
            visit(0x2100 + i / 4, i % 4 + 1);
        }
        for (const unsigned index : singles) {
            visit(index, 0U);
        }
    }

  private:
    static constexpr std::array<unsigned, 5> singles{0x1001, 0x2200, 0x2202, 0x2206, 0x2207};

    std::array<std::uint64_t, 45> at_{};
    std::uint64_t other_{0};
};

/// The entries of one object, which are looked up once for all inputs.
class Entries {
  public:
    Entries(const ObjectDictionary& objects, unsigned index) : objects_{objects} {
        for (unsigned sub = 0; sub < rows_.size(); ++sub) {
            rows_[sub] = objects.lookup(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub)).row;
        }
    }
    std::uint64_t value(unsigned subindex) const {
        const ByteView bytes = objects_.bytes(*rows_.at(subindex));
        std::uint64_t read = 0;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            read |= static_cast<std::uint64_t>(bytes[i]) << (8 * i);
        }
        return read;
    }
    /// Returns whether an entry of this object has changed since `seen`, an earlier copy of the image. Constant entries
    /// are not compared, because they are not in the image.
    bool differ(const naive_pdo::Bytes& seen) const {
        const ByteView image = objects_.image();
        return std::any_of(rows_.begin(), rows_.end(), [&](const EntryRow* row) {
            return row != nullptr && !row->may(rights::constant) &&
                   std::memcmp(image.data() + row->offset, seen.data() + row->offset, row->size) != 0;
        });
    }

  private:
    const ObjectDictionary& objects_;
    std::array<const EntryRow*, 9> rows_{};
};

/// The slave of the conformance suite as node 5: built once, restarted for each input.
class PdoSlave {
  public:
    PdoSlave() {
        for (unsigned number = 0; number < pdo_count; ++number) {
            receive_[number] = std::make_unique<PdoEntries>(device_.objects(), 0x1400 + number);
            transmit_[number] = std::make_unique<PdoEntries>(device_.objects(), 0x1800 + number);
        }
        PdoValues::for_each([this](unsigned index, unsigned) { entries(index); });
        entries(0x1005);
        entries(0x1014);
    }

    /// Restarts the slave: power-on with an empty memory.
    void restart() {
        queue_ = TransmitQueue{};
        std::fill(memory_.bytes().begin(), memory_.bytes().end(), std::uint8_t{0xFF});
        now = begin_input();
        sent_.clear();
        emcy_ids_.assign(1, 0x085);
        image_seen_.clear();
        device_.power_on(5, now);
        drain();
    }
    /// Returns whether any object has changed since the last call. If so, updates rpdo() and tpdo() of each PDO whose
    /// parameters have changed.
    bool has_changed() {
        const ByteView image = device_.objects().image().view();
        if (std::equal(image.data(), image.data() + image.size(), image_seen_.begin(), image_seen_.end())) {
            return false;
        }
        const bool all = image_seen_.size() != image.size();
        for (unsigned number = 0; number < pdo_count; ++number) {
            receive_[number]->follow(image_seen_, all);
            transmit_[number]->follow(image_seen_, all);
        }
        image_seen_.assign(image.data(), image.data() + image.size());
        return true;
    }

    /// Returns an RPDO or TPDO, as it was at the last call of has_changed().
    const Pdo& rpdo(unsigned number) const { return receive_[number]->pdo; }
    const Pdo& tpdo(unsigned number) const { return transmit_[number]->pdo; }
    bool is_operational() { return device_.node().state() == NmtState::operational; }

    std::uint64_t value(unsigned index, unsigned subindex) { return entries(index).value(subindex); }
    /// Returns the values of all mappable entries.
    PdoValues values() {
        PdoValues all;
        PdoValues::for_each([&](unsigned index, unsigned sub) { all[{index, sub}] = value(index, sub); });
        return all;
    }
    void receive(const Frame& frame) { deliver(device_, frame, now); }
    void set_byte(std::uint8_t subindex, std::uint8_t byte) {
        device_.objects().write(0x2001, subindex, byte);
        device_.node().process_value_changed(0x2001, subindex, now);
        device_.advance(now);
    }
    void pass(std::uint64_t ms) {
        const Instant end = now + milliseconds(ms);
        for (; device_.next_deadline() <= end; device_.advance(now)) {
            now = std::max(now, device_.next_deadline(), [](Instant a, Instant b) { return a < b; });
            drain();
        }
        now = end;
    }
    /// Checks the invariants of the services. Returns the frames that were sent since the last call of forget().
    const std::vector<Frame>& drain() {
        require_consistent(device_);
        while (!queue_.empty()) {
            sent_.push_back(queue_.pop());
        }
        return sent_;
    }
    void forget() { sent_.clear(); }
    /// Returns whether `id` is or was the COB-ID in 1014h (COB-ID EMCY). An emergency message in the transmit queue
    /// keeps the identifier that was valid when it was queued.
    bool has_emcy_id(std::uint32_t id) {
        const std::uint32_t present = static_cast<std::uint32_t>(value(0x1014, 0)) & 0x7FF;
        if (std::find(emcy_ids_.begin(), emcy_ids_.end(), present) == emcy_ids_.end()) {
            emcy_ids_.push_back(present);
        }
        return std::find(emcy_ids_.begin(), emcy_ids_.end(), id) != emcy_ids_.end();
    }
    bool is_idle() {
        device_.advance(now);
        return device_.next_deadline() > now;
    }

    Instant now{};

  private:
    struct PdoEntries {
        PdoEntries(const ObjectDictionary& objects, unsigned index)
            : communication{objects, index}, mapping{objects, index + 0x200} {}

        void follow(const naive_pdo::Bytes& seen, bool again) {
            if (!again && !communication.differ(seen) && !mapping.differ(seen)) {
                return;
            }
            pdo.cob_id = static_cast<std::uint32_t>(communication.value(1));
            pdo.type = static_cast<std::uint32_t>(communication.value(2));
            pdo.mapping.clear();
            for (unsigned sub = 1; sub <= mapping.value(0); ++sub) {
                const auto entry = static_cast<std::uint32_t>(mapping.value(sub));
                pdo.mapping.push_back({entry >> 16, (entry >> 8) & 0xFF, entry & 0xFF});
            }
        }

        Entries communication;
        Entries mapping;
        Pdo pdo;
    };

    const Entries& entries(unsigned index) {
        for (const auto& [known, found] : entries_) {
            if (known == index) {
                return found;
            }
        }
        entries_.emplace_back(index, Entries{device_.objects(), index});
        return entries_.back().second;
    }

    host::Memory memory_{4096};
    TransmitQueue queue_;
    host::GenericDevice device_{test::slave_part(), memory_, queue_};
    std::vector<Frame> sent_;
    std::vector<std::uint32_t> emcy_ids_;
    naive_pdo::Bytes image_seen_;
    std::array<std::unique_ptr<PdoEntries>, pdo_count> receive_;
    std::array<std::unique_ptr<PdoEntries>, pdo_count> transmit_;
    std::vector<std::pair<unsigned, Entries>> entries_;
};

}  // namespace canproof::fuzz
