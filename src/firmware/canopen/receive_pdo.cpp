#include "firmware/canopen/receive_pdo.hpp"

#include "firmware/canopen/cob_id.hpp"
#include "generated/canopen/tables.hpp"

namespace canproof {

namespace {

namespace transmission = generated::canopen::t_co_t_transmission_type;

constexpr std::uint16_t communication_index = 0x1400U;
constexpr std::uint16_t mapping_index = 0x1600U;
constexpr std::uint8_t cob_id_subindex = 1U;
constexpr std::uint8_t type_subindex = 2U;

constexpr std::uint16_t numbered(const std::uint16_t index, const std::size_t number) noexcept {
    return static_cast<std::uint16_t>(index + number);
}

bool is_applied_at_sync(const std::uint32_t type) noexcept {
    const auto* const row = transmission::find(static_cast<std::uint8_t>(type));
    return (row != nullptr) && (row->applied == transmission::Applied::at_sync);
}

bool is_refused(const std::uint32_t type) noexcept {
    const auto* const row = transmission::find(static_cast<std::uint8_t>(type));
    return (row == nullptr) || (row->applied == transmission::Applied::refused);
}

}  // namespace

std::uint32_t ReceivePdos::cob_id_entry(const std::size_t number) const noexcept {
    const auto found = objects_.find(numbered(communication_index, number), cob_id_subindex);
    return found.ok() ? read_u32(objects_.value(found.value()), 0U) : cob_id::not_valid;
}

PdoMapping ReceivePdos::mapping(const std::size_t number) const noexcept {
    return PdoMapping{objects_, numbered(mapping_index, number), rights::rpdo};
}

PdoReception ReceivePdos::receive(const Frame& frame, const Instant now) noexcept {
    PdoReception result{PdoReception::not_ours};
    for (std::size_t number = 0U; (number < max_count) && !frame.extended; ++number) {
        const std::uint32_t entry = cob_id_entry(number);
        if (!cob_id::is_valid(entry) || (cob_id::identifier(entry) != frame.id)) {
            continue;
        }
        if (!frame.remote) {
            result = take(number, frame, now);
        } else if ((((answering_remote_ >> number) & 1U) != 0U) && ((entry & cob_id::no_remote) == 0U)) {
            // CAN-CBX-AO412, 7.7.2: an RTR on a receive PDO reads back what it writes.
            static_cast<void>(queue_.push(mapping(number).pack(frame.id)));
            result = PdoReception::taken;
        } else {
            result = PdoReception::taken;
        }
    }
    return result;
}

PdoReception ReceivePdos::take(const std::size_t number, const Frame& frame, const Instant now) noexcept {
    if (frame.length < mapping(number).length()) {
        return PdoReception::too_short;
    }
    if (is_applied_at_sync(objects_.read(numbered(communication_index, number), type_subindex))) {
        waiting_[number] = Waiting{frame, true};
    } else {
        mapping(number).apply(frame, access_, now);
    }
    return PdoReception::taken;
}

void ReceivePdos::sync(const Instant now) noexcept {
    for (std::size_t number = 0U; number < max_count; ++number) {
        const Waiting due = waiting_[number];
        waiting_[number].present = false;
        // The mapping may have changed since: what no longer fits is not applied.
        if (due.present && (due.frame.length >= mapping(number).length())) {
            mapping(number).apply(due.frame, access_, now);
        }
    }
}

AbortCode ReceivePdos::before_write(const EntryRef& entry, const ByteView value) const noexcept {
    const std::uint16_t family = static_cast<std::uint16_t>(entry.index & 0xFF00U);
    const std::size_t number = entry.index & 0x00FFU;
    if (family == communication_index) {
        return before_communication_write(entry, number, value);
    }
    return (family == mapping_index) ? before_mapping_write(entry, number, value) : AbortCode::none;
}

AbortCode ReceivePdos::before_communication_write(const EntryRef& entry, const std::size_t number,
                                                  const ByteView value) const noexcept {
    if (entry.row->subindex == cob_id_subindex) {
        const std::uint32_t current = cob_id_entry(number);
        return cob_id::check_change(current, read_u32(value, 0U), cob_id::not_valid | cob_id::no_remote,
                                    cob_id::is_valid(current));
    }
    const bool refused = (entry.row->subindex == type_subindex) && is_refused(value[0]);
    return refused ? AbortCode::value_range : AbortCode::none;
}

AbortCode ReceivePdos::before_mapping_write(const EntryRef& entry, const std::size_t number,
                                            const ByteView value) const noexcept {
    // CiA 301, 7.5.2.36: disable the PDO, set sub 0 to 0, write the entries, set sub 0, enable the PDO.
    const PdoMapping current = mapping(number);
    if (cob_id::is_valid(cob_id_entry(number))) {
        return AbortCode::device_state;
    }
    if (entry.row->subindex == 0U) {
        return current.check_count(value[0]);
    }
    return (current.count() != 0U) ? AbortCode::device_state : current.check_entry(read_u32(value, 0U));
}

}  // namespace canproof
