// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/lss_store.hpp"

#include "firmware/base/crc32.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/sequence_number.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

constexpr std::uint32_t slot_magic = 0x31534C43U;  // "CLS1" in memory; its last letter is the commit marker
constexpr std::uint8_t committed_marker = 0x31U;
constexpr std::size_t magic_at = 0U;
constexpr std::size_t sequence_at = 4U;
constexpr std::size_t bit_rate_at = 8U;
constexpr std::size_t node_id_at = 12U;
constexpr std::size_t crc_at = 16U;

using SlotBytes = std::array<std::uint8_t, LssStore::slot_size>;

std::uint32_t crc_of(const SlotBytes& bytes) noexcept {
    Crc32 crc{};
    crc.add(ByteView{bytes}.part(0U, crc_at));
    return crc.value();
}

}  // namespace

std::size_t LssStore::address(const std::size_t slot) const noexcept {
    const std::size_t available = memory_.size();
    const std::size_t start = (available > size) ? (available - size) : 0U;
    return start + (slot * slot_size);
}

LssStore::Slot LssStore::read(const std::size_t slot) const noexcept {
    SlotBytes bytes{};
    const bool is_readable = memory_.read(address(slot), MutableBytes{bytes});
    const BankState state = state_by_marker(is_readable, ByteView{bytes}, committed_marker);
    bytes[commit_marker_at] = committed_marker;
    const bool is_sound = (state != BankState::unused) && is_readable &&
                          (field_le<magic_at, 4U>(bytes) == slot_magic) &&
                          (field_le<crc_at, 4U>(bytes) == crc_of(bytes));
    const auto sequence = static_cast<std::uint32_t>(field_le<sequence_at, 4U>(bytes));
    const auto bit_rate = static_cast<std::uint32_t>(field_le<bit_rate_at, 4U>(bytes));
    return Slot{is_sound ? BankState::sound : state, sequence, LssConfiguration{bytes[node_id_at], bit_rate}};
}

bool LssStore::write_marker(const std::size_t slot, const std::uint8_t marker) noexcept {
    return memory_.write(address(slot) + commit_marker_at, ByteView{&marker, 1U});
}

/// Writes a slot. Until the last write its marker is void, so that an interrupted write leaves no valid slot.
bool LssStore::write(const std::size_t slot, const Slot& content) noexcept {
    SlotBytes bytes{};
    set_field_le<magic_at, 4U>(bytes, slot_magic);
    set_field_le<sequence_at, 4U>(bytes, content.sequence);
    set_field_le<bit_rate_at, 4U>(bytes, content.configuration.bit_rate);
    bytes[node_id_at] = content.configuration.node_id;
    set_field_le<crc_at, 4U>(bytes, crc_of(bytes));
    bytes[commit_marker_at] = void_marker;
    bool done = write_marker(slot, void_marker);
    if (done) {
        done = memory_.write(address(slot), ByteView{bytes});
    }
    if (done) {
        done = write_marker(slot, committed_marker);
    }
    return done;
}

/// Returns the slot whose settings apply; the second one while nothing is stored.
std::size_t LssStore::latest_of(const Slot& first, const Slot& second) noexcept {
    const bool both_sound = (first.state == BankState::sound) && (second.state == BankState::sound);
    const bool is_first = (first.state > second.state) || (both_sound && !is_newer(second.sequence, first.sequence));
    return is_first ? 0U : 1U;
}

static_assert(implements<req::CO_LSS_065> && implements<req::CO_LSS_066>);
LssConfiguration LssStore::load(const LssConfiguration& shipped) const noexcept {
    const Slot first = read(0U);
    const Slot second = read(1U);
    const Slot& latest = (latest_of(first, second) == 0U) ? first : second;
    const bool counts = (latest.state == BankState::sound) && is_lss_node_id(latest.configuration.node_id);
    LssConfiguration found = counts ? latest.configuration : shipped;
    found.damaged = (latest.state == BankState::doubtful) || (latest.state == BankState::damaged);
    return found;
}

static_assert(implements<req::CO_LSS_020> && implements<req::CO_LSS_076> && implements<req::CO_LSS_088>);
LssError LssStore::store(const LssConfiguration& configuration) noexcept {
    const Slot first = read(0U);
    const Slot second = read(1U);
    const std::size_t before = latest_of(first, second);
    const Slot& latest = (before == 0U) ? first : second;
    const std::size_t to = 1U - before;
    bool done = write(to, Slot{BankState::sound, latest.sequence + 1U, configuration});
    if (done) {
        // If this write fails, two sound slots remain; the sequence number still shows which is newer. But a damaged
        // slot has priority over the new one.
        done = write_marker(before, void_marker) || (latest.state != BankState::damaged);
    }
    if (!done) {
        // The committed marker may be in the memory, although its write failed.
        static_cast<void>(write_marker(to, void_marker));
        return LssError::storage_failed;
    }
    return memory_.commit() ? LssError::none : LssError::storage_failed;
}

}  // namespace canproof
