// SPDX-License-Identifier: Apache-2.0
// Compares an AX188001 with its naive model. Calls `check(holds, what)` for each compared value.
#pragma once

#include "devices/ax188001/firmware/ax188001.hpp"
#include "properties/devices/ax188001/naive_ax188001.hpp"

namespace canproof::naive_tcs {

inline Terminals terminals_of(const ax188001::Inputs& inputs) {
    Terminals at;
    for (std::size_t i = 0; i < 2; ++i) {
        at.uv[i] = inputs.tc_microvolts[i];
        at.open[i] = inputs.tc_open[i];
        at.hum_uv[i] = inputs.tc_hum[i];
    }
    at.mains_hz = inputs.mains_frequency;
    at.cold_junction_c = inputs.cold_junction;
    at.cpu_c = inputs.cpu_temperature;
    at.supply_v = inputs.supply;
    at.overrun = inputs.can_overrun;
    at.can = inputs.can_state;
    return at;
}

/// Returns the temperature that the device shows for channel `channel`, counted from 0.
inline float shown_celsius(const ax188001::Device& device, unsigned channel) {
    const std::uint32_t bits = device.objects().read(0x6100, static_cast<std::uint8_t>(channel + 1));
    float celsius = 0.0F;
    std::memcpy(&celsius, &bits, sizeof celsius);
    return celsius;
}

/// Returns the frames of one moment in the order of arbitration, also when the model sent them in two calls.
inline Ax188001::Sent in_order(Ax188001::Sent all) {
    for (std::size_t i = 1; i < all.size(); ++i) {
        const auto goes_before = [](const auto& a, const auto& b) {
            const bool boots = a.second == "77F#00" || b.second == "77F#00";
            return a.first == b.first && !boots && a.second.compare(0, 3, b.second, 0, 3) < 0;
        };
        for (std::size_t at = i; at > 0 && goes_before(all[at], all[at - 1]); --at) {
            std::swap(all[at], all[at - 1]);
        }
    }
    return all;
}

/// Compares the values of the channels, the mean, the cold junction and the fault detections.
template <typename Check>
void compare_values(const ax188001::Device& device, const Ax188001& model, const Check& check) {
    const auto read = [&](unsigned index, unsigned sub) {
        return device.objects().read(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
    };
    for (unsigned channel = 0; channel < 2; ++channel) {
        for (const unsigned index : {0x6100U, 0x7130U, 0x6150U, 0x5040U}) {
            check(read(index, channel + 1) == model.value(index, channel + 1), "value of a channel", index);
        }
        // 2010h (TC Input Microvolts) is an integer. When the exact voltage is near half a microvolt, both neighbouring
        // integers are right.
        const auto shown = static_cast<double>(static_cast<std::int32_t>(read(0x2010, channel + 1)));
        check(std::fabs(shown - model.scanner().shown(channel).uv) <= 0.5 + 1e-5, "voltage of a channel", 0x2010);
    }
    for (const unsigned index : {0x2100U, 0x2130U, 0x3100U, 0x3130U}) {
        check(read(index, 0) == model.value(index, 0), "mean or cold junction", index);
    }
}

/// Compares 1001h (error register) and 1003h (error list).
template <typename Check>
void compare_errors(const ax188001::Device& device, const Ax188001& model, const Check& check) {
    const auto& list = model.messages().list();
    check(device.objects().read(0x1001, 0) == model.messages().error_register(), "error register", 0x1001);
    check(device.objects().read(0x1003, 0) == list.size(), "number of errors", 0x1003);
    for (unsigned sub = 1; sub <= 9; ++sub) {
        check(
            device.objects().read(0x1003, static_cast<std::uint8_t>(sub)) == (sub <= list.size() ? list[sub - 1] : 0U),
            "error list", 0x1003);
    }
}

/// Compares gain and filter of the converters, and the NMT state.
template <typename Check>
void compare_outputs(const ax188001::Device& device, const Ax188001& model, const Check& check) {
    const auto& outputs = device.outputs();
    check(unsigned{outputs.adc_filter} == model.application().filter_hz, "filter of the converters", 0);
    for (std::size_t channel = 0; channel < 2; ++channel) {
        check(unsigned{outputs.tc_gain[channel]} == model.scanner().converter(channel).gain(), "gain of a channel", 0);
    }
    constexpr std::array<NmtState, 3> states{NmtState::pre_operational, NmtState::operational, NmtState::stopped};
    check(device.state() == states[static_cast<std::size_t>(model.state())], "state of the node", 0);
}

}  // namespace canproof::naive_tcs
