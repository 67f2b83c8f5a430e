// SPDX-License-Identifier: Apache-2.0
// Naive model of the whole AX130751: it computes everything again in each cycle of 1 ms and keeps no results. It is
// written from chapters 1, 3 and 4 of the manual and from the decisions of the register, and shares no code with the
// firmware.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "properties/devices/ax130751/naive_errors.hpp"
#include "properties/devices/ax130751/naive_relay.hpp"
#include "properties/devices/ax130751/naive_tables.hpp"
#include "properties/devices/ax130751/naive_writes.hpp"

namespace canproof::naive_ax130751 {

enum class Nmt { pre_operational, operational };

class Device {
  public:
    explicit Device(unsigned node) : node_{node} {}
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device() = default;

    /// Starts the device at power-on and at each reset node: unstored values are lost.
    void start_up() {
        parameters = stored_;
        starts_self_ = stored_.diagnostics.starts_self;
        has_left_ = false;
        for (Output& output : parameters.outputs) {
            output.command = 0;
        }
        parameters.write_states = {};
        for (Extra& extra : parameters.extras) {
            extra.value = 0;
        }
        blocks_ = Blocks{};
        shown = Shown{};
        terminals = {};
        errors = Errors{};
        silent_before_ = overdue_before_ = {};
        for (std::size_t n = 0; n < 2; ++n) {
            blocks_.outputs.at(n).reset(parameters.outputs.at(n).type);
        }
        points_.begin(parameters);
        measure();
        boot();
        start_itself();
        tell_faults();
    }
    /// Obeys an NMT command: 1 start, 128 pre-operational, 129 reset node, 130 reset communication.
    void command(int specifier) {
        if (specifier == 129) {
            return start_up();
        }
        if (specifier == 130) {
            parameters.communication = stored_.communication;
            has_left_ = has_left_ || state == Nmt::operational;
            boot();
            announce();
            return start_itself();
        }
        const Nmt wanted = specifier == 1 ? Nmt::operational : Nmt::pre_operational;
        if (wanted == state) {
            return;
        }
        has_left_ = has_left_ || state == Nmt::operational;
        state = wanted;
        rpdo_due_ = {};
        tpdo_due_ = {};
        for (std::size_t n = 0; n < 4 && state == Nmt::operational; ++n) {
            const Pdo& pdo = parameters.communication.transmit.at(n);
            if (pdo.valid && pdo.event != 0) {
                transmit(n);
            }
        }
    }
    /// Advances the time by one millisecond, and performs the cycle of this millisecond.
    void pass() {
        ++now;
        cycle();
        for (std::size_t n = 0; n < 4; ++n) {
            if (rpdo_due_.at(n) == now) {
                rpdo_due_.at(n) = 0;
                network_.overdue.at(n) = true;
            }
        }
        for (std::size_t n = 0; n < 4; ++n) {
            if (heartbeat_due_.at(n) == now) {
                heartbeat_due_.at(n) = 0;
                silent_.at(n) = true;
            }
        }
        announce();
        for (std::size_t n = 0; n < 4; ++n) {
            if (tpdo_due_.at(n) == now) {
                transmit(n);
            }
        }
    }
    /// Writes an entry as by SDO. Returns 0, or the abort code.
    std::uint32_t write(int index, int sub, int value) {
        const Sources sources{parameters, shown, network_};
        const std::uint32_t refusal = refusal_of(parameters, entries_, sources, {index, sub}, value);
        if (refusal != 0) {
            return refusal;
        }
        int& entry = *entries_.at({index, sub}).value;
        const int before = entry;
        entry = value;
        follow_write(parameters, {index, sub}, before);
        points_.follow(parameters, sources);
        if (index >= 0x1400 && index <= 0x1403) {
            const auto n = static_cast<std::size_t>(index - 0x1400);
            rpdo_due_.at(n) = 0;
            network_.overdue.at(n) = false;
            short_.at(n) = false;
            announce();
        } else if (index >= 0x1800 && index <= 0x1803 && value != before) {
            const auto n = static_cast<std::size_t>(index - 0x1800);
            const bool counts =
                state == Nmt::operational && parameters.communication.transmit.at(n).valid && value != 0;
            tpdo_due_.at(n) = counts ? now + static_cast<std::uint64_t>(value) : 0;
        }
        return 0;
    }
    /// Receives RPDO `number` (1 to 4). `bytes` are the values of its default mapping.
    void receive(int number, const std::vector<int>& bytes) {
        const auto n = static_cast<std::size_t>(number - 1);
        const Pdo& pdo = parameters.communication.receive.at(n);
        if (state != Nmt::operational || !pdo.valid) {
            return;
        }
        constexpr std::array<std::size_t, 4> lengths{5, 6, 6, 2};
        short_.at(n) = bytes.size() < lengths.at(n);
        if (!short_.at(n)) {
            take(number, bytes);
            network_.overdue.at(n) = network_.overdue.at(n) && pdo.event == 0;
            rpdo_due_.at(n) = pdo.event == 0 ? rpdo_due_.at(n) : now + static_cast<std::uint64_t>(pdo.event);
        }
        announce();
    }
    /// Receives a heartbeat of one of the nodes 5 to 8.
    void heartbeat(unsigned producer) {
        const int time = parameters.communication.heartbeat_ms.at(producer - 5);
        if (time != 0) {
            heartbeat_due_.at(producer - 5) = now + static_cast<std::uint64_t>(time);
            silent_.at(producer - 5) = false;
            announce();
        }
    }
    void store() {
        stored_ = parameters;
        starts_self_ = parameters.diagnostics.starts_self;
    }

    Parameters parameters;
    Shown shown;
    Inputs inputs;
    std::array<Terminals, 2> terminals;
    bool relay_on_nc{false};
    Errors errors;
    std::vector<Said> said;
    Nmt state{Nmt::pre_operational};
    std::uint64_t now{0};

    const Entries& entries() const { return entries_; }

  private:
    struct Blocks {
        Faults faults;
        std::array<NaiveTable, 10> tables;
        std::array<NaiveMath, 4> math;
        std::array<NaiveOutput, 2> outputs;
        NaiveRelay relay;
    };

    /// Restarts the communication, as each boot-up does. The outputs and the lookup tables, logic and math blocks
    /// continue.
    void boot() {
        network_ = Network{};
        short_ = {};
        silent_ = {};
        rpdo_due_ = {};
        tpdo_due_ = {};
        heartbeat_due_ = {};
        state = Nmt::pre_operational;
        said.push_back({now, 0x700 + node_, {0}});
    }
    /// Enters operational without a command when the stored value of 5555h (Start in Operational Mode) requires it.
    void start_itself() {
        if (starts_self_ != 0) {
            command(1);
        }
    }
    /// Measures supply and temperature. Without supply voltage, the relay connects the common pin to contact NC.
    void measure() {
        shown.supply = inputs.supply;
        shown.temperature = inputs.temperature;
        blocks_.faults.look(inputs, parameters.diagnostics);
        relay_on_nc = !powered();
    }
    bool powered() const { return inputs.supply >= 7.0F && inputs.supply <= 39.0F; }
    /// Evaluates all blocks in the order of section 1.1.
    void cycle() {
        measure();
        const Sources sources{parameters, shown, network_};
        for (std::size_t n = 0; n < 10; ++n) {
            const Table& table = parameters.tables.at(n);
            blocks_.tables.at(n).cycle(table, sources.read(table.source), now, shown.tables.at(n));
        }
        for (std::size_t n = 0; n < 3; ++n) {
            shown.logic.at(n) = evaluate(parameters.logic.at(n), sources);
        }
        for (std::size_t n = 0; n < 4; ++n) {
            shown.math.at(n) = blocks_.math.at(n).cycle(static_cast<int>(n + 1), parameters.math.at(n), sources);
        }
        const Diagnostics& limits = parameters.diagnostics;
        const bool stopped = std::exchange(has_left_, false) || state != Nmt::operational;
        const bool shutdown = !powered() || stopped || (blocks_.faults.supply() && limits.supply_shuts != 0) ||
                              (blocks_.faults.temperature() && limits.heat_shuts != 0);
        const Circumstances circumstances{shutdown, powered(), now};
        for (std::size_t n = 0; n < 2; ++n) {
            blocks_.outputs.at(n).cycle(n, parameters.outputs.at(n), sources, circumstances,
                                        static_cast<double>(inputs.load.at(n)), shown, terminals.at(n));
        }
        relay_on_nc = blocks_.relay.cycle(parameters.relay, sources, circumstances) || !powered();
        tell_faults();
    }
    void tell_faults() {
        errors.set(supply_error, blocks_.faults.supply(), now, 0x80 + node_, said);
        errors.set(temperature_error, blocks_.faults.temperature(), now, 0x80 + node_, said);
    }
    /// Reports communication errors. When an error begins, 1029h:1 (error behaviour) determines the new NMT state.
    void announce() {
        const auto any = [](const std::array<bool, 4>& flags) { return flags[0] || flags[1] || flags[2] || flags[3]; };
        network_.silent = any(silent_);
        for (std::uint32_t n = 0; n < 4; ++n) {
            errors.set(heartbeat_error | (5 + n) << 16U, silent_.at(n), now, 0x80 + node_, said);
        }
        errors.set(length_error, any(short_), now, 0x80 + node_, said);
        errors.set(time_out_error, any(network_.overdue), now, 0x80 + node_, said);
        bool begins = false;
        for (std::size_t n = 0; n < 4; ++n) {
            begins = begins || (silent_.at(n) && !silent_before_.at(n)) ||
                     (network_.overdue.at(n) && !overdue_before_.at(n));
        }
        silent_before_ = silent_;
        overdue_before_ = network_.overdue;
        if (begins && parameters.communication.error_behaviour == 0 && state == Nmt::operational) {
            command(128);
        }
    }
    void take(int number, const std::vector<int>& bytes) {
        const auto word = [&](std::size_t at) {
            const int value = bytes.at(at) + 0x100 * bytes.at(at + 1);
            return value >= 0x8000 ? value - 0x10000 : value;
        };
        if (number == 1) {
            parameters.outputs[0].command = word(0);
            parameters.outputs[1].command = word(2);
            parameters.write_states[2] = bytes.at(4);
        } else if (number == 4) {
            parameters.write_states[0] = bytes.at(0);
            parameters.write_states[1] = bytes.at(1);
        } else {
            for (std::size_t n = 0; n < 3; ++n) {
                parameters.extras.at(n + (number == 2 ? 0U : 3U)).value = word(2 * n);
            }
        }
    }
    /// Sends TPDO n + 1. TPDO1, TPDO2 and TPDO4 have the default mapping. TPDO3, which the test has remapped, carries
    /// results of math and logic blocks: 4030h:1, 3320h:1, 3310h:1 and 4030h:4.
    void transmit(std::size_t n) {
        std::vector<int> data;
        const auto add = [&data](std::uint32_t value, int bytes) {
            for (int i = 0; i < bytes; ++i) {
                data.push_back(static_cast<int>(value >> (8U * static_cast<unsigned>(i)) & 0xFFU));
            }
        };
        const auto word = [&add](int value) { add(static_cast<std::uint32_t>(value), 2); };
        if (n == 0) {
            word(shown.feedback[0]);
            word(shown.feedback[1]);
        } else if (n == 1) {
            word(shown.target[0]);
            word(shown.target[1]);
        } else if (n == 2) {
            word(shown.math[0]);
            word(shown.logic[0].output);
            add(static_cast<std::uint32_t>(shown.logic[0].selected), 1);
            word(shown.math[3]);
        } else {
            add(bits_of(shown.supply), 4);
            add(bits_of(shown.temperature), 4);
        }
        said.push_back({now, 0x180 + 0x100 * static_cast<unsigned>(n) + node_, data});
        tpdo_due_.at(n) = now + static_cast<std::uint64_t>(parameters.communication.transmit.at(n).event);
    }
    /// Returns the bits of an IEEE 754 single precision number.
    static std::uint32_t bits_of(float value) {
        if (std::isnan(value)) {
            return 0x7FC00000U;
        }
        if (!(value > 0.0F) && !(value < 0.0F)) {
            return 0;
        }
        int exponent = 0;
        const float fraction = std::frexp(std::fabs(value), &exponent);  // in the range from 0.5 to 1
        const auto mantissa = static_cast<std::uint32_t>(std::ldexp(fraction, 24)) & 0x7FFFFFU;
        return (value < 0.0F ? 0x80000000U : 0U) | static_cast<std::uint32_t>(exponent + 126) << 23U | mantissa;
    }

    unsigned node_;
    Parameters stored_;
    int starts_self_{0};    ///< the stored value of 5555h (Start in Operational Mode)
    bool has_left_{false};  ///< the node has left operational since the last cycle
    Entries entries_{entries_of(parameters)};
    Blocks blocks_;
    Network network_;
    FirstPoints points_;
    std::array<bool, 4> short_{};
    std::array<std::uint64_t, 4> rpdo_due_{};  ///< time at which RPDO n + 1 is overdue; 0: not monitored
    std::array<std::uint64_t, 4> tpdo_due_{};
    std::array<bool, 4> silent_{};
    std::array<bool, 4> silent_before_{};
    std::array<bool, 4> overdue_before_{};
    std::array<std::uint64_t, 4> heartbeat_due_{};
};

}  // namespace canproof::naive_ax130751
