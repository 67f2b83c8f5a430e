// SPDX-License-Identifier: Apache-2.0
// Tests the sources and the ten binary functions of the AX060805 (manual, 3.1, 3.8, 3.9, 4.3.22 to 4.3.32), node 127.
// The arithmetic of the functions has its own test, tests/devices/ax060805/blocks/binary_function_test.cpp.
#include <cmath>

#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_functions.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805Functions : public InclinometerFunctions {};

}  // namespace

TEST_F(Ax060805Functions, EverySourceOfTable1ExceptTheFunctionsCanBeConnected) {
    verifies<req::INC_T1, req::INC_SIG_001, req::INC_SIG_006, req::INC_SIG_005, req::INC_OD_3010,
             req::INC_GLOBAL_003>();
    inputs.sensor_temperature = -12.75F;
    inputs.processor_temperature = 41.5F;
    inputs.supply_voltage = 11.25F;
    set_inputs();
    write_real(0x4070, 0, -2.5F);
    write(0x4080, 0, 77, 4);
    write(0x2500, 1, 15, 2);
    write(0x2500, 2, 25, 2);
    write(0x2500, 3, 35, 2);
    turn(20.25, 0.0);
    pass(5);
    struct Row {
        std::uint32_t source;
        float scale;
        int expected;
    };
    const std::vector<Row> rows{
        {0, 1.0F, undefined}, {1, 1000.0F, 346},  // sin 20.25 = 0.34612
        {2, 1000.0F, 0},                          //
        {3, 1000.0F, -938},                       // -cos 20.25 = -0.93819
        {4, 100.0F, -1275},                       // the sensor temperature, -12.75 °C, before it is rounded for 4060h
        {5, 100.0F, 2025},                        //
        {6, 100.0F, 0},                           //
        {7, 100.0F, 2025},                        //
        {8, 1.0F, 0},                             // the filter latency: 0, because the input filter is off
        {9, 1.0F, 0},                             //
        {20, 100.0F, 1500},                       // one count per unit
        {21, 100.0F, 2500},                       //
        {22, 100.0F, 3500},                       //
        {23, 1.0F, 77},                           //
        {24, 100.0F, -250},                       //
        {25, 1.0F, 0},                            //
        {26, 1.0F, 1},                            //
        {27, 100.0F, 1125},                       //
        {28, 100.0F, 4150},                       //
    };
    for (const auto& row : rows) {
        EXPECT_EQ(taken_from(row.source, row.scale), row.expected) << row.source;
    }
    turn(0.0, 30.0);
    EXPECT_EQ(taken_from(2, 1000.0F), -500);
    EXPECT_EQ(taken_from(6, 100.0F), 3000);
    write(0x2002, 0, 1, 1);
    EXPECT_EQ(taken_from(8, 100.0F), 3183);  // source 8: the delay of the input filter, 31.83 ms
    inputs.sensor_temperature = 130.0F;
    set_inputs();
    EXPECT_EQ(taken_from(9, 1.0F), 1);
    EXPECT_EQ(refusal(at(1, 0), 1, 29, 1), "06090031");
}

TEST_F(Ax060805Functions, StoredFunctionsWorkFromTheFirstSampleOn) {
    verifies<req::INC_BIN_001, req::INC_BIN_009, req::INC_STORE_001>();
    for (const int function : {1, 10}) {
        operate(function, 1);
        connect(function, 1, 26);  // source 26, which gives 1.0
        connect(function, 2, 26);
    }
    write(0x1010, 1, 0x65766173, 4);
    power_on();
    EXPECT_EQ(output(1), 2);
    EXPECT_EQ(output(10), 2);
}

TEST_F(Ax060805Functions, FunctionsUseTheMeasurementsOfTheFirstSample) {
    verifies<req::INC_BIN_009, req::INC_GLOBAL_003>();
    operate(1, 1);
    connect(1, 1, 27);  // source 27, the supply
    connect(1, 2, 25);  // source 25, which gives 0
    operate(2, 1);
    connect(2, 1, 9);  // source 9 is the figure of merit
    connect(2, 2, 25);
    write(0x1010, 1, 0x65766173, 4);
    inputs.supply_voltage = 12.0F;
    inputs.sensor_temperature = 130.0F;
    power_on();
    EXPECT_EQ(output(1), 12);
    const int figure_of_merit = static_cast<int>(read(0x4020));
    EXPECT_EQ(output(2), figure_of_merit);
    EXPECT_NE(figure_of_merit, 0);
}

TEST_F(Ax060805Functions, EachOfTheTenFunctionsCanBeConnectedAsASource) {
    verifies<req::INC_T1, req::INC_SIG_006, req::INC_OD_300A, req::INC_OD_300B, req::INC_OD_300C, req::INC_BIN_011>();
    verifies<req::INC_OD_3010, req::INC_OD_3020, req::INC_OD_3030, req::INC_OD_3040, req::INC_OD_3050, req::INC_OD_3060,
             req::INC_OD_3070, req::INC_OD_3080, req::INC_OD_3090, req::INC_OD_30A0>();
    for (int function = 2; function <= 10; ++function) {
        operate(function, 1);
        connect(function, 1, 26);  // source 26, which gives 1.0
        connect(function, 2, 26);
        scale_output(function, static_cast<float>(function));
        write_real(0x300C, static_cast<std::uint8_t>(function), 100.0F);
    }
    pass(5);
    for (int function = 2; function <= 10; ++function) {
        EXPECT_EQ(output(function), 100 + 2 * function);
        EXPECT_EQ(taken_from(static_cast<std::uint32_t>(9 + function), 10.0F), 1000 + 20 * function) << function;
    }
    EXPECT_EQ(taken_from(10, 1.0F), 1200);  // source 10 is the result of function 1 itself, of the previous sample
}

TEST_F(Ax060805Functions, EveryParameterOfEachFunctionHasAnEffect) {
    verifies<req::INC_BIN_001, req::INC_BIN_012, req::INC_BIN_013, req::INC_BIN_011>();
    verifies<req::INC_OD_3011, req::INC_OD_3021, req::INC_OD_3031, req::INC_OD_3041, req::INC_OD_3051, req::INC_OD_3061,
             req::INC_OD_3071, req::INC_OD_3081, req::INC_OD_3091, req::INC_OD_30A1>();
    verifies<req::INC_OD_3012, req::INC_OD_3022, req::INC_OD_3032, req::INC_OD_3042, req::INC_OD_3052, req::INC_OD_3062,
             req::INC_OD_3072, req::INC_OD_3082, req::INC_OD_3092, req::INC_OD_30A2>();
    verifies<req::INC_OD_3013, req::INC_OD_3023, req::INC_OD_3033, req::INC_OD_3043, req::INC_OD_3053, req::INC_OD_3063,
             req::INC_OD_3073, req::INC_OD_3083, req::INC_OD_3093, req::INC_OD_30A3>();
    verifies<req::INC_OD_3014, req::INC_OD_3024, req::INC_OD_3034, req::INC_OD_3044, req::INC_OD_3054, req::INC_OD_3064,
             req::INC_OD_3074, req::INC_OD_3084, req::INC_OD_3094, req::INC_OD_30A4>();
    verifies<req::INC_OD_3015, req::INC_OD_3025, req::INC_OD_3035, req::INC_OD_3045, req::INC_OD_3055, req::INC_OD_3065,
             req::INC_OD_3075, req::INC_OD_3085, req::INC_OD_3095, req::INC_OD_30A5>();
    for (int function = 1; function <= 10; ++function) {
        const auto sub = static_cast<std::uint8_t>(function);
        operate(function, 2);
        give_default(function, 1, -30.0F);
        write(at(function, 3), 1, 3, 1);       // input 1: the absolute value of -30 is 30
        write_real(at(function, 4), 1, 2.0F);  // input 1: gain 2 gives 30 * 2 = 60
        write_real(at(function, 5), 1, 1.0F);  // input 1: offset 1 gives 60 + 1 = 61
        give_default(function, 2, 4.0F);
        write(at(function, 3), 2, 1, 1);        // input 2: the logical inverse of 4 is 0
        write_real(at(function, 4), 2, 3.0F);   // input 2: gain 3 gives 0 * 3 = 0
        write_real(at(function, 5), 2, -9.0F);  // input 2: offset -9 gives 0 - 9 = -9
        write_real(0x300B, sub, 10.0F);         // output: (61 - -9) * 10 = 700
        write_real(0x300C, sub, static_cast<float>(function));
        pass(5);
        EXPECT_EQ(output(function), 700 + function);
        write(at(function, 3), 2, 0, 1);  // input 2: 4 * 3 - 9 = 3; output: (61 - 3) * 10 = 580
        pass(5);
        EXPECT_EQ(output(function), 580 + function);
        write(at(function, 1), 2, 0, 1);
        pass(5);
        EXPECT_EQ(output(function), 0);  // the result is undefined, which is shown as 0
        write(at(function, 1), 2, 1, 1);
        write(at(function, 1), 1, 0, 1);
        pass(5);
        EXPECT_EQ(output(function), 0);
    }
}

// Table 1: binary function N is the source 9 + N. A function that reads an undefined source takes its default value.
TEST_F(Ax060805Functions, OutputOfEachFunctionIsUndefinedAsShipped) {
    verifies<req::INC_BIN_010>();
    for (std::uint32_t function = 2; function <= 10; ++function) {
        EXPECT_EQ(taken_from(9 + function, 1.0F), undefined) << function;
    }
}

TEST_F(Ax060805Functions, OutputOfFunction1IsUndefinedAsShipped) {
    verifies<req::INC_BIN_010>();
    operate(2, 1);
    connect(2, 1, 10);
    give_default(2, 1, 1234.0F);
    give_default(2, 2, 0.0F);
    pass(5);
    EXPECT_EQ(output(2), 1234);
}

TEST_F(Ax060805Functions, ParametersOutsideTheirRangesAreRefused) {
    verifies<req::INC_OD_300A, req::INC_OD_300B, req::INC_OD_300C, req::INC_OD_3011, req::INC_OD_3012, req::INC_OD_3013,
             req::INC_OD_3014, req::INC_OD_3015>();
    EXPECT_EQ(refusal(0x300A, 1, 20, 1), "");
    EXPECT_EQ(refusal(0x300A, 1, 21, 1), "06090031");
    for (int function = 1; function <= 10; ++function) {
        for (std::uint8_t input = 1; input <= 2; ++input) {
            EXPECT_EQ(refusal(at(function, 0), input, 28, 1), "");
            EXPECT_EQ(refusal(at(function, 0), input, 29, 1), "06090031");
            EXPECT_EQ(refusal(at(function, 1), input, 1, 1), "");
            EXPECT_EQ(refusal(at(function, 1), input, 2, 1), "06090031");
            EXPECT_EQ(refusal(at(function, 3), input, 3, 1), "");
            EXPECT_EQ(refusal(at(function, 3), input, 4, 1), "06090031");
            for (const int real : {2, 4, 5}) {
                EXPECT_EQ(refusal(at(function, real), input, bits_of(-4294967295.0F), 4), "");
                EXPECT_EQ(refusal(at(function, real), input, bits_of(4294967295.0F), 4), "");
                EXPECT_EQ(refusal(at(function, real), input, bits_of(1.0e10F), 4), "06090031");
                EXPECT_EQ(refusal(at(function, real), input, bits_of(-1.0e10F), 4), "06090032");
            }
        }
    }
    for (const std::uint16_t index : std::vector<std::uint16_t>{0x300B, 0x300C}) {
        EXPECT_EQ(refusal(index, 10, bits_of(4294967295.0F), 4), "");
        EXPECT_EQ(refusal(index, 10, bits_of(1.0e10F), 4), "06090031");
        EXPECT_EQ(refusal(index, 10, bits_of(-1.0e10F), 4), "06090032");
    }
}

TEST_F(Ax060805Functions, FunctionInputsAreNotConnectedAsShipped) {
    verifies<req::INC_BIN_010>();
    turn(30.0, 30.0);
    pass(10);
    for (int function = 1; function <= 10; ++function) {
        EXPECT_EQ(output(function), 0);
        for (std::uint8_t input = 1; input <= 2; ++input) {
            EXPECT_EQ(read(at(function, 0), input), 0U);
            EXPECT_EQ(read(at(function, 1), input), 0U);
            EXPECT_EQ(real(at(function, 2), input), 0.0F);
            EXPECT_EQ(read(at(function, 3), input), 0U);
            EXPECT_EQ(real(at(function, 4), input), 1.0F);
            EXPECT_EQ(real(at(function, 5), input), 0.0F);
        }
        EXPECT_EQ(read(0x300A, static_cast<std::uint8_t>(function)), 0U);
        EXPECT_EQ(real(0x300B, static_cast<std::uint8_t>(function)), 1.0F);
        EXPECT_EQ(real(0x300C, static_cast<std::uint8_t>(function)), 0.0F);
    }
    // The output of a function whose operation is set but whose inputs are not connected stays 0.
    operate(1, 1);
    pass(5);
    EXPECT_EQ(output(1), 0);
}

TEST_F(Ax060805Functions, UndefinedInputUsesItsDefaultOrMakesTheResultUndefined) {
    verifies<req::INC_BIN_002, req::INC_BIN_014, req::INC_SIG_002>();
    operate(1, 1);
    connect(1, 1, 26);
    pass(5);
    EXPECT_EQ(output(1), 0);
    give_default(1, 2, 41.0F);
    pass(5);
    EXPECT_EQ(output(1), 42);
    operate(2, 1);
    connect(2, 1, 12);  // function 3 is undefined
    give_default(2, 1, 5.0F);
    connect(2, 2, 26);
    pass(5);
    EXPECT_EQ(output(2), 6);
    operate(3, 1);
    connect(3, 1, 26);
    connect(3, 2, 26);
    pass(10);
    EXPECT_EQ(output(2), 3);
}

TEST_F(Ax060805Functions, UndefinedResultMakesDependentResultsUndefined) {
    verifies<req::INC_SIG_002, req::INC_BIN_014, req::INC_BIN_007>();
    operate(1, 0);
    connect(1, 1, 26);
    connect(1, 2, 26);
    operate(2, 1);
    connect(2, 1, 10);
    connect(2, 2, 26);
    pass(5);
    EXPECT_EQ(output(1), 0);
    EXPECT_EQ(output(2), 0);
    operate(1, 4);
    pass(5);
    EXPECT_EQ(output(2), 2);
}

TEST_F(Ax060805Functions, FunctionOutputsAreShownRoundedButPassedOnUnrounded) {
    verifies<req::INC_BIN_008, req::INC_BIN_015, req::INC_OD_3000>();
    operate(1, 1);
    give_default(1, 1, 2.5F);
    give_default(1, 2, 0.0F);
    pass(5);
    EXPECT_EQ(output(1), 3);
    operate(2, 3);
    connect(2, 1, 10);
    give_default(2, 2, 100.0F);
    pass(5);
    EXPECT_EQ(output(2), 250);
    scale_output(1, 20000.0F);
    pass(5);
    EXPECT_EQ(output(1), 32767);
    scale_output(1, -20000.0F);
    pass(5);
    EXPECT_EQ(output(1), -32768);
    write_real(at(2, 2), 2, 0.0001F);
    pass(5);
    EXPECT_EQ(output(2), -5);  // -50000 * 0.0001 = -5
    EXPECT_EQ(refusal(0x3000, 1, 5, 2), "06010002");
}

TEST_F(Ax060805Functions, FunctionsAreEvaluatedInTheOrderOfTheirNumbersAtEachSample) {
    verifies<req::INC_BIN_009, req::INC_BIN_016>();
    for (const int function : {1, 2, 3}) {
        operate(function, 1);
        give_default(function, 2, 1.0F);
    }
    connect(2, 1, 10);
    connect(3, 1, 11);
    connect(1, 1, 12);  // a ring: function 1 uses the result of function 3 of the previous sample
    give_default(1, 1, 0.0F);
    EXPECT_EQ(output(3), 0);  // 3000h:3 (result of function 3) changes with the next sample, not at the writes
    pass(5);
    EXPECT_EQ(output(1), 1);
    EXPECT_EQ(output(2), 2);
    EXPECT_EQ(output(3), 3);
    pass(5);
    EXPECT_EQ(output(1), 4);
    EXPECT_EQ(output(3), 6);
}

TEST_F(Ax060805Functions, FunctionsAreNotComputedAtATickOfTheFiltersBetweenTwoSamples) {
    verifies<req::INC_BIN_009>();
    write(0x2052, 0, 7, 2);  // 2052h (angular filter rate) in ms
    operate(1, 1);
    connect(1, 1, 10);  // function 1 adds 1 to its own result
    give_default(1, 1, 0.0F);
    give_default(1, 2, 1.0F);
    pass(35);  // 35 ms / 5 ms = 7 samples; the filters have ticks at 7, 14, 21 and 28 ms, too
    EXPECT_EQ(output(1), 7);
}

TEST_F(Ax060805Functions, SignalsOfAFailedSensorAreUndefined) {
    verifies<req::INC_SIG_002, req::INC_FV_011>();
    inputs.accelerometer_fault = true;
    set_inputs();
    for (const std::uint32_t source : {1U, 2U, 3U, 5U, 6U, 7U}) {
        EXPECT_EQ(taken_from(source, 1.0F), undefined) << source;
    }
    EXPECT_EQ(taken_from(4, 1.0F), 25);
    EXPECT_EQ(taken_from(9, 1.0F), 2);
    inputs.sensor_temperature = NAN;
    set_inputs();
    EXPECT_EQ(taken_from(4, 1.0F), undefined);
}

TEST_F(Ax060805Functions, OneSourceCanBeConnectedToManyInputs) {
    verifies<req::INC_SIG_007>();
    for (int function = 1; function <= 10; ++function) {
        operate(function, 1);
        connect(function, 1, 5);
        connect(function, 2, 5);
    }
    turn(15.0, 0.0);
    pass(5);
    for (int function = 1; function <= 10; ++function) {
        EXPECT_EQ(output(function), 30);
    }
}

TEST_F(Ax060805Functions, BitwiseFunctionCombinesADiscreteAndATruncatedContinuousConstant) {
    verifies<req::INC_SIG_003, req::INC_SIG_004, req::INC_OD_4080, req::INC_OD_4070, req::INC_GLOBAL_003>();
    write(0x4080, 0, 0xF0, 4);
    write_real(0x4070, 0, 60.9F);  // 60.9 is cut to 60 = 3Ch
    operate(1, 17);
    connect(1, 1, 23);
    connect(1, 2, 24);
    pass(5);
    EXPECT_EQ(output(1), 0x30);
    write(0x4080, 0, 0xFFFFFFFF, 4);
    pass(5);
    EXPECT_EQ(output(1), 0x3C);
    EXPECT_EQ(refusal(0x4070, 0, bits_of(1.0e10F), 4), "06090031");
    EXPECT_EQ(refusal(0x4070, 0, bits_of(-1.0e10F), 4), "06090032");
}

}  // namespace canproof::test
