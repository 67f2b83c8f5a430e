// SPDX-License-Identifier: Apache-2.0
#include "devices/relay-counter/firmware/relay_counter.hpp"

#include "devices/relay-counter/firmware/lamp.hpp"
#include "devices/relay-counter/firmware/relay.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/relay_counter/constants.hpp"
#include "generated/relay_counter/profile.hpp"
#include "generated/relay_counter/requirements.hpp"
#include "generated/relay_counter/tables.hpp"

namespace canproof::relay_counter {

namespace {

namespace own = generated::relay_counter;
namespace field = generated::relay_counter::field;

constexpr std::uint32_t relay_count = 2U;

const LssConfiguration shipped{own::shipped_node_id, own::shipped_bit_rate};

}  // namespace

Device::Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData&) noexcept
    : Application{},
      objects_{own::tables, MutableBytes{image_}, own::profile.limit_abort},
      lss_store_{memory},
      node_{objects_, memory, queue, *this, own::error_table, own::profile, pdos_.memory()} {}

static_assert(implements<req::RC_BOOT_001> && implements<req::RC_LSS_001>);
void Device::power_on(const Inputs& inputs, const Instant now) noexcept {
    inputs_ = inputs;
    const LssConfiguration stored = lss_store_.load(shipped);
    bit_rate_ = stored.bit_rate;
    node_.power_on(stored, inputs.can_state, false, now);
    set_inputs(inputs, now);
}

void Device::receive(const Frame& frame, const Instant now) noexcept {
    node_.receive(frame, now);
    show_state();
}

void Device::set_inputs(const Inputs& inputs, const Instant now) noexcept {
    inputs_ = inputs;
    node_.set_controller(inputs.can_state, false, now);
    tell_errors(now);
    counter_.see(inputs.count_input);
    show_count();
    show_state();
}

void Device::advance(const Instant now) noexcept {
    node_.advance(now);
}

Instant Device::next_deadline() const noexcept {
    return node_.next_deadline();
}

AbortCode Device::check_access(const EntryRef&) {
    return AbortCode::none;
}

AbortCode Device::before_write(const EntryRef&, const ByteView) {
    return AbortCode::none;
}

void Device::after_write(const EntryRef&, const Instant) {}

void Device::put_factory_values(const ParameterGroup) {}

void Device::restart(const Instant) {
    counter_.restart(inputs_.count_input);  // the counter (2010h) has its default, 0
}

void Device::booted(const Instant now) {
    tell_errors(now);  // a reset clears the active errors, so those that are still present are reported again
}

void Device::communication_failed(const bool, const Instant) {}

static_assert(implements<req::RC_LSS_002>);
void Device::set_bit_rate(const std::uint32_t bit_rate, const Instant) {
    bit_rate_ = bit_rate;
}

static_assert(implements<req::RC_LSS_003>);
LssError Device::store_configuration(const LssConfiguration& configuration) {
    return lss_store_.store(configuration);
}

static_assert(implements<req::RC_ERR_001>);
static_assert(implements<req::RC_ERR_002>);
void Device::tell_errors(const Instant now) noexcept {
    node_.set_error(own::error::overload, inputs_.overload, now);
}

void Device::show_state() noexcept {
    const bool operational = node_.state() == NmtState::operational;
    outputs_.lamp = lamp_is_lit(operational, inputs_.overload);
    for (std::uint8_t number = 1U; number <= relay_count; ++number) {
        const std::uint8_t command = objects_.get(field::o2000_relay_command[number]);
        outputs_.relay[number - 1U] = contact_is_closed(command, operational);
    }
}

void Device::show_count() noexcept {
    objects_.set(field::o2010_counter, counter_.count());
}

}  // namespace canproof::relay_counter
