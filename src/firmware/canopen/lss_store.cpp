#include "firmware/canopen/lss_store.hpp"

#include "firmware/base/crc32.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/sequence_number.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

constexpr std::uint32_t slot_magic = 0x31534C43U;  // "CLS1" in memory
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
    const std::size_t start = (memory_.size() > size) ? (memory_.size() - size) : 0U;
    return start + (slot * slot_size);
}

std::optional<LssStore::Slot> LssStore::read(const std::size_t slot) const noexcept {
    SlotBytes bytes{};
    const bool done = memory_.read(address(slot), MutableBytes{bytes});
    const ByteView view{bytes};
    if (!done || (read_u32(view, 0U) != slot_magic) || (read_u32(view, crc_at) != crc_of(bytes))) {
        return std::nullopt;
    }
    return Slot{read_u32(view, sequence_at), LssConfiguration{view[node_id_at], read_u32(view, bit_rate_at)}};
}

bool LssStore::write(const std::size_t slot, const Slot& content) noexcept {
    SlotBytes bytes{};
    MutableBytes view{bytes};
    write_le(view, 0U, 4U, slot_magic);
    write_le(view, sequence_at, 4U, content.sequence);
    write_le(view, bit_rate_at, 4U, content.configuration.bit_rate);
    view.set(node_id_at, content.configuration.node_id);
    write_le(view, crc_at, 4U, crc_of(bytes));
    bool done = memory_.write(address(slot), ByteView{bytes});
    if (done) {
        done = memory_.commit();
    }
    return done;
}

LssConfiguration LssStore::load(const LssConfiguration& shipped) const noexcept {
    const auto first = read(0U);
    const auto second = read(1U);
    if (first.has_value() && second.has_value()) {
        return is_newer(second->sequence, first->sequence) ? second->configuration : first->configuration;
    }
    if (second.has_value()) {
        return second->configuration;
    }
    return first.has_value() ? first->configuration : shipped;
}

static_assert(implements<req::CO_LSS_020>);
LssError LssStore::store(const LssConfiguration& configuration) noexcept {
    const auto first = read(0U);
    const auto second = read(1U);
    // The slot that is not in use takes the new configuration.
    const bool second_is_older =
        first.has_value() && (!second.has_value() || is_newer(first->sequence, second->sequence));
    std::uint32_t sequence{0U};
    if (second_is_older) {
        sequence = first->sequence + 1U;
    } else if (second.has_value()) {
        sequence = second->sequence + 1U;
    } else {
        // nothing stored yet
    }
    const bool done = write(second_is_older ? 1U : 0U, Slot{sequence, configuration});
    return done ? LssError::none : LssError::storage_failed;
}

}  // namespace canproof
