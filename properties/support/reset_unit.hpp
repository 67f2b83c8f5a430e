// SPDX-License-Identifier: Apache-2.0
// Runs one device under any events, for the properties of reset_law.hpp. `Traits` names the types of the device, the
// size of its memory and useful writes; see properties/devices/NAME/reset_property.cpp.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/memory.hpp"

namespace canproof::test {

/// An object and the values that tests write to it: to each of the sub-indices 1 to `subs`, or to sub-index 0 if `subs`
/// is 0.
struct Setting {
    std::uint16_t index;
    unsigned subs;
    unsigned bytes;
    std::vector<std::uint32_t> values;
};

/// An input and its possible values.
struct InputChoice {
    std::string name;
    std::vector<double> values;
};

/// One write by SDO, `bytes` long.
struct Write {
    std::uint16_t index;
    unsigned sub;
    unsigned bytes;
    std::uint32_t value;
};

/// Default members for `Traits`, right for most devices.
struct UsualTraits {
    /// Returns writes that configure ramps, delays or counters, so that the device has internal state that a reset must
    /// clear.
    static std::vector<Write> lively() { return {}; }
    /// Returns whether tests may write the object with this index. They must not write objects that take effect only at
    /// the next power-on.
    static bool may_write(unsigned) { return true; }
    /// Returns whether reset node keeps the present outputs.
    template <typename Device, typename Inputs>
    static bool keeps_outputs(const Device&, const Inputs&) {
        return false;
    }
};

template <typename Traits>
class ResetUnit {
  public:
    using Device = typename Traits::Device;

    /// Makes a unit that is switched on at the time `at` with the non-volatile memory `stored` and the inputs
    /// `at_terminals`.
    ResetUnit(const std::vector<std::uint8_t>& stored, const typename Traits::Inputs& at_terminals, Instant at)
        : inputs{at_terminals}, now{at} {
        memory.bytes() = stored;
        device = std::make_unique<Device>(memory, queue, typename Traits::FactoryData{});
        device->power_on(inputs, now);
        take();
    }
    ResetUnit()
        : ResetUnit{std::vector<std::uint8_t>(Traits::memory_size, 0xFF), typename Traits::Inputs{},
                    Instant{1'000'000}} {}

    unsigned node() const { return device->node_id(); }
    std::uint32_t value(unsigned index, unsigned sub) const {
        return device->objects().read(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
    }

    void send(const Frame& frame) {
        device->receive(frame, now);
        take();
    }
    void send(std::uint32_t id, const std::vector<unsigned>& bytes) {
        Frame frame = data_frame(id, static_cast<std::uint8_t>(bytes.size()));
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            frame.data[i] = static_cast<std::uint8_t>(bytes[i]);
        }
        send(frame);
    }
    void ask_remote(std::uint32_t id) {
        Frame frame = data_frame(id & 0x7FFU, 0);
        frame.remote = true;
        send(frame);
    }
    /// Sends an SDO request of eight bytes.
    void request(unsigned command, unsigned index, unsigned sub, std::uint32_t data) {
        send(0x600U + node(), {command, index & 0xFFU, index >> 8U, sub, data & 0xFFU, (data >> 8U) & 0xFFU,
                               (data >> 16U) & 0xFFU, data >> 24U});
    }
    void write(unsigned index, unsigned sub, unsigned bytes, std::uint32_t data) {
        request(0x23U | ((4U - bytes) << 2U), index, sub, data);
    }
    void command(unsigned command) { send(0U, {command, node()}); }

    bool set_input(const std::string& name, double wanted) {
        bool found = false;
        for_each_input(inputs, [&](const char* one, auto& input) {
            if (name == one) {
                input = static_cast<std::decay_t<decltype(input)>>(wanted);
                found = true;
            }
        });
        device->set_inputs(inputs, now);
        take();
        return found;
    }
    /// The longest switch delay of the LSS request activate bit timing in these tests. The device waits for this delay
    /// twice: before and after the switch.
    static constexpr Duration longest_silence = milliseconds(20);
    /// Makes the CAN controller work again, and waits until LSS has finished a change of the bit rate.
    void recover() {
        set_input("can_state", 0.0);
        set_input("can_overrun", 0.0);
        const Instant end = silent_until;
        silent_until = Instant{};
        if (end != Instant{}) {  // if the device was called late, the second switch delay ends later
            pass(longest_silence);
            pass_until(end);
        }
    }

    void pass(Duration time) { pass_until(now + time); }
    /// Advances time to `end` and keeps every deadline on the way.
    void pass_until(Instant end) {
        while (device->next_deadline() <= end && !is_stuck) {
            now = now < device->next_deadline() ? device->next_deadline() : now;
            advance();
        }
        now = now < end ? end : now;
    }
    /// Advances the time in one step, as when the driver calls the device late.
    void pass_unattended(Duration time) {
        now = now + time;
        advance();
    }

    /// Switches the same device on again, as after a power cut.
    void power_on() {
        queue = TransmitQueue{};
        device->power_on(inputs, now);
        take();
    }

    std::vector<std::string> take_frames() { return std::exchange(frames_, {}); }
    std::vector<double> outputs() const {
        std::vector<double> all;
        for_each_output(device->outputs(),
                        [&all](const char*, const auto& one) { all.push_back(static_cast<double>(one)); });
        return all;
    }

    host::Memory memory{Traits::memory_size};
    TransmitQueue queue;
    typename Traits::Inputs inputs;
    Instant now;
    Instant silent_until{};
    bool is_stuck{false};  ///< whether the device did not do work that was due
    std::unique_ptr<Device> device;

  private:
    void advance() {
        device->advance(now);
        is_stuck = is_stuck || device->next_deadline() <= now;
        take();
    }
    void take() {
        while (!queue.empty()) {
            frames_.push_back(fmt::format("{} {}", now.us, host::format_frame(queue.pop())));
        }
    }

    std::vector<std::string> frames_;
};

/// Returns, as text, the first entry that has different values in the two units, or an empty text. Compares only
/// entries for which `counts` returns true.
template <typename Traits, typename Counts>
std::string difference_of_values(const ResetUnit<Traits>& one, const ResetUnit<Traits>& other, const Counts& counts) {
    const DictionaryTables& tables = one.device->objects().tables();
    for (const ObjectRow& object : tables.objects) {
        for (std::size_t i = 0; i < object.count; ++i) {
            const EntryRef entry{&tables.entries[object.first_entry + i], object.index};
            const ByteView mine = one.device->objects().bytes(*entry.row);
            const ByteView its = other.device->objects().bytes(*entry.row);
            if (counts(entry) && !std::equal(mine.data(), mine.data() + mine.size(), its.data())) {
                return fmt::format("{:04X}h:{}: {:02X} is not {:02X}", entry.index, entry.row->subindex,
                                   fmt::join(mine.data(), mine.data() + mine.size(), " "),
                                   fmt::join(its.data(), its.data() + its.size(), " "));
            }
        }
    }
    return "";
}

/// Returns, as text, the difference between the frames of the two units since the last call, their outputs and their
/// values, or an empty text.
template <typename Traits, typename Counts>
std::string difference(ResetUnit<Traits>& one, ResetUnit<Traits>& other, const Counts& counts) {
    const auto frames = std::pair{one.take_frames(), other.take_frames()};
    if (one.is_stuck || other.is_stuck) {
        return "what is due is not done";
    }
    if (frames.first != frames.second) {
        const auto text = [](const std::vector<std::string>& all) { return fmt::format("{}", fmt::join(all, "; ")); };
        return fmt::format("frames: [{}] is not [{}]", text(frames.first), text(frames.second));
    }
    if (one.outputs() != other.outputs()) {
        return fmt::format("outputs: {} is not {}", fmt::join(one.outputs(), " "), fmt::join(other.outputs(), " "));
    }
    if (one.device->bit_rate() != other.device->bit_rate() || one.node() != other.node()) {
        return fmt::format("node {} at {} bit/s is not node {} at {} bit/s", one.node(), one.device->bit_rate(),
                           other.node(), other.device->bit_rate());
    }
    return difference_of_values(one, other, counts);
}

}  // namespace canproof::test
