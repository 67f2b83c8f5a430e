#include "devices/relay-counter/firmware/relay_counter.hpp"

#include "devices/relay-counter/firmware/lamp.hpp"
#include "devices/relay-counter/firmware/relay.hpp"
#include "firmware/base/requirement.hpp"
#include "generated/relay_counter/constants.hpp"
#include "generated/relay_counter/requirements.hpp"

namespace canproof::relay_counter {

namespace {

namespace own = generated::relay_counter;
namespace field = generated::relay_counter::field;

constexpr std::uint8_t relay_count = 2U;
constexpr std::uint8_t max_node_id = 127U;
constexpr NodeProfile profile{};
constexpr ErrorTable error_table{};  // no emergency messages yet

}  // namespace

Device::Device(NonVolatileMemory& memory, TransmitQueue& queue, const FactoryData&) noexcept
    : Application{}, objects_{own::tables, MutableBytes{image_}, profile.limit_abort}, node_{objects_,      memory,
                                                                                             queue,         *this,
                                                                                             error_table,   profile,
                                                                                             pdos_.memory()} {}

static_assert(implements<req::RC_BOOT_001>);
void Device::power_on(const Inputs& inputs, const Instant now) noexcept {
    inputs_ = inputs;
    node_id_ = inputs.node_switch;
    if ((node_id_ != 0U) && (node_id_ <= max_node_id)) {
        node_.power_on(node_id_, now);
    }
    set_inputs(inputs, now);
}

void Device::receive(const Frame& frame, const Instant now) noexcept {
    node_.receive(frame, now);
    show_state();
}

void Device::set_inputs(const Inputs& inputs, const Instant now) noexcept {
    inputs_ = inputs;
    node_.set_controller(inputs.can_state, false, now);
    counter_.see(inputs.count_input);
    show_count();
    show_state();
}

void Device::advance(const Instant now) noexcept {
    node_.advance(now);
    show_state();
}

Instant Device::next_deadline() const noexcept {
    return node_.next_deadline();
}

std::uint32_t Device::bit_rate() const noexcept {
    return own::bit_rate;
}

AbortCode Device::check_access(const EntryRef&) {
    return AbortCode::none;
}

AbortCode Device::before_write(const EntryRef&, const ByteView) {
    return AbortCode::none;
}

void Device::after_write(const EntryRef&, const Instant) {
    show_state();
}

void Device::put_factory_values(const ParameterGroup) {}

void Device::restart(const Instant) {
    counter_.restart(inputs_.count_input);
    show_count();
}

void Device::booted(const Instant) {}

void Device::communication_failed(const bool, const Instant) {}

void Device::show_state() noexcept {
    outputs_.lamp = lamp_is_lit(node_.state());
    for (std::uint8_t number = 1U; number <= relay_count; ++number) {
        const std::uint8_t command = objects_.get(field::o2000_relay_command[number]);
        outputs_.relay[number - 1U] = contact_is_closed(command, node_.state());
    }
}

void Device::show_count() noexcept {
    objects_.set(field::o2010_counter, counter_.count());
}

}  // namespace canproof::relay_counter
