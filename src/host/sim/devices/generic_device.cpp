// SPDX-License-Identifier: Apache-2.0
#include "host/sim/devices/generic_device.hpp"

#include <algorithm>
#include <utility>

namespace canproof::host {

namespace {

constexpr std::uint8_t generic_error = 0x01;
// bits 0 (generic error) and 4 (communication) of 1001h error register
constexpr std::uint8_t communication_error = 0x11;

const auto standard_bit_rates = lss_bit_rates(generated::canopen::lss_bit_rates::rows);

}  // namespace

LssProfile standard_lss() {
    return LssProfile{standard_bit_rates, false};
}

GenericDescription describe(const Part& part) {
    NodeProfile profile;
    profile.limit_abort = part.info.limit_abort == "range" ? LimitAbort::range : LimitAbort::high_low;
    profile.error_list = part.info.error_list == "active" ? ErrorList::active : ErrorList::history;
    profile.block_sdo = part.info.block_sdo;
    profile.lss = part.info.lss ? standard_lss() : LssProfile{};
    return {make_rows(part), profile};
}

ErrorTable standard_errors() {
    ErrorTable table{};
    const auto tell = [&table](ErrorId error, std::uint16_t code, std::uint8_t bits) {
        table[static_cast<std::size_t>(error)] = ErrorRow{code, bits, true, true};
    };
    tell(ErrorId::can_overrun, 0x8110, communication_error);
    tell(ErrorId::error_passive, 0x8120, communication_error);
    tell(ErrorId::guard_or_heartbeat, 0x8130, communication_error);
    // the error is over when it is reported, so it sets no bit of 1001h error register
    tell(ErrorId::bus_off_recovered, 0x8140, 0);
    tell(ErrorId::sync_length, 0x8240, communication_error);
    tell(ErrorId::rpdo_length, 0x8210, communication_error);
    tell(ErrorId::rpdo_value, 0x8200, communication_error);
    tell(ErrorId::rpdo_timeout, 0x8250, communication_error);
    tell(ErrorId::internal_software, 0x6100, generic_error);
    tell(ErrorId::stored_set_checksum, 0x6300, generic_error);
    return table;
}

GenericDevice::GenericDevice(const Part& part, NonVolatileMemory& memory, TransmitQueue& queue)
    : GenericDevice{describe(part), memory, queue} {}

GenericDevice::GenericDevice(GenericDescription description, NonVolatileMemory& memory, TransmitQueue& queue)
    : rows_{std::move(description.rows)},
      tables_{rows_.tables()},
      image_(rows_.layout.image.size()),
      objects_{tables_, MutableBytes{image_.data(), image_.size()}, description.profile.limit_abort},
      errors_{standard_errors()},
      received_(pdo_count(tables_, PdoDirection::receive)),
      sent_(pdo_count(tables_, PdoDirection::transmit)),
      received_lines_(received_.size() * pdo_lines(tables_)),
      sent_lines_(sent_.size() * pdo_lines(tables_)),
      node_{objects_, memory, queue, *this, errors_, description.profile, pdo_memory()} {}

PdoMemory GenericDevice::pdo_memory() {
    return {Slots<ReceivePdo>{received_.data(), received_.size()}, Slots<TransmitPdo>{sent_.data(), sent_.size()},
            Slots<PdoLine>{received_lines_.data(), received_lines_.size()},
            Slots<PdoLine>{sent_lines_.data(), sent_lines_.size()}};
}

void GenericDevice::lend(std::uint16_t index, std::uint8_t subindex, std::size_t size) {
    domains_.push_back({index, subindex, size, {}, {}, 0, false});
}

void GenericDevice::take_domain_memory() {
    for (Domain& one : domains_) {
        one.value.resize(one.size);
        one.staging.resize(one.size);
    }
}

GenericDevice::Domain* GenericDevice::domain(std::uint16_t index, std::uint8_t subindex) {
    const auto found = std::find_if(domains_.begin(), domains_.end(),
                                    [&](const Domain& one) { return one.index == index && one.subindex == subindex; });
    return found == domains_.end() ? nullptr : &*found;
}

ByteView GenericDevice::held(std::uint16_t index, std::uint8_t subindex) const {
    for (const Domain& one : domains_) {
        if (one.index == index && one.subindex == subindex) {
            return ByteView{one.value.data(), one.length};
        }
    }
    return {};
}

void GenericDevice::fill(std::uint16_t index, std::uint8_t subindex, const std::vector<std::uint8_t>& bytes) {
    Domain& place = *domain(index, subindex);
    place.value.resize(place.size);
    place.length = std::min(bytes.size(), place.size);
    std::copy_n(bytes.begin(), place.length, place.value.begin());
    place.holds_value = true;
}

void GenericDevice::empty(std::uint16_t index, std::uint8_t subindex) {
    Domain& place = *domain(index, subindex);
    place.length = 0;
    place.holds_value = false;
}

Result<ByteView, AbortCode> GenericDevice::domain_value(const EntryRef& entry) {
    const Domain* place = domain(entry.index, entry.row->subindex);
    if (place == nullptr) {
        return Application::domain_value(entry);
    }
    return place->holds_value ? Result<ByteView, AbortCode>::success(held(entry.index, entry.row->subindex))
                              : Result<ByteView, AbortCode>::failure(AbortCode::no_data);
}

MutableBytes GenericDevice::staging(const EntryRef& entry) {
    Domain* place = domain(entry.index, entry.row->subindex);
    if (place == nullptr) {
        return Application::staging(entry);
    }
    place->staging.resize(place->size);
    return MutableBytes{place->staging.data(), place->staging.size()};
}

AbortCode GenericDevice::commit(const EntryRef& entry, std::size_t length, Instant) {
    Domain* place = domain(entry.index, entry.row->subindex);
    if (place == nullptr || domain_refusal_ != AbortCode::none) {
        return place == nullptr ? AbortCode::unsupported_access : domain_refusal_;
    }
    place->value.swap(place->staging);
    place->length = length;
    place->holds_value = true;
    return AbortCode::none;
}

void GenericDevice::power_on(const LssConfiguration& stored, Instant now, std::uint8_t can_state, bool overrun) {
    stored_ = stored;
    bit_rate_ = stored.bit_rate;
    node_.power_on(stored, can_state, overrun, now);
}

LssError GenericDevice::store_configuration(const LssConfiguration& configuration) {
    const LssError answer = store_ == nullptr ? store_answer_ : store_->store(configuration);
    if (answer == LssError::none) {
        stored_ = configuration;
    }
    return answer;
}

}  // namespace canproof::host
