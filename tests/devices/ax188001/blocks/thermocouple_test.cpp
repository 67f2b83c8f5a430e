// SPDX-License-Identifier: Apache-2.0
// Compares the thermocouple functions of the AX188001 (manual, 1.1, Table 1, appendix A) with the ITS-90 functions in
// its90.hpp.
#include "devices/ax188001/firmware/thermocouple.hpp"

#include <gtest/gtest.h>

#include "devices/ax188001/firmware/thermocouple_curves.hpp"
#include "generated/ax188001/requirements.hpp"
#include "generated/ax188001/tables.hpp"
#include "tests/devices/ax188001/its90.hpp"
#include "tests/support/shows_rule.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace ax188001;

const ThermocoupleCurve& curve_of(const Its90Type& type) {
    return thermocouple_curve(static_cast<generated::ax188001::SensorType>(type.number));
}

/// Returns the lowest temperature from which on each voltage belongs to only one temperature. It is 42 degC for type B,
/// whose voltage falls until 21.02 degC and is 0 mV again at about 42 degC.
long double lowest_convertible(const Its90Type& type) {
    return type.letter == 'B' ? 42.0L : type.lowest();
}

/// A fixture with a thermocouple of one of the eight types.
class ThermocoupleType : public testing::TestWithParam<std::size_t> {
  protected:
    const Its90Type type{its90_types().at(GetParam())};
};

std::string letter_of(const testing::TestParamInfo<std::size_t>& info) {
    return std::string{its90_types().at(info.param).letter};
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Each, ThermocoupleType, testing::Range(std::size_t{0}, its90_types().size()), letter_of);

TEST(Thermocouple, ReferenceFunctionsMatchTheTemperatureScaleITS90) {
    verifies<req::TCS_T_REFERENCE, req::TCS_E_SENSOR_TYPE, req::TCS_CONV_001, req::TCS_K_EXPONENTIAL_A0,
             req::TCS_K_EXPONENTIAL_A1, req::TCS_K_EXPONENTIAL_A2>();
    for (const auto& type : its90_types()) {
        // Steps of 0.25 degC include both sides of every border between two polynomials.
        for (long double celsius = type.lowest(); celsius <= type.highest(); celsius += 0.25L) {
            ASSERT_NEAR(reference_mv(curve_of(type), static_cast<double>(celsius)),
                        static_cast<double>(type.mv(celsius)), 1e-9)
                << type.letter << " at " << static_cast<double>(celsius);
        }
    }
}

TEST(Thermocouple, PolynomialPiecesHaveThePublishedRanges) {
    verifies<req::TCS_T_REFERENCE, req::TCS_T_INVERSE>();
    for (const auto& type : its90_types()) {
        const ThermocoupleCurve& curve = curve_of(type);
        ASSERT_EQ(curve.reference_count, type.reference.size()) << type.letter;
        for (std::size_t i = 0; i < curve.reference_count; ++i) {
            EXPECT_NEAR(from_fixed(curve.reference[i].begin), static_cast<double>(type.reference[i].from), 1e-12)
                << type.letter;
            EXPECT_NEAR(from_fixed(curve.reference[i].end), static_cast<double>(type.reference[i].to), 1e-12)
                << type.letter;
        }
        ASSERT_EQ(curve.inverse_count, type.inverse.size()) << type.letter;
        for (std::size_t i = 0; i < curve.inverse_count; ++i) {
            EXPECT_NEAR(from_fixed(curve.inverse[i].begin), static_cast<double>(type.inverse[i].from), 1e-12)
                << type.letter;
            EXPECT_NEAR(from_fixed(curve.inverse[i].end), static_cast<double>(type.inverse[i].to), 1e-12)
                << type.letter;
        }
    }
}

TEST(Thermocouple, EachPolynomialPieceIsOnceInItsTable) {
    verifies<req::TCS_T_REFERENCE, req::TCS_T_INVERSE>();
    namespace reference = generated::ax188001::reference_function;
    namespace inverse = generated::ax188001::inverse_function;
    using R = reference::Piece;
    using I = inverse::Piece;
    const std::vector<R> of_temperature{R::j1, R::j2, R::k1, R::k2, R::n1, R::n2, R::r1, R::r2, R::r3,
                                        R::s1, R::s2, R::s3, R::t1, R::t2, R::e1, R::e2, R::b1, R::b2};
    const std::vector<I> of_voltage{I::j1, I::j2, I::j3, I::k1, I::k2, I::k3, I::n1, I::n2, I::n3, I::r1, I::r2, I::r3,
                                    I::r4, I::s1, I::s2, I::s3, I::s4, I::t1, I::t2, I::e1, I::e2, I::b1, I::b2};
    ASSERT_EQ(reference::rows.size(), of_temperature.size());
    for (std::size_t i = 0; i < of_temperature.size(); ++i) {
        EXPECT_EQ(reference::rows[i].piece, of_temperature[i]) << i;
    }
    ASSERT_EQ(inverse::rows.size(), of_voltage.size());
    for (std::size_t i = 0; i < of_voltage.size(); ++i) {
        EXPECT_EQ(inverse::rows[i].piece, of_voltage[i]) << i;
    }
}

TEST(Thermocouple, SlopeOfTheReferenceFunctionMatchesTheDifferenceQuotient) {
    verifies<req::TCS_CONV_001>();
    for (const auto& type : its90_types()) {
        for (long double celsius = type.lowest() + 1.0L; celsius < type.highest() - 1.0L; celsius += 7.3L) {
            const long double difference = (type.mv(celsius + 0.001L) - type.mv(celsius - 0.001L)) / 0.002L;
            ASSERT_NEAR(reference_slope(curve_of(type), static_cast<double>(celsius)), static_cast<double>(difference),
                        1e-7)
                << type.letter << " at " << static_cast<double>(celsius);
        }
    }
}

TEST(Thermocouple, ReferenceFunctionsMatchPublishedVoltagesToHalfTheirLastDigit) {
    verifies<req::TCS_CONV_005>();
    std::size_t points = 0;
    for (const auto& type : its90_types()) {
        for (const auto& [celsius, mv] : type.points) {
            EXPECT_NEAR(reference_mv(curve_of(type), celsius), mv, 0.0005000001) << type.letter << " at " << celsius;
            ++points;
        }
    }
    EXPECT_EQ(points, 363U);
}

TEST(Thermocouple, PublishedVoltagesGiveTheirTemperatures) {
    verifies<req::TCS_CONV_001>();
    for (const auto& type : its90_types()) {
        for (const auto& [celsius, mv] : type.points) {
            if (celsius < lowest_convertible(type)) {
                continue;
            }
            // Allow half a digit of the table, 0.0005 mV, converted to degrees at this point.
            const long double slope = (type.mv(celsius + 0.5L) - type.mv(celsius - 0.5L));
            EXPECT_NEAR(exact_celsius(curve_of(type), mv), celsius, static_cast<double>(0.0005L / slope) * 1.05 + 1e-6)
                << type.letter << " at " << celsius;
        }
    }
}

TEST(Thermocouple, ConversionErrsByAtMost1_18MillionthsOfADegree) {
    verifies<req::TCS_CONV_002>();
    // The requirement allows 0.02 degC. At 760 degC, where the two published functions of type J meet, they differ by
    // 7.5e-8 mV. Rounding decides which function is used. With a slope of 0.0639 mV/degC, the error is then up to
    // 1.17e-6 degC.
    constexpr double most = 1.18e-6;
    for (const auto& type : its90_types()) {
        double worst = 0.0;
        for (long double celsius = lowest_convertible(type); celsius <= type.highest(); celsius += 0.1L) {
            const double back = exact_celsius(curve_of(type), static_cast<double>(type.mv(celsius)));
            worst = std::max(worst, std::fabs(back - static_cast<double>(celsius)));
        }
        EXPECT_LT(worst, most) << type.letter;
    }
}

TEST_P(ThermocoupleType, LowestTemperaturesAreFoundFromTheirVoltages) {
    verifies<req::TCS_CONV_002>();
    // At the lowest temperatures the curves are flat and no inverse polynomial is defined, so the search for the
    // temperature starts elsewhere.
    for (int step = 0; step <= 2000; ++step) {
        const long double celsius = lowest_convertible(type) + step * 0.001L;
        ASSERT_NEAR(exact_celsius(curve_of(type), static_cast<double>(type.mv(celsius))), static_cast<double>(celsius),
                    1e-6);
    }
}

TEST_P(ThermocoupleType, InverseFunctionsMatchTheTemperatureScaleITS90) {
    verifies<req::TCS_T_INVERSE, req::TCS_CONV_009>();
    for (std::size_t i = 0; i < type.inverse.size(); ++i) {
        const auto& piece = type.inverse[i];
        // The inverse polynomials of types R and S overlap; the lower polynomial applies up to its own end.
        const long double from = i == 0 ? piece.from : std::max(piece.from, type.inverse[i - 1].to);
        for (int step = 1; step <= 2000; ++step) {
            const long double mv = from + (piece.to - from) * step / 2000.0L;
            const double celsius = approximate_celsius(curve_of(type), static_cast<double>(mv));
            ASSERT_NEAR(celsius, static_cast<double>(piece.at(mv)), 1e-7) << step;
            // NIST states errors of the inverse polynomials of up to 0.06 degC. The ends of their ranges are rounded to
            // 0.001 mV, which adds to the error.
            ASSERT_NEAR(celsius, exact_celsius(curve_of(type), static_cast<double>(mv)), 0.0605)
                << static_cast<double>(mv);
        }
    }
}

TEST_P(ThermocoupleType, InverseFunctionBeyondItsRangeGivesTheTemperatureAtTheEndOfTheRange) {
    verifies<req::TCS_CONV_009>();
    const auto& first = type.inverse.front();
    const auto& last = type.inverse.back();
    EXPECT_NEAR(approximate_celsius(curve_of(type), static_cast<double>(first.from) - 1.0),
                static_cast<double>(first.at(first.from)), 1e-7);
    EXPECT_NEAR(approximate_celsius(curve_of(type), static_cast<double>(last.to) + 1.0),
                static_cast<double>(last.at(last.to)), 1e-7);
}

TEST(Thermocouple, VoltagesBeyondTheRangeGiveTheTemperatureAtTheEndOfTheRange) {
    verifies<req::TCS_CONV_006>();
    for (const auto& type : its90_types()) {
        if (type.letter != 'B') {
            EXPECT_NEAR(exact_celsius(curve_of(type), -100.0), static_cast<double>(type.lowest()), 1e-12)
                << type.letter;
        }
        EXPECT_NEAR(exact_celsius(curve_of(type), 100.0), static_cast<double>(type.highest()), 1e-12) << type.letter;
    }
}

TEST(Thermocouple, ConvertedTemperatureStaysWithinTheRangeNearItsEnds) {
    verifies<req::TCS_CONV_006, req::TCS_CONV_002>();
    constexpr double step_mv = 1.0 / 1099511627776.0;  // one step of the fixed-point voltage, 2^-40 mV; 300 steps are
                                                       // at most 1e-6 degC
    for (const auto& type : its90_types()) {
        const ThermocoupleCurve& curve = curve_of(type);
        const double low_mv = reference_mv(curve, curve.lowest_c());
        const double high_mv = reference_mv(curve, curve.highest_c());
        for (int steps = 0; steps <= 300; ++steps) {
            if (steps > 0) {
                EXPECT_EQ(exact_celsius(curve, low_mv - steps * step_mv), curve.lowest_c()) << type.letter;
                EXPECT_EQ(exact_celsius(curve, high_mv + steps * step_mv), curve.highest_c()) << type.letter;
            }
            const double high = exact_celsius(curve, high_mv - steps * step_mv);
            EXPECT_LE(high, curve.highest_c()) << type.letter;
            EXPECT_NEAR(high, curve.highest_c(), 1e-6) << type.letter;
            const double low = exact_celsius(curve, low_mv + steps * step_mv);
            EXPECT_GE(low, curve.lowest_c()) << type.letter;
            if (type.letter != 'B') {  // at its lowest temperature the curve of type B is flat
                EXPECT_NEAR(low, curve.lowest_c(), 1e-6) << type.letter;
            }
        }
    }
}

TEST(Thermocouple, TypeBIsConvertedOnItsRisingBranch) {
    verifies<req::TCS_CONV_007, req::TCS_CONV_012, req::TCS_K_B_MINIMUM>();
    const Its90Type b = its90_b();
    // The slope changes its sign at 21.02 degC, where the voltage is -2.585 uV.
    EXPECT_LT(b.mv(21.020L), b.mv(21.010L));
    EXPECT_LT(b.mv(21.021L), b.mv(21.031L));
    EXPECT_NEAR(static_cast<double>(b.mv(21.0203L)) * 1000.0, -2.585, 0.0005);
    EXPECT_NEAR(exact_celsius(curve_of(b), -1.0), 21.0203, 1e-6);
    for (long double celsius = 21.1L; celsius < 60.0L; celsius += 0.37L) {
        EXPECT_NEAR(exact_celsius(curve_of(b), static_cast<double>(b.mv(celsius))), static_cast<double>(celsius), 1e-4);
    }
    EXPECT_NEAR(exact_celsius(curve_of(b), 0.0), 42.13, 0.01);  // 42 + 0.0322 / 0.249: type B has -0.0322 uV at 42 degC
                                                                // and a slope of 0.249 uV/K
}

TEST(Thermocouple, InputRangesOfTheAppendixEndWhereTheConversionFunctionsEnd) {
    verifies<req::TCS_CONV_010, req::TCS_T1>();
    namespace ranges = generated::ax188001::thermocouple_type;
    struct Range {
        char letter;
        std::int32_t lowest_uv;
        std::int32_t highest_uv;
        long double highest_c;
    };
    const std::vector<Range> appendix{{'J', -8095, 69553, 1200.0L}, {'K', -6458, 54886, 1372.0L},
                                      {'N', -4345, 47513, 1300.0L}, {'R', -226, 21101, 1768.0L},
                                      {'S', -236, 18693, 1768.0L},  {'T', -6258, 20872, 400.0L},
                                      {'E', -9835, 76373, 1000.0L}, {'B', 0, 13820, 1820.0L}};
    for (std::size_t i = 0; i < appendix.size(); ++i) {
        const Its90Type& type = its90_types()[i];
        ASSERT_EQ(type.letter, appendix[i].letter);
        EXPECT_NEAR(static_cast<double>(type.mv(type.lowest())) * 1000.0, appendix[i].lowest_uv, 0.5) << type.letter;
        EXPECT_NEAR(static_cast<double>(type.mv(appendix[i].highest_c)) * 1000.0, appendix[i].highest_uv, 0.5)
            << type.letter;
        EXPECT_NEAR(reference_mv(curve_of(type), static_cast<double>(type.lowest())) * 1000.0, appendix[i].lowest_uv,
                    0.5)
            << type.letter;
        EXPECT_NEAR(reference_mv(curve_of(type), static_cast<double>(appendix[i].highest_c)) * 1000.0,
                    appendix[i].highest_uv, 0.5)
            << type.letter;
        const auto* const row = ranges::find(static_cast<generated::ax188001::SensorType>(type.number));
        ASSERT_NE(row, nullptr);
        EXPECT_EQ(row->lowest_uv, appendix[i].lowest_uv);
        EXPECT_EQ(row->highest_uv, appendix[i].highest_uv);
    }
}

TEST(Thermocouple, ReferenceFunctionOfTypeBContinuesBelowItsRange) {
    verifies<req::TCS_CJ_005>();
    // Type B at -40 degC: c1 t + c2 t^2 + c3 t^3 = 9.860 + 9.446 + 0.085 uV
    EXPECT_NEAR(reference_mv(curve_of(its90_b()), -40.0) * 1000.0, 9.860 + 9.446 + 0.085, 0.006);
}

TEST(ThermocoupleArithmetic, PolynomialEndsWithItsLastNonZeroCoefficient) {
    shows_rule("thermocouples in fixed point");
    // The array is not constant, and is as long as in the firmware. Otherwise the compiler would evaluate terms_of(),
    // or only the test would instantiate it, and mutation testing could not alter it.
    std::array<double, ReferencePiece::size> coefficients{1.0, -2.0};
    EXPECT_EQ(terms_of(coefficients), 2U);
    coefficients = {0.0, 0.0, 1e-30};
    EXPECT_EQ(terms_of(coefficients), 3U);
    coefficients = {};
    EXPECT_EQ(terms_of(coefficients), 0U);
}

TEST(ThermocoupleArithmetic, ExponentialTermThatHalvesMoreThan256TimesIsClamped) {
    shows_rule("thermocouples in fixed point");
    // 1024 °C away from the centre, the exponent 2e-4 × 1024² = 209.7 gives e^-209.7 = 2^-302.6: more than the 256
    // halvings of a fraction.
    EXPECT_EQ(exponential_term(1.0, -2e-4, 0.0).halvings, UINT64_MAX);
    // The exponent gives 1e-4 × 1024² / ln 2 = 151.3 halvings. `halvings` stores them as a fraction of 256, in steps of
    // 2^-64.
    const double halvings = 1e-4 * 1048576.0 / 0.6931471805599453 / 256.0;
    EXPECT_NEAR(static_cast<double>(exponential_term(1.0, -1e-4, 0.0).halvings) / 18446744073709551616.0, halvings,
                1e-15);
}

TEST(Thermocouple, ExponentialTermMatchesTheLibraryFunction) {
    verifies<req::TCS_CONV_008>();
    // The exponential term of type K is 0.1185976 exp(-1.183432e-4 (t - 126.9686)^2) mV. At 710 degC it is 4e-19 mV.
    const ExponentialTerm term = exponential_term(0.1185976, -1.183432e-4, 126.9686);
    for (double celsius = -40.0; celsius <= 1372.0; celsius += 0.13) {
        const long double distance = static_cast<long double>(celsius) - 126.9686L;
        const long double right = 0.1185976L * std::exp(-1.183432e-4L * distance * distance);
        ASSERT_NEAR(exponential_mv(term, celsius), static_cast<double>(right), 1e-11)
            << celsius;  // the requirement allows 1e-9 mV
    }
    EXPECT_NEAR(exponential_mv(term, 126.9686), 0.1185976, 1e-11);
    EXPECT_EQ(exponential_mv(term, 126.9686 + 1024.0), 0.0);
    EXPECT_EQ(exponential_mv(term, -1e300), 0.0);
}

TEST_P(ThermocoupleType, TemperaturesBelowTheInverseFunctionAreFoundInFourSteps) {
    verifies<req::TCS_CONV_002>();
    // Between the end of the range and the lowest temperature of the inverse function, the search takes most steps.
    const long double from = lowest_convertible(type);
    const long double to = std::fmax(from, type.inverse.front().at(type.inverse.front().from));
    for (int step = 0; step <= 2000; ++step) {
        const long double celsius = from + (to - from) * step / 2000.0L;
        ASSERT_NEAR(exact_celsius(curve_of(type), static_cast<double>(type.mv(celsius))), static_cast<double>(celsius),
                    1e-6);
    }
}

}  // namespace canproof::test
