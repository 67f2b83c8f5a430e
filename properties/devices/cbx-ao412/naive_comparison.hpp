// SPDX-License-Identifier: Apache-2.0
// Compares a CAN-CBX-AO412 with its naive model. Calls `check(holds, what)` for each compared value.
#pragma once

#include <array>
#include <cmath>

#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "properties/devices/cbx-ao412/naive_cbx_ao412.hpp"

namespace canproof::naive_ao4 {

inline Terminals terminals_of(const cbx_ao412::Inputs& inputs) {
    return {inputs.switch_high, inputs.switch_low,     inputs.switch_baud,   inputs.can_state,
            inputs.can_overrun, inputs.internal_fault, inputs.hardware_fault};
}

/// Compares output voltages, LEDs, bit rate and NMT state.
template <typename Check>
void compare_outputs(const cbx_ao412::Device& device, const Device& model, const Check& check) {
    const auto& outputs = device.outputs();
    constexpr double step_v = 4.096 * 30.9 / 12.4 / 4096.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const int step = static_cast<int>(std::lround(static_cast<double>(outputs.aout[i]) / step_v));
        const Steps expected = model.output(i);
        check(step >= expected.low && step <= expected.high, "voltage of an output");
        check(std::fabs(static_cast<double>(outputs.aout[i]) - step * step_v) < 1e-5, "step of an output");
    }
    const std::array<bool, 4> leds{outputs.led_e, outputs.led_s, outputs.led_m, outputs.led_p};
    check(leds == model.leds(), "LEDs");
    check(device.bit_rate() == model.rate(), "bit rate");
    constexpr std::array<NmtState, 4> states{NmtState::initialising, NmtState::pre_operational, NmtState::operational,
                                             NmtState::stopped};
    check(device.state() == states[static_cast<std::size_t>(model.state())], "state of the node");
}

/// Compares node-ID, 1001h (error register), 1003h (error list) and the objects of the outputs.
template <typename Check>
void compare_objects(const cbx_ao412::Device& device, const Device& model, const Check& check) {
    const auto read = [&](unsigned index, unsigned sub) {
        return device.objects().read(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
    };
    check(unsigned{device.node_id()} == model.node(), "node-ID");
    check(read(0x1001, 0) == model.error_register(), "1001h error register");
    check(read(0x1003, 0) == model.list().size(), "1003h:0 number of errors");
    for (unsigned sub = 1; sub <= 10; ++sub) {
        check(read(0x1003, sub) == (sub <= model.list().size() ? model.list()[sub - 1] : 0U), "1003h error list");
    }
    for (unsigned sub = 1; sub <= 4; ++sub) {
        const auto& set = model.settings().outputs[sub - 1];
        const std::array<int, 5> expected{set.command, static_cast<int>(set.error_mode), set.error_value, set.offset,
                                          set.gain};
        const auto word = [](std::uint32_t raw) { return int{static_cast<std::int16_t>(raw)}; };
        const std::array<int, 5> shown{word(read(0x6411, sub)), static_cast<int>(read(0x6443, sub)),
                                       static_cast<int>(read(0x6444, sub)), word(read(0x2404, sub)),
                                       word(read(0x2405, sub))};
        check(shown == expected, "value, error mode, error value, offset or gain of an output");
    }
}

}  // namespace canproof::naive_ao4
