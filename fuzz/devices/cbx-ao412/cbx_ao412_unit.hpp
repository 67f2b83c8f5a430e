// SPDX-License-Identifier: Apache-2.0
// Describes the CAN-CBX-AO412 for DeviceWorld (device_world.hpp).
#pragma once

#include <array>
#include <cmath>

#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "fuzz/support/require.hpp"

namespace canproof::fuzz {

class CbxAo412Unit {
  public:
    using Device = cbx_ao412::Device;
    using Inputs = cbx_ao412::Inputs;
    using FactoryData = cbx_ao412::FactoryData;
    static constexpr std::size_t memory_size = 1024;
    static constexpr std::uint8_t bus_node = 3;  ///< node-ID of this device on the bus of bus_fuzz.cpp
    static constexpr bool has_lss = false;
    /// Bit n: RPDO n + 1 answers remote frames; only RPDO2 does (7.7.2).
    static constexpr std::uint8_t answers_remote = 0x02;

    static void prepare(Inputs&) {}
    /// Returns whether the device works. If its coding switches give no valid node-ID, only its LEDs work.
    static bool has_values(const Device& device) { return device.node_id() >= 1 && device.node_id() <= 127; }
    static bool shows_beyond_limits(const ObjectDictionary&, const EntryRef&) { return false; }
    static bool may_also_send(const Frame&) { return false; }
    /// Returns whether an output keeps its value over a reset of the node. This happens during an internal failure if
    /// the output's error mode (6443h) is 2 (7.10.3).
    static bool keeps_outputs(const Device& device, const Inputs& inputs) {
        bool keeps = false;
        for (std::uint8_t number = 1; number <= 4; ++number) {
            keeps = keeps || read(device, 0x6443, number) == 2;
        }
        return keeps && (inputs.internal_fault || inputs.hardware_fault);
    }

    /// Checks that no output exceeds 10.205 V (4.3.1). During an internal failure an uncalibrated output keeps its
    /// value, or has 0 V or its error value, whatever is written (7.10.3).
    void check(const Device& device, const Inputs& inputs, bool) {
        check_leds(device, inputs);
        for (std::uint8_t number = 1; number <= 4; ++number) {
            const float volts = device.outputs().aout[number - 1U];
            require(volts >= -10.2046F && volts <= 10.2046F);
            Seen& seen = seen_[number - 1U];
            const std::uint32_t calibration = read(device, 0x2404, number) << 16U | read(device, 0x2405, number);
            const bool failed = inputs.internal_fault || inputs.hardware_fault;
            if (failed && calibration == 0U && seen.calibration == 0U) {
                const bool stays = volts == seen.volts || volts == 0.0F;
                require(stays || std::fabs(volts - error_volts(device, number)) < 0.001F);
            }
            seen = Seen{volts, calibration};
        }
    }

  private:
    struct Seen {
        float volts{0.0F};
        std::uint32_t calibration{0U};
    };
    /// Checks each LED in those device states in which it does not flash (3.2).
    static void check_leds(const Device& device, const Inputs& inputs) {
        const auto& outputs = device.outputs();
        require(outputs.led_p == has_values(device));
        require(device.state() != NmtState::operational || outputs.led_s);
        require((has_values(device) && inputs.can_state < 3) || outputs.led_e);
        const bool guard_error = (device.objects().read(0x1001, 0) & 0x10U) != 0U;
        require(!has_values(device) || inputs.can_state != 0 || guard_error || !outputs.led_e);
    }
    static std::uint32_t read(const Device& device, std::uint16_t index, std::uint8_t sub) {
        return device.objects().read(index, sub) & 0xFFFFU;
    }
    /// Returns the output voltage for the upper 16 bits of 6444h (error value). Eight codes are one step of 2.492 mV
    /// (7.10.2.2, 7.10.4).
    static float error_volts(const Device& device, std::uint8_t number) {
        const auto code = static_cast<std::int16_t>(device.objects().read(0x6444, number) >> 16U);
        const float step = std::floor((static_cast<float>(code) + 4.0F) / 8.0F);
        return std::fmin(std::fmax(step, -4095.0F), 4095.0F) * 0.00249194F;
    }

    std::array<Seen, 4> seen_{};
};

}  // namespace canproof::fuzz
