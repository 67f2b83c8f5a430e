// SPDX-License-Identifier: Apache-2.0
// Compares every value that the AX060805 measures or computes with a naive model (a second, simple implementation), for
// any configuration, any position and any errors.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "generated/ax060805/requirements.hpp"
#include "properties/devices/ax060805/two_inclinometers.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// Returns a number from `low` to `high` - 1 with the same distribution in every test case. Without resize(),
/// RapidCheck begins with small numbers.
int between(int low, int high) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
}

/// Returns the acceleration in g in any position. Sometimes it is an edge case: X vertical, upside down, hardly any
/// gravity, or beyond the range of the sensor.
NaiveVector any_acceleration() {
    if (between(0, 5) == 0) {
        return *rc::gen::element(NaiveVector{1.0, 0.0, 0.0}, NaiveVector{-1.0, 0.0, 0.0}, NaiveVector{0.0, 0.0, 1.0},
                                 NaiveVector{0.0, 1.0, 0.0}, NaiveVector{0.03125, 0.0, 0.03125},
                                 NaiveVector{0.0, 0.0, 0.0}, NaiveVector{16.0, 0.0, -1.0},
                                 NaiveVector{16.125, 0.0, -1.0}, NaiveVector{0.0, -16.125, -1.0},
                                 NaiveVector{0.0, 1.0, 16.125});
    }
    const double pitch = naive_radians(between(-9000, 9001) / 100.0 + 0.0042);
    const double roll = naive_radians(between(-18000, 18001) / 100.0 + 0.0042);
    const double size = *rc::gen::element(1.0, 1.0, 0.5, 1.75, 0.09, 0.11);
    const auto rounded = [](double value) { return static_cast<double>(static_cast<float>(value)); };
    return {rounded(size * std::sin(pitch)), rounded(-size * std::sin(roll) * std::cos(pitch)),
            rounded(-size * std::cos(roll) * std::cos(pitch))};
}

NaiveFelt any_feeling(const NaiveFelt& before) {
    NaiveFelt felt = before;
    switch (between(0, 6)) {
        case 0:
            felt.sensor_temperature = *rc::gen::element(25.0, -40.0, -40.125, 125.0, 125.125, 20.5, -0.5, std::nan(""));
            break;
        case 1:
            felt.supply = *rc::gen::element(0.0, -0.125, 70.0, 70.125, 24.5);
            felt.processor_temperature = *rc::gen::element(-50.0, -50.125, 150.0, 150.125, 30.25);
            break;
        case 2:
            felt.fault = *rc::gen::arbitrary<bool>();
            break;
        default:
            felt.acceleration = any_acceleration();
            break;
    }
    return felt;
}

double any_real() {
    return between(-400, 401) / *rc::gen::element(1.0, 4.0);
}

/// Returns a write to a parameter of any function block. Blocks with low numbers are more frequent.
Setting any_function_setting() {
    const auto function = static_cast<unsigned>(*rc::gen::element(0, 0, 0, 1, 1, 2, 9));
    const auto sub = static_cast<std::uint8_t>(between(1, 3));
    const auto at = static_cast<std::uint16_t>(0x3010 + 0x10U * function);
    const auto of_function = static_cast<std::uint8_t>(function + 1U);
    const auto plus = [at](unsigned more) { return static_cast<std::uint16_t>(at + more); };
    switch (between(0, 12)) {
        case 0:
        case 1:
        case 2:
            return {at, sub, 1, static_cast<double>(between(0, 29))};
        case 3:
            return {plus(1), sub, 1, static_cast<double>(between(0, 2))};
        case 4:
            return {plus(2), sub, 0, any_real()};
        case 5:
            return {plus(3), sub, 1, static_cast<double>(between(0, 4))};
        case 6:
            return {plus(4), sub, 0, any_real()};
        case 7:
            return {plus(5), sub, 0, any_real()};
        case 8:
            return {0x300B, of_function, 0, any_real()};
        case 9:
            return {0x300C, of_function, 0, any_real()};
        default:
            return {0x300A, of_function, 1, static_cast<double>(between(0, 21))};
    }
}

Setting any_angle_setting() {
    const auto sub = static_cast<std::uint8_t>(between(1, 4));
    switch (between(0, 12)) {
        case 0:
            return {0x2002, 0, 1, static_cast<double>(between(0, 2))};
        case 1:
            return {0x2003, 0, 1, static_cast<double>(*rc::gen::element(1, 5, 20, 50))};
        case 2:
            return {0x2010, sub, 2, static_cast<double>(*rc::gen::element(1, 10, 100, 1000))};
        case 3:
            return {*rc::gen::element<std::uint16_t>(0x2011, 0x2031), sub, 1, static_cast<double>(between(0, 2))};
        case 4:
            return {*rc::gen::element<std::uint16_t>(0x2020, 0x2040), sub, 0, any_real()};
        case 5:
        case 6:
            return {0x2030, sub, 2, static_cast<double>(*rc::gen::element(1, 10, 100, 1000))};
        case 7:
            return {0x2050, sub, 1, static_cast<double>(between(0, 3))};
        case 8:
            return {0x2051, sub, 2, static_cast<double>(*rc::gen::element(1, 2, 5, 64, 65, 150))};
        case 9:
            return {0x2052, 0, 2, static_cast<double>(*rc::gen::element(1, 3, 5, 7, 12))};
        case 10:
            return {0x2100, 0, 1, static_cast<double>(between(0, 2))};
        default:
            return {*rc::gen::element<std::uint16_t>(0x2200, 0x2210), 0, 0,
                    *rc::gen::element(0.0, 10.25, -30.5, 89.0, 45.0, -75.125)};
    }
}

Setting any_other_setting() {
    const auto sub = static_cast<std::uint8_t>(between(1, 4));
    switch (between(0, 9)) {
        case 0:
        case 1:
            return {0x2300, 0, 1, static_cast<double>(between(0, 2))};
        case 2:
            return {0x2501, sub, 2, static_cast<double>(*rc::gen::element(10, 100, 500, 1000))};
        case 3:
            return {0x2502, sub, 0, any_real()};
        case 4:
            return {0x4070, 0, 0, any_real()};
        case 5:
            return {0x4080, 0, 4,
                    static_cast<double>(*rc::gen::element<std::uint32_t>(0, 1, 5, 40, 65535, 4294967295U))};
        case 6:
            return {0x1029, static_cast<std::uint8_t>(between(1, 3)), 1, static_cast<double>(between(0, 2))};
        case 7:
            return {0x1400, 5, 2, static_cast<double>(*rc::gen::element(0, 12, 20))};
        default:
            return {*rc::gen::element<std::uint16_t>(0x1800, 0x1801, 0x1802), 5, 2,
                    static_cast<double>(*rc::gen::element(0, 3, 10, 17))};
    }
}

/// The topic of a test case: most parameters that the case writes belong to this topic.
enum class Topic { angles, functions, others };

Setting any_setting(Topic topic) {
    const Topic one = between(0, 4) != 0 ? topic : *rc::gen::element(Topic::angles, Topic::functions, Topic::others);
    return one == Topic::angles      ? any_angle_setting()
           : one == Topic::functions ? any_function_setting()
                                     : any_other_setting();
}

/// Sets an additional filter with a window of so few samples that a test case can fill the window.
void set_filter(TwoInclinometers& both) {
    const auto angle = static_cast<std::uint8_t>(between(1, 4));
    both.set({0x2050, angle, 1, static_cast<double>(between(1, 3))});
    both.set({0x2051, angle, 2, static_cast<double>(*rc::gen::element(2, 3, 4, 7, 70))});
    both.set({0x2052, 0, 2, static_cast<double>(*rc::gen::element(1, 3, 7))});
}

/// Sets a function block with sources and an operation. Random writes of single parameters would rarely give a complete
/// block.
void set_function(TwoInclinometers& both) {
    const auto function = static_cast<unsigned>(between(0, 10));
    const auto at = static_cast<std::uint16_t>(0x3010 + 0x10U * function);
    for (const std::uint8_t sub : {std::uint8_t{1}, std::uint8_t{2}}) {
        const bool is_measured = between(0, 2) == 0;
        both.set({at, sub, 1, static_cast<double>(is_measured ? between(1, 10) : between(1, 29))});
    }
    both.set({0x300A, static_cast<std::uint8_t>(function + 1U), 1, static_cast<double>(between(1, 21))});
}

/// Sets the resolution to thousandths of degrees and of g.
void set_finest_digits(TwoInclinometers& both) {
    for (const std::uint16_t index : {std::uint16_t{0x2010}, std::uint16_t{0x2030}}) {
        for (std::uint8_t sub = 1; sub <= 3; ++sub) {
            both.set({index, sub, 2, 1000.0});
        }
    }
}

NaiveUnit any_unit() {
    NaiveUnit unit;
    unit.range = *rc::gen::element(0, 0, 1, 2);
    if (between(0, 3) == 0) {
        unit.calibration = {*rc::gen::element(0.5, -1.25), *rc::gen::element(0.75, -2.0)};
    }
    return unit;
}

void set_what_the_topic_needs(TwoInclinometers& both, Topic topic) {
    if (topic == Topic::angles) {
        set_filter(both);
    } else if (topic == Topic::functions) {
        set_function(both);
    } else {
        both.command(0x01);
    }
}

/// Reverses the sign of some angles and accelerations in the device and in the model. Then sets up one function block,
/// or four function blocks when the topic is `functions`.
void begin(TwoInclinometers& both, Topic topic) {
    for (std::uint8_t sub = 1; sub <= 3; ++sub) {
        both.set({0x2011, sub, 1, static_cast<double>(between(0, 2))});
        both.set({0x2031, sub, 1, static_cast<double>(between(0, 2))});
    }
    for (int functions = topic == Topic::functions ? 4 : 1; functions > 0; --functions) {
        set_function(both);
    }
}

void take_step(TwoInclinometers& both, NaiveFelt& felt, Topic topic) {
    switch (*rc::gen::weightedElement<int>({{6, 0}, {8, 1}, {2, 2}, {1, 3}, {1, 4}, {1, 5}, {3, 6}, {2, 7}, {1, 8}})) {
        case 0:
            felt = any_feeling(felt);
            both.feel(felt);
            break;
        case 1:
            both.set(any_setting(topic));
            break;
        case 2:
            both.send_values({between(-1000, 1000), between(-3, 4), between(-32768, 32768)},
                             *rc::gen::element<std::uint8_t>(6, 6, 6, 8, 5, 0));
            break;
        case 3:
            both.command(*rc::gen::element<std::uint8_t>(0x01, 0x01, 0x80));
            break;
        case 4:
            both.lose_frames(*rc::gen::arbitrary<bool>());
            break;
        case 5:
            both.clear_list();
            break;
        case 7:
            both.reset();
            break;
        case 8:
            both.store();
            break;
        default:
            set_what_the_topic_needs(both, topic);
            break;
    }
}

}  // namespace

RC_GTEST_PROP(InclinometerModelLaw, DeviceAgreesWithTheNaiveModel, ()) {
    verifies<req::INC_FV_001, req::INC_FV_004, req::INC_FV_008, req::INC_FV_009, req::INC_FV_005, req::INC_FV_007,
             req::INC_FV_011, req::INC_FOM_001, req::INC_LATENCY_001, req::INC_SIG_005, req::INC_BIN_001,
             req::INC_BIN_012, req::INC_BIN_013, req::INC_BIN_009, req::INC_BIN_016, req::INC_RPDO_001,
             req::INC_RPDO_002, req::INC_RPDO_003, req::INC_AVG_004, req::INC_AVG_005, req::INC_AVG_007,
             req::INC_AVG_012, req::INC_AVG_013, req::INC_INSTALL_001, req::INC_INSTALL_003, req::INC_ERR_005,
             req::INC_ERR_006, req::INC_ERR_011, req::INC_PDO_002>("property");
    TwoInclinometers both{any_unit()};
    if (between(0, 3) != 0) {
        set_finest_digits(both);
    }
    const auto topic = *rc::gen::element(Topic::angles, Topic::angles, Topic::functions, Topic::others);
    begin(both, topic);
    NaiveFelt felt;
    for (int steps = between(1, 60); steps > 0 && both.is_certain(); --steps) {
        take_step(both, felt, topic);
        both.pass(*rc::gen::element<std::uint64_t>(0, 1, 3, 5, 10, 40));
        both.check();
    }
}

}  // namespace canproof::test
