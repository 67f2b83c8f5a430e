// SPDX-License-Identifier: Apache-2.0
// Compares the decision tables of the AX060805 manual field by field, and the constants of its angles and of its
// simulated sensor.
#include "generated/ax060805/tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "generated/ax060805/constants.hpp"
#include "generated/ax060805/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

namespace own = generated::ax060805;

}  // namespace

// Section 3.3, Table 5: an error of the sensor has priority over conditions that make its data doubtful (temperature
// out of range, free fall, undefined roll).
TEST(InclinometerTables, FigureOfMeritTableFollowsTheManual) {
    verifies<req::INC_T5>();
    for (const bool error : {false, true}) {
        for (const bool outside : {false, true}) {
            for (const bool weightless : {false, true}) {
                for (const bool unsure : {false, true}) {
                    const auto* row = own::figure_of_merit::find(error, outside, weightless, unsure);
                    ASSERT_NE(row, nullptr);
                    EXPECT_EQ(row->state, error ? 2 : outside || weightless || unsure ? 1 : 0);
                }
            }
        }
    }
}

// AX060805, 3.3 Table 4
TEST(InclinometerTables, AngleFilterTableFollowsTheManual) {
    verifies<req::INC_T4>();
    namespace t = own::angle_filter;
    const std::array<t::Filter, 3> filters{t::Filter::none, t::Filter::moving_average, t::Filter::repeating};
    for (std::uint32_t type = 0; type < 3; ++type) {
        ASSERT_NE(t::find(type), nullptr);
        EXPECT_EQ(t::find(type)->filter, filters[type]);
    }
    EXPECT_EQ(t::find(3), nullptr);
}

// Section 3.8, Table 10: rows are in the order of the operation number
TEST(InclinometerTables, BinaryFunctionTableFollowsTheManual) {
    verifies<req::INC_T10>();
    namespace t = own::binary_function;
    using F = t::Function;
    const std::array<F, 21> functions{
        F::undefined,  F::add,         F::subtract,   F::multiply,    F::divide,        F::modulus,    F::maximum,
        F::minimum,    F::equal,       F::not_equal,  F::greater,     F::greater_equal, F::less,       F::less_equal,
        F::logical_or, F::logical_and, F::bitwise_or, F::bitwise_and, F::bitwise_xor,   F::shift_left, F::shift_right};
    for (std::uint32_t number = 0; number < functions.size(); ++number) {
        const auto* row = t::find(number);
        ASSERT_NE(row, nullptr) << number;
        EXPECT_EQ(row->function, functions[number]) << number;
        const bool integers = number == 5 || number >= 14;
        EXPECT_EQ(row->operands, integers ? t::Operands::integer : t::Operands::real) << number;
    }
    EXPECT_EQ(t::find(21), nullptr);
}

// Section 5.1.1, Table 62: resolution, drift, non-linearity and cross-axis error. AX060805 has 0.35 degrees, 3.5
// degrees, 0.7 % and 3.5 %; AX060835, AX060840 and AX060841 have 0.06 degrees, 3.0 degrees, 0.1 % and 1 %. Other parts
// do not exist.
TEST(InclinometerTables, SensorTableFollowsTheManualByPartNumber) {
    verifies<req::INC_T62>();
    namespace t = own::sensor_accuracy;
    for (std::uint32_t part = 0; part <= 60841; ++part) {
        const bool first = part == 60805;
        const bool second = part == 60835 || part == 60840 || part == 60841;
        const auto either = [&](float one, float two) { return first ? one : second ? two : 0.0F; };
        const auto* row = t::find(part);
        ASSERT_NE(row, nullptr) << part;
        EXPECT_EQ(row->resolution, either(0.35F, 0.06F)) << part;
        EXPECT_EQ(row->drift, either(3.5F, 3.0F)) << part;
        EXPECT_EQ(row->nonlinearity, either(0.7F, 0.1F)) << part;
        EXPECT_EQ(row->cross_axis, either(3.5F, 1.0F)) << part;
        EXPECT_EQ(std::count_if(t::rows.begin(), t::rows.end(),
                                [&](const t::Row& one) { return one.part_first <= part && part <= one.part_last; }),
                  1)
            << part;
    }
    EXPECT_EQ(t::find(60842), nullptr);
}

// The first three constants come from decisions of the requirements register; they are in degrees and g. The others
// come from section 5.1.1, Table 62. There the resolution is 3.46 sigma at 5 Hz, and the accuracy is 2 degrees at 25
// degrees Celsius. The drift is given from -40 degrees Celsius on.
TEST(InclinometerTables, ConstantsFollowTheManualAndTheDecisions) {
    verifies<req::INC_K_GIMBAL_LOCK, req::INC_K_EXACT_ANGLE, req::INC_K_LEAST_GRAVITY, req::INC_K_RESOLUTION_FACTOR,
             req::INC_K_RATED_CUT_OFF, req::INC_K_INITIAL_ACCURACY, req::INC_K_DRIFT_REFERENCE,
             req::INC_K_LOWEST_AMBIENT>();
    EXPECT_EQ(own::gimbal_lock_cone, 1.0F);
    EXPECT_EQ(own::exact_angle, 0.00005F);
    EXPECT_EQ(own::least_gravity, 0.1F);
    EXPECT_EQ(own::resolution_factor, 3.46F);
    EXPECT_EQ(own::rated_cut_off, 5.0F);
    EXPECT_EQ(own::initial_accuracy, 2.0F);
    EXPECT_EQ(own::drift_reference, 25.0F);
    EXPECT_EQ(own::lowest_ambient, -40.0F);
}

}  // namespace canproof::test
