// SPDX-License-Identifier: Apache-2.0
// Compares the decision tables of the AX130751 manual field by field, and the constants of its blocks.
#include "generated/ax130751/tables.hpp"

#include <map>

#include "generated/ax130751/constants.hpp"
#include "generated/ax130751/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

namespace own = generated::ax130751;
using Type = own::OutputType;
using Quantity = own::Quantity;

}  // namespace

TEST(Ax130751Tables, Table1DigitalOutputPolarityFollowsTheManual) {
    verifies<req::AOR_T01>();
    namespace t = own::digital_polarity;
    const auto drive = [](std::uint8_t value, bool before, bool state) { return t::find(value, before, state)->drive; };
    for (const bool before : {false, true}) {
        EXPECT_EQ(drive(0, before, false), t::Drive::off);
        EXPECT_EQ(drive(0, before, true), t::Drive::on);
        EXPECT_EQ(drive(1, before, false), t::Drive::on);
        EXPECT_EQ(drive(1, before, true), t::Drive::off);
        EXPECT_EQ(drive(2, before, false), t::Drive::keep);
        EXPECT_EQ(drive(3, before, false), t::Drive::off);
        EXPECT_EQ(drive(3, before, true), t::Drive::blink);
    }
    EXPECT_EQ(drive(2, false, true), t::Drive::change);
    EXPECT_EQ(drive(2, true, true), t::Drive::keep);
    EXPECT_EQ(t::find(4, false, false), nullptr);
}

TEST(Ax130751Tables, Tables2And9FaultModesFollowTheManual) {
    verifies<req::AOR_T02, req::AOR_T09, req::AOR_E_OUTPUT_DRIVE>();
    EXPECT_EQ(own::digital_error_response::find(0)->drive, own::OutputDrive::keep);
    EXPECT_EQ(own::digital_error_response::find(1)->drive, own::OutputDrive::fault_value);
    EXPECT_EQ(own::digital_error_response::rows.size(), 2U);
    EXPECT_EQ(own::analogue_error_response::find(0)->drive, own::OutputDrive::keep);
    EXPECT_EQ(own::analogue_error_response::find(1)->drive, own::OutputDrive::fault_value);
    EXPECT_EQ(own::analogue_error_response::rows.size(), 2U);
}

TEST(Ax130751Tables, Table3OutputTypesAndRangesFollowTheManual) {
    verifies<req::AOR_T03, req::AOR_E_OUTPUT_TYPE>();
    namespace t = own::output_type;
    const auto expect = [](int number, t::Kind kind, float minimum, float maximum) {
        const auto* row = t::find(static_cast<Type>(number));
        ASSERT_NE(row, nullptr) << number;
        EXPECT_EQ(row->kind, kind) << number;
        EXPECT_EQ(row->minimum, minimum) << number;
        EXPECT_EQ(row->maximum, maximum) << number;
    };
    expect(0, t::Kind::none, 0.0F, 0.0F);
    expect(10, t::Kind::voltage, -10.0F, 10.0F);
    expect(20, t::Kind::current, 0.0F, 24.0F);
    expect(40, t::Kind::pwm, 0.0F, 100.0F);
    expect(500, t::Kind::frequency, 50.0F, 30000.0F);
    expect(1000, t::Kind::digital, 0.0F, 1.0F);
    expect(1020, t::Kind::digital, 0.0F, 1.0F);
    EXPECT_EQ(t::rows.size(), 7U);
}

TEST(Ax130751Tables, ValuesOfAutomaticUpdatesFollowTheManual) {
    verifies<req::AOR_T_TYPE_DEFAULTS>();
    const auto expect = [](int number, int scaling_1, int scaling_2, int digits) {
        const auto* row = own::type_defaults::find(static_cast<Type>(number));
        ASSERT_NE(row, nullptr) << number;
        EXPECT_EQ(row->scaling_1, scaling_1) << number;
        EXPECT_EQ(row->scaling_2, scaling_2) << number;
        EXPECT_EQ(row->digits, digits) << number;
    };
    expect(0, 0, 5000, 3);
    expect(10, 0, 5000, 3);
    expect(20, 0, 20000, 3);
    expect(40, 0, 1000, 1);
    expect(500, 50, 30000, 0);
    expect(1000, 0, 1, 0);
    expect(1020, 0, 1, 0);
}

TEST(Ax130751Tables, Table4AControlSourcesFollowTheManual) {
    verifies<req::AOR_T4A>();
    using M = own::control_source::Meaning;
    const std::array<M, 10> expected{M::not_used, M::canopen_message, M::relay_command,   M::lookup_table,
                                     M::math,     M::logic,           M::commanded_value, M::feedback_value,
                                     M::supply,   M::temperature};
    for (std::uint8_t source = 0; source < 10; ++source) {
        EXPECT_EQ(own::control_source::find(source)->meaning, expected[source]) << int{source};
    }
    EXPECT_EQ(own::control_source::find(10), nullptr);
}

TEST(Ax130751Tables, Table4BControlNumbersFollowTheManual) {
    verifies<req::AOR_T4B, req::AOR_E_QUANTITY>();
    // The pairs of source and number that the manual prints, with the quantity they select. All other pairs are
    // invalid.
    std::map<std::pair<int, int>, std::pair<Quantity, int>> printed;
    printed[{1, 1}] = {Quantity::output_command, 1};
    printed[{1, 2}] = {Quantity::output_command, 2};
    printed[{1, 3}] = {Quantity::relay_command, 3};
    for (int n = 1; n <= 6; ++n) {
        printed[{1, 3 + n}] = {Quantity::extra_received, n};
    }
    printed[{2, 1}] = {Quantity::relay_command, 3};
    for (int n = 1; n <= 10; ++n) {
        printed[{3, n}] = {Quantity::lookup_table, n};
    }
    for (int n = 1; n <= 4; ++n) {
        printed[{4, n}] = {Quantity::math, n};
    }
    for (int n = 1; n <= 3; ++n) {
        printed[{5, n}] = {Quantity::logic, n};
    }
    for (int n = 1; n <= 2; ++n) {
        printed[{6, n}] = {Quantity::commanded_value, n};
        printed[{7, n}] = {Quantity::feedback_value, n};
    }
    for (int source = 0; source < 10; ++source) {
        for (int number = 0; number < 256; ++number) {
            const auto* row =
                own::control_number::find(static_cast<std::uint8_t>(source), static_cast<std::uint8_t>(number));
            ASSERT_NE(row, nullptr);
            auto expected =
                printed.count({source, number}) != 0 ? printed[{source, number}] : std::pair{Quantity::none, 0};
            if (source == 8) {
                expected = {Quantity::supply, 1};
            } else if (source == 9) {
                expected = {Quantity::temperature, 1};
            }
            EXPECT_EQ(row->quantity, expected.first) << source << ' ' << number;
            EXPECT_EQ(row->channel, expected.second) << source << ' ' << number;
        }
    }
}

TEST(Ax130751Tables, Table5LimitsAndDigitsFollowTheManual) {
    verifies<req::AOR_T05, req::AOR_E_QUANTITY>();
    namespace t = own::value_limits;
    const auto expect = [](Quantity quantity, t::Lower lower, t::Upper upper, t::Digits digits) {
        const auto* row = t::find(quantity);
        ASSERT_NE(row, nullptr);
        EXPECT_EQ(row->lower, lower) << static_cast<int>(quantity);
        EXPECT_EQ(row->upper, upper) << static_cast<int>(quantity);
        EXPECT_EQ(row->digits, digits) << static_cast<int>(quantity);
    };
    expect(Quantity::none, t::Lower::nothing, t::Upper::nothing, t::Digits::whole);
    expect(Quantity::output_command, t::Lower::o7320, t::Upper::o7322, t::Digits::o6302);
    expect(Quantity::digital_command, t::Lower::low, t::Upper::high, t::Digits::whole);
    expect(Quantity::relay_command, t::Lower::low, t::Upper::high, t::Digits::whole);
    expect(Quantity::extra_received, t::Lower::o2520, t::Upper::o2522, t::Digits::o2502);
    expect(Quantity::lookup_table, t::Lower::least_y, t::Upper::greatest_y, t::Digits::o3yz4);
    expect(Quantity::math, t::Lower::o4021, t::Upper::o4023, t::Digits::o4032);
    expect(Quantity::logic, t::Lower::percent_low, t::Upper::percent_high, t::Digits::tenths);
    expect(Quantity::commanded_value, t::Lower::o7321, t::Upper::o7323, t::Digits::o6332);
    expect(Quantity::feedback_value, t::Lower::o7321, t::Upper::o7323, t::Digits::o6332);
    expect(Quantity::supply, t::Lower::o5022, t::Upper::o5023, t::Digits::tenths);
    expect(Quantity::temperature, t::Lower::o5032_less_o5033, t::Upper::o5032, t::Digits::tenths);
}

TEST(Ax130751Tables, Table6ControlResponseFollowsTheManual) {
    verifies<req::AOR_T06>();
    namespace t = own::control_response;
    const auto drive = [](std::uint8_t response, t::Position position) { return t::find(response, position)->drive; };
    EXPECT_EQ(drive(0, t::Position::below), t::Drive::profile);
    EXPECT_EQ(drive(0, t::Position::within), t::Drive::profile);
    EXPECT_EQ(drive(0, t::Position::above), t::Drive::profile);
    EXPECT_EQ(drive(1, t::Position::below), t::Drive::off);
    EXPECT_EQ(drive(1, t::Position::within), t::Drive::profile);
    EXPECT_EQ(drive(1, t::Position::above), t::Drive::profile);
    EXPECT_EQ(drive(2, t::Position::below), t::Drive::profile);
    EXPECT_EQ(drive(2, t::Position::within), t::Drive::profile);
    EXPECT_EQ(drive(2, t::Position::above), t::Drive::off);
}

TEST(Ax130751Tables, Table7EnableResponseFollowsTheManual) {
    verifies<req::AOR_T07, req::AOR_E_OUTPUT_DRIVE>();
    using A = own::OutputDrive;
    struct Row {
        A on;
        A off;
    };
    const std::array<Row, 6> expected{{{A::control, A::shut_off},
                                       {A::control, A::ramp_off},
                                       {A::control, A::keep},
                                       {A::shut_off, A::control},
                                       {A::ramp_off, A::control},
                                       {A::keep, A::control}}};
    for (std::uint8_t response = 0; response < 6; ++response) {
        EXPECT_EQ(own::enable_response::find(response, true)->drive, expected[response].on) << int{response};
        EXPECT_EQ(own::enable_response::find(response, false)->drive, expected[response].off) << int{response};
    }
    EXPECT_EQ(own::enable_response::find(6, true), nullptr);
}

TEST(Ax130751Tables, Tables8And12OverrideResponsesFollowTheManual) {
    verifies<req::AOR_T08, req::AOR_T12>();
    EXPECT_TRUE(own::override_response::find(0, true)->overridden);
    EXPECT_FALSE(own::override_response::find(0, false)->overridden);
    EXPECT_FALSE(own::override_response::find(1, true)->overridden);
    EXPECT_TRUE(own::override_response::find(1, false)->overridden);
    EXPECT_TRUE(own::relay_override_response::find(0, true)->overridden);
    EXPECT_FALSE(own::relay_override_response::find(0, false)->overridden);
    EXPECT_FALSE(own::relay_override_response::find(1, true)->overridden);
    EXPECT_TRUE(own::relay_override_response::find(1, false)->overridden);
}

TEST(Ax130751Tables, Table10RelayPolarityFollowsTheManual) {
    verifies<req::AOR_T10>();
    namespace t = own::relay_polarity;
    using D = t::Drive;
    // The columns are the control input before and now: OFF and OFF, OFF and ON, ON and OFF, ON and ON.
    const std::array<std::array<D, 4>, 6> drives{{{D::none, D::none, D::none, D::none},
                                                  {D::off, D::on, D::off, D::on},
                                                  {D::on, D::off, D::on, D::off},
                                                  {D::keep, D::change, D::keep, D::keep},
                                                  {D::keep, D::keep, D::change, D::keep},
                                                  {D::off, D::blink, D::off, D::blink}}};
    const std::array<t::Unlatch, 6> unlatch{t::Unlatch::ignored, t::Unlatch::ignored, t::Unlatch::ignored,
                                            t::Unlatch::to_off,  t::Unlatch::to_on,   t::Unlatch::ignored};
    for (std::uint8_t value = 0; value < 6; ++value) {
        for (std::size_t edge = 0; edge < 4; ++edge) {
            const auto* row = t::find(value, edge >= 2, (edge % 2) == 1);
            EXPECT_EQ(row->drive, drives[value][edge]) << int{value} << ' ' << edge;
            EXPECT_EQ(row->unlatch, unlatch[value]) << int{value};
        }
    }
}

TEST(Ax130751Tables, PolaritiesOfTables1And10SwitchOutputAndRelayAlike) {
    verifies<req::AOR_E_SWITCH_DRIVE>();
    using D = own::SwitchDrive;
    // value in Table 1, value in Table 10, and the drive when the control goes from OFF to ON: normal, inverse,
    // latched, blinking
    const std::array<std::tuple<std::uint8_t, std::uint8_t, D>, 4> shared{
        {{0, 1, D::on}, {1, 2, D::off}, {2, 3, D::change}, {3, 5, D::blink}}};
    for (const auto& [digital, relay, drive] : shared) {
        EXPECT_EQ(own::digital_polarity::find(digital, false, true)->drive, drive) << int{digital};
        EXPECT_EQ(own::relay_polarity::find(relay, false, true)->drive, drive) << int{relay};
    }
    EXPECT_EQ(own::relay_polarity::find(0, false, true)->drive, D::none);
}

TEST(Ax130751Tables, Table11RelayEnableResponseFollowsTheManual) {
    verifies<req::AOR_T11, req::AOR_E_OUTPUT_DRIVE>();
    using A = own::OutputDrive;
    const std::array<std::pair<A, A>, 6> on_and_off{{{A::control, A::shut_off},
                                                     {A::shut_off, A::control},
                                                     {A::shut_off, A::control},
                                                     {A::control, A::shut_off},
                                                     {A::control, A::keep},
                                                     {A::keep, A::control}}};
    for (std::uint8_t response = 0; response < 6; ++response) {
        EXPECT_EQ(own::relay_enable_response::find(response, true)->drive, on_and_off[response].first) << int{response};
        EXPECT_EQ(own::relay_enable_response::find(response, false)->drive, on_and_off[response].second)
            << int{response};
    }
}

TEST(Ax130751Tables, RelayOverrideStateAndContactsFollowTheManual) {
    verifies<req::AOR_T11B, req::AOR_T_CONTACT>();
    EXPECT_FALSE(own::relay_override_state::find(0)->on);
    EXPECT_TRUE(own::relay_override_state::find(1)->on);
    EXPECT_TRUE(own::relay_contact::find(true)->normally_closed);
    EXPECT_FALSE(own::relay_contact::find(true)->normally_open);
    EXPECT_FALSE(own::relay_contact::find(false)->normally_closed);
    EXPECT_TRUE(own::relay_contact::find(false)->normally_open);
}

TEST(Ax130751Tables, Table14PointResponsesFollowTheManual) {
    verifies<req::AOR_T14>();
    namespace t = own::point_response;
    EXPECT_EQ(t::find(0, t::Point::first)->meaning, t::Meaning::data);
    EXPECT_EQ(t::find(1, t::Point::first)->meaning, t::Meaning::time);
    EXPECT_EQ(t::find(2, t::Point::first)->meaning, t::Meaning::not_allowed);
    EXPECT_EQ(t::find(0, t::Point::other)->meaning, t::Meaning::ignore);
    EXPECT_EQ(t::find(1, t::Point::other)->meaning, t::Meaning::ramp);
    EXPECT_EQ(t::find(2, t::Point::other)->meaning, t::Meaning::jump);
}

TEST(Ax130751Tables, Table20LookupTablesOfLogicBlocksFollowTheManual) {
    verifies<req::AOR_T20>();
    for (std::uint8_t block = 1; block <= 3; ++block) {
        const auto* row = own::shipped_tables::find(block);
        EXPECT_EQ(row->table_a, (3 * block) - 2);
        EXPECT_EQ(row->table_b, (3 * block) - 1);
        EXPECT_EQ(row->table_c, 3 * block);
    }
}

TEST(Ax130751Tables, Table21OperatorsFollowTheManual) {
    verifies<req::AOR_T21>();
    using O = own::math_operator::Operation;
    const std::array<O, 18> expected{
        O::equal,    O::not_equal, O::greater,   O::greater_or_equal, O::less,      O::less_or_equal,
        O::logic_or, O::logic_nor, O::logic_and, O::logic_nand,       O::logic_xor, O::logic_xnor,
        O::plus,     O::minus,     O::times,     O::divided_by,       O::minimum,   O::maximum};
    for (std::uint8_t number = 0; number < 18; ++number) {
        EXPECT_EQ(own::math_operator::find(number)->operation, expected[number]) << int{number};
    }
    EXPECT_EQ(own::math_operator::find(18), nullptr);
}

TEST(Ax130751Tables, Table23AndDiagnosticFaultCodesFollowTheManual) {
    verifies<req::AOR_T23, req::AOR_T_FAULT_CODES>();
    namespace t = own::error_field_codes;
    const auto expect = [](ErrorId error, int description, int channel, int code, int bits) {
        const auto* row = t::find(error);
        EXPECT_EQ(row->description, description);
        EXPECT_EQ(row->channel, channel);
        EXPECT_EQ(row->code, code);
        EXPECT_EQ(row->register_bits, bits);
    };
    expect(own::error::error_reset, 0x00, 0x00, 0x0000, 0);
    expect(ErrorId::rpdo_timeout, 0x00, 0x00, 0x8100, 1);
    expect(ErrorId::life_guarding, 0x10, 0x00, 0x8130, 1);
    expect(ErrorId::heartbeat, 0x80, 0x00, 0x8130, 1);
    EXPECT_EQ(own::fault_codes::find(own::error::supply)->code, 0x3100);
    EXPECT_EQ(own::fault_codes::find(own::error::supply)->register_bits, 1);
    EXPECT_EQ(own::fault_codes::find(own::error::temperature)->code, 0x4200);
    EXPECT_EQ(own::fault_codes::find(own::error::temperature)->register_bits, 1);
}

TEST(Ax130751Tables, OutputLevelsOfDigitalRange2240hFollowTheManual) {
    verifies<req::AOR_T_DIGITAL_RANGE>();
    EXPECT_EQ(own::digital_range::find(0)->level_v, 5.0F);
    EXPECT_EQ(own::digital_range::find(1)->level_v, 12.0F);
    EXPECT_EQ(own::digital_range::rows.size(), 2U);
}

TEST(Ax130751Constants, BlockConstantsFollowTheManual) {
    verifies<req::AOR_K_CYCLE, req::AOR_K_FREQUENCY_DUTY, req::AOR_K_COMPLIANCE, req::AOR_K_RESISTOR_SCALE,
             req::AOR_K_SHORTEST_INTERVAL, req::AOR_K_LONGEST_INTERVAL, req::AOR_K_PERCENT_LOW, req::AOR_K_PERCENT_HIGH,
             req::AOR_K_TRUE_FROM, req::AOR_K_GAIN_ONE, req::AOR_K_SUPPLY_SHUTDOWN_LOW,
             req::AOR_K_SUPPLY_SHUTDOWN_HIGH>();
    EXPECT_EQ(own::cycle_ms, 1U);
    EXPECT_EQ(own::frequency_duty, 50.0F);
    EXPECT_EQ(own::compliance_voltage, 14.0F);
    EXPECT_EQ(own::milliamperes_per_ampere, 1000.0F);
    EXPECT_EQ(own::shortest_interval_ms, 1);
    EXPECT_EQ(own::longest_interval_ms, 86'400'000);
    EXPECT_EQ(own::percent_low, 0);
    EXPECT_EQ(own::percent_high, 100);
    EXPECT_EQ(own::true_from, 0.5);
    EXPECT_EQ(own::gain_of_one, 100);
    EXPECT_EQ(own::supply_shutdown_low, 7.0F);
    EXPECT_EQ(own::supply_shutdown_high, 39.0F);
}

}  // namespace canproof::test
