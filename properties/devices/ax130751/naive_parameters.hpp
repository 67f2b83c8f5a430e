// SPDX-License-Identifier: Apache-2.0
// The parameters of the AX130751 that its naive model uses, with index, length and default value, written from chapter
// 3 of the manual. Shares no code with the firmware.
#pragma once

#include <array>
#include <map>
#include <utility>

namespace canproof::naive_ax130751 {

/// A control source: its kind (`source`) and its number within this kind (Tables 4A and 4B).
struct Choice {
    int source{0};
    int number{0};
};

/// The parameters of one universal output (sections 3.3.1 to 3.3.14, 3.4.1 to 3.4.3, 3.4.20 to 3.4.33).
struct Output {
    int type{10};
    Choice control{1, 0};
    int control_response{1};
    Choice enable;
    int enable_response{3};
    Choice override_input;
    int override_response{0};
    int override_value{0};
    int ramp_up{1000};
    int ramp_down{1000};
    int frequency{25000};
    int pv_digits{3};
    int fv_digits{3};
    int pv_1{0};
    int pv_2{5000};
    int fv_1{0};
    int fv_2{5000};
    int fault_mode{1};
    int fault_value{0};
    int command{0};  ///< 7300h (AO Output Process Value)
    int blink{500};
    int range{0};
    int polarity{0};
    int digital_fault_mode{1};
    int fault_state{1};
};

/// The parameters of the relay (sections 3.4.4 to 3.4.19).
struct Relay {
    int polarity{1};
    int blink{500};
    Choice control{1, 3};
    Choice unlatch;
    Choice enable;
    int enable_response{0};
    Choice override_input;
    int override_response{0};
    int override_state{0};
    int delays{0};
    int on_delay{0};
    int off_delay{0};
};

/// The parameters of an extra received value (sections 3.4.34 to 3.4.37).
struct Extra {
    int value{0};
    int digits{1};
    int pv_1{0};
    int pv_2{0};
};

/// The parameters of a lookup table (sections 3.4.38 to 3.4.45).
struct Table {
    Choice source;
    int repeat{0};
    int x_digits{0};
    int y_digits{0};
    std::array<int, 11> response{0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    std::array<int, 11> x{0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
    std::array<int, 11> y{0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
};

struct ConditionChoice {
    Choice one;
    Choice other;
    int comparison{0};
};

/// The parameters of a logic block (sections 3.4.47 to 3.4.60).
struct Logic {
    int enable{0};
    std::array<int, 3> tables{};
    std::array<int, 3> operators{1, 1, 0};
    std::array<std::array<ConditionChoice, 3>, 3> conditions;
};

/// The parameters of one input of a math block (sections 3.4.61 to 3.4.73).
struct MathChoice {
    Choice source;
    int function{0};
    int digits{2};
    int scaling_1{0};
    int scaling_2{10000};
    int gain{100};
};
struct MathBlock {
    int enable{0};
    int pv_1{0};
    int pv_2{10000};
    int digits{2};
    std::array<MathChoice, 4> inputs;
    std::array<int, 3> operators{12, 12, 12};
};

/// The parameters of the diagnostics (sections 3.4.74 to 3.4.86).
struct Diagnostics {
    int watches_supply{1};
    int under{8};
    int over{35};
    int supply_hysteresis{5};
    int supply_shuts{1};
    int watches_heat{1};
    int hot{85};
    int heat_hysteresis{25};
    int heat_shuts{1};
    int updates{1};      ///< 5550h (Enable Automatic Updates)
    int starts_self{0};  ///< 5555h (Start in Operational Mode)
};

/// The parameters of a PDO that the model uses (sections 3.2.13 to 3.2.15). The identifiers are those of the
/// pre-defined connection set.
struct Pdo {
    bool valid{false};
    int event{0};
};

/// The parameters of the communication (sections 3.2.9 and 3.2.13 to 3.2.15).
struct Communication {
    int error_behaviour{1};             ///< 1029h:1 (error behaviour)
    std::array<int, 4> heartbeat_ms{};  ///< times in 1016h:1 to 1016h:4, for the nodes 5 to 8; 0: not monitored
    std::array<Pdo, 4> receive{{{true, 0}, {false, 0}, {false, 0}, {true, 0}}};
    std::array<Pdo, 4> transmit{{{true, 100}, {false, 0}, {false, 0}, {false, 0}}};
};

struct Parameters {
    std::array<Output, 2> outputs;
    Relay relay;
    std::array<int, 3> write_states{};  ///< 6220h (DO Write State 1 Output Line)
    std::array<Extra, 6> extras;
    std::array<Table, 10> tables;
    std::array<Logic, 3> logic;
    std::array<MathBlock, 4> math;
    Diagnostics diagnostics;
    Communication communication;

    Parameters() {
        outputs[0].control.number = 1;
        outputs[1].control.number = 2;
        for (int block = 0; block < 3; ++block) {
            logic.at(static_cast<std::size_t>(block)).tables = {3 * block + 1, 3 * block + 2, 3 * block + 3};
        }
    }
};

/// One entry of the dictionary: a pointer to its value, and its length in bytes.
struct Entry {
    int* value{nullptr};
    int bytes{0};
};
using Address = std::pair<int, int>;  ///< index and sub-index
using Entries = std::map<Address, Entry>;

inline void add_choice(Entries& all, int index, int sub, Choice& choice) {
    all[{index, sub}] = {&choice.source, 1};
    all[{index + 1, sub}] = {&choice.number, 1};
}

inline void add_output(Entries& all, int sub, Output& of) {
    add_choice(all, 0x2340, sub, of.control);
    add_choice(all, 0x2350, sub, of.enable);
    add_choice(all, 0x2360, sub, of.override_input);
    const std::map<int, Entry> others{
        {0x6310, {&of.type, 2}},
        {0x2342, {&of.control_response, 1}},
        {0x2352, {&of.enable_response, 1}},
        {0x2362, {&of.override_response, 1}},
        {0x2300, {&of.override_value, 2}},
        {0x2330, {&of.ramp_up, 2}},
        {0x2331, {&of.ramp_down, 2}},
        {0x2380, {&of.frequency, 2}},
        {0x6302, {&of.pv_digits, 1}},
        {0x6332, {&of.fv_digits, 1}},
        {0x7320, {&of.pv_1, 2}},
        {0x7322, {&of.pv_2, 2}},
        {0x7321, {&of.fv_1, 2}},
        {0x7323, {&of.fv_2, 2}},
        {0x6340, {&of.fault_mode, 1}},
        {0x7341, {&of.fault_value, 2}},
        {0x7300, {&of.command, 2}},
        {0x2223, {&of.blink, 2}},
        {0x2240, {&of.range, 1}},
        {0x2241, {&of.polarity, 1}},
        {0x6250, {&of.digital_fault_mode, 1}},
        {0x6260, {&of.fault_state, 1}},
    };
    for (const auto& [index, entry] : others) {
        all[{index, sub}] = entry;
    }
}

inline void add_relay(Entries& all, Relay& of) {
    add_choice(all, 0x2260, 1, of.control);
    add_choice(all, 0x2270, 1, of.unlatch);
    add_choice(all, 0x2280, 1, of.enable);
    add_choice(all, 0x2290, 1, of.override_input);
    all[{0x2242, 1}] = {&of.polarity, 1};
    all[{0x2250, 1}] = {&of.blink, 2};
    all[{0x2282, 1}] = {&of.enable_response, 1};
    all[{0x2292, 1}] = {&of.override_response, 1};
    all[{0x2293, 1}] = {&of.override_state, 1};
    all[{0x22A0, 1}] = {&of.delays, 1};
    all[{0x22A1, 1}] = {&of.on_delay, 4};
    all[{0x22A2, 1}] = {&of.off_delay, 4};
}

inline void add_extra(Entries& all, int sub, Extra& of) {
    all[{0x2500, sub}] = {&of.value, 2};
    all[{0x2502, sub}] = {&of.digits, 1};
    all[{0x2520, sub}] = {&of.pv_1, 2};
    all[{0x2522, sub}] = {&of.pv_2, 2};
}

/// Returns the index at which the objects of a lookup table begin: 3010h for table 1 to 3090h for table 9, 3100h for
/// table 10.
inline int table_index(int number) {
    return number == 10 ? 0x3100 : 0x3000 + 0x10 * number;
}

inline void add_table(Entries& all, int number, Table& of) {
    const int base = table_index(number);
    add_choice(all, base, 0, of.source);
    all[{base + 2, 0}] = {&of.repeat, 1};
    all[{base + 3, 0}] = {&of.x_digits, 1};
    all[{base + 4, 0}] = {&of.y_digits, 1};
    for (int point = 1; point <= 11; ++point) {
        const auto at = static_cast<std::size_t>(point - 1);
        all[{base + 5, point}] = {&of.response.at(at), 1};
        all[{base + 6, point}] = {&of.x.at(at), 4};
        all[{base + 7, point}] = {&of.y.at(at), 2};
    }
}

inline void add_logic(Entries& all, int number, Logic& of) {
    const int base = 0x3300 + 0x100 * number;
    all[{0x3300, number}] = {&of.enable, 1};
    for (int function = 1; function <= 3; ++function) {
        const auto at = static_cast<std::size_t>(function - 1);
        all[{base + 1, function}] = {&of.tables.at(at), 1};
        all[{base + 2, function}] = {&of.operators.at(at), 1};
        for (int number_of = 1; number_of <= 3; ++number_of) {
            ConditionChoice& condition = of.conditions.at(at).at(static_cast<std::size_t>(number_of - 1));
            const int index = base + 0x10 * function + number_of;
            all[{index, 1}] = {&condition.one.source, 1};
            all[{index, 2}] = {&condition.one.number, 1};
            all[{index, 3}] = {&condition.other.source, 1};
            all[{index, 4}] = {&condition.other.number, 1};
            all[{index, 5}] = {&condition.comparison, 1};
        }
    }
}

inline void add_math(Entries& all, int number, MathBlock& of) {
    const int base = 0x4000 + 0x100 * number;
    all[{0x4000, number}] = {&of.enable, 1};
    all[{0x4021, number}] = {&of.pv_1, 2};
    all[{0x4023, number}] = {&of.pv_2, 2};
    all[{0x4032, number}] = {&of.digits, 1};
    for (int input = 1; input <= 4; ++input) {
        MathChoice& one = of.inputs.at(static_cast<std::size_t>(input - 1));
        add_choice(all, base, input, one.source);
        all[{base + 0x02, input}] = {&one.function, 1};
        all[{base + 0x03, input}] = {&one.digits, 1};
        all[{base + 0x20, input}] = {&one.scaling_1, 2};
        all[{base + 0x22, input}] = {&one.scaling_2, 2};
        all[{base + 0x40, input}] = {&one.gain, 1};
    }
    for (int function = 1; function <= 3; ++function) {
        all[{base + 0x50, function}] = {&of.operators.at(static_cast<std::size_t>(function - 1)), 1};
    }
}

inline void add_diagnostics(Entries& all, Diagnostics& of) {
    all[{0x5021, 0}] = {&of.watches_supply, 1};
    all[{0x5022, 0}] = {&of.under, 1};
    all[{0x5023, 0}] = {&of.over, 1};
    all[{0x5024, 0}] = {&of.supply_hysteresis, 1};
    all[{0x5025, 0}] = {&of.supply_shuts, 1};
    all[{0x5031, 0}] = {&of.watches_heat, 1};
    all[{0x5032, 0}] = {&of.hot, 1};
    all[{0x5033, 0}] = {&of.heat_hysteresis, 1};
    all[{0x5034, 0}] = {&of.heat_shuts, 1};
    all[{0x5550, 0}] = {&of.updates, 1};
    all[{0x5555, 0}] = {&of.starts_self, 1};
}

/// Returns all entries of the dictionary that the model has. They point into `all`, so `all` must not be moved.
inline Entries entries_of(Parameters& all) {
    Entries entries;
    for (int n = 1; n <= 2; ++n) {
        add_output(entries, n, all.outputs.at(static_cast<std::size_t>(n - 1)));
    }
    add_relay(entries, all.relay);
    for (int n = 1; n <= 3; ++n) {
        entries[{0x6220, n}] = {&all.write_states.at(static_cast<std::size_t>(n - 1)), 1};
        add_logic(entries, n, all.logic.at(static_cast<std::size_t>(n - 1)));
    }
    for (int n = 1; n <= 6; ++n) {
        add_extra(entries, n, all.extras.at(static_cast<std::size_t>(n - 1)));
    }
    for (int n = 1; n <= 10; ++n) {
        add_table(entries, n, all.tables.at(static_cast<std::size_t>(n - 1)));
    }
    for (int n = 1; n <= 4; ++n) {
        add_math(entries, n, all.math.at(static_cast<std::size_t>(n - 1)));
        entries[{0x13FF + n, 5}] = {&all.communication.receive.at(static_cast<std::size_t>(n - 1)).event, 2};
        entries[{0x17FF + n, 5}] = {&all.communication.transmit.at(static_cast<std::size_t>(n - 1)).event, 2};
    }
    add_diagnostics(entries, all.diagnostics);
    entries[{0x1029, 1}] = {&all.communication.error_behaviour, 1};
    return entries;
}

}  // namespace canproof::naive_ax130751
