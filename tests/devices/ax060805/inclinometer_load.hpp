// SPDX-License-Identifier: Apache-2.0
// Test fixture of the load tests: an operational AX060805 whose timers all have one period. The functions below begin
// and end its errors.
#pragma once

#include <cmath>

#include "tests/devices/ax060805/inclinometer_functions.hpp"
#include "tests/support/disturbed_bus.hpp"

namespace canproof::test {

class InclinometerLoad : public DisturbedBus<InclinometerFunctions> {
  protected:
    static constexpr std::uint32_t period_ms = 400;          ///< 80 samples, more than a window of 64 has
    static constexpr std::uint32_t not_valid = 0x80000000U;  ///< bit 31 of the COB-ID of a PDO

    /// Sets 1029h (error behaviour): an error does not change the NMT state.
    void stay_in_state() {
        for (std::uint8_t cause = 1; cause <= 2; ++cause) {
            write(0x1029, cause, 1, 1);
        }
    }
    /// Watches the heartbeat of node 11, the guarding requests and RPDO1: each is late after one period.
    void watch_bus() {
        write(0x1016, 1, 0x000B0000U + period_ms, 4);
        write(0x100C, 0, period_ms, 2);
        write(0x100D, 0, 1, 1);
        write(0x1400, 5, period_ms, 2);
    }
    /// Maps `lines` into RPDO `number` (1 to 4) and gives it a COB-ID.
    void map_rpdo(int number, std::uint32_t cob_id, const std::vector<std::uint32_t>& lines) {
        map(static_cast<std::uint16_t>(0x13FF + number), cob_id, lines);
    }
    /// Sends TPDO `number` (1 to 4) in each period. Its values are function results in falling order, which lie apart
    /// in the memory of the device.
    void map_tpdo(int number, std::uint32_t cob_id) {
        map(static_cast<std::uint16_t>(0x17FF + number), cob_id, {0x30000410, 0x30000310, 0x30000210, 0x30000110});
        write(static_cast<std::uint16_t>(0x17FF + number), 5, period_ms, 2);
    }
    /// Lets the device receive the heartbeat of node 11, RPDO1 and a guarding request, which a producer of heartbeats
    /// ignores.
    void hear() {
        send_alone("70B#05");
        send_alone("27F#0000000000000000");
        send_alone("77F#R");
    }
    /// Sets whether the device loses frames, and its temperature in °C.
    void suffer(bool loses_frames, float temperature) {
        inputs.can_overrun = loses_frames;
        inputs.sensor_temperature = temperature;
        set_inputs();
    }
    /// Returns the number of emergency messages of node 127.
    static std::size_t emergencies(const Frames& frames) {
        std::size_t count = 0;
        for (const std::string& frame : frames) {
            count += frame.find("0FF#") != std::string::npos ? 1U : 0U;
        }
        return count;
    }

  private:
    void map(std::uint16_t parameters, std::uint32_t cob_id, const std::vector<std::uint32_t>& lines) {
        const auto mapping = static_cast<std::uint16_t>(parameters + 0x200);
        write(parameters, 1, not_valid | cob_id, 4);
        write(mapping, 0, 0, 1);
        for (std::size_t line = 0; line < lines.size(); ++line) {
            write(mapping, static_cast<std::uint8_t>(line + 1), lines[line], 4);
        }
        write(mapping, 0, static_cast<std::uint32_t>(lines.size()), 1);
        write(parameters, 1, cob_id, 4);
    }
};

}  // namespace canproof::test
