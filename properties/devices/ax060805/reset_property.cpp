// SPDX-License-Identifier: Apache-2.0
// Checks that a reset of the AX060805 clears its state. The property itself is in properties/support/reset_law.hpp.
#include <gtest/gtest.h>

#include "properties/support/reset_law.hpp"
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "devices/ax060805/firmware/ax060805.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

struct Ax060805Reset : UsualTraits {
    using Device = ax060805::Device;
    using Inputs = ax060805::Inputs;
    using FactoryData = ax060805::FactoryData;
    static constexpr std::size_t memory_size = 4096;

    /// Returns writes that connect function blocks: functions 1 and 2 form a loop that counts up, and function 3 adds 1
    /// to the value that RPDO1 receives.
    static std::vector<Write> lively() {
        return {{0x300A, 1, 1, 1},  {0x3010, 1, 1, 11}, {0x3011, 1, 1, 1}, {0x3010, 2, 1, 26}, {0x300A, 2, 1, 1},
                {0x3020, 1, 1, 10}, {0x3020, 2, 1, 25}, {0x300A, 3, 1, 1}, {0x3030, 1, 1, 20}, {0x3030, 2, 1, 26}};
    }
    static const std::vector<Setting>& settings() {
        static const std::vector<Setting> all{
            {0x2000, 0, 1, {0, 1}},
            {0x2002, 0, 1, {0, 1}},
            {0x2003, 0, 1, {1, 5, 50}},
            {0x2010, 3, 2, {1, 10}},
            {0x2011, 3, 1, {0, 1}},
            {0x2050, 3, 1, {0, 1, 2}},
            {0x2051, 3, 2, {1, 3, 20, 200}},
            {0x2052, 0, 2, {3, 10, 35}},
            {0x2100, 0, 1, {0, 1}},
            {0x2200, 0, 4, {0x00000000, 0x41480000}},
            {0x2210, 0, 4, {0x00000000, 0xC1F00000}},
            {0x2300, 0, 1, {0, 1}},
            {0x300A, 10, 1, {0, 1, 2, 5, 10}},
            {0x300B, 10, 4, {0x3F800000, 0x40400000}},
            {0x3010, 2, 1, {1, 3, 10, 14, 20, 21, 30}},
            {0x3020, 2, 1, {20, 21, 22, 23, 30, 31}},
            {0x3011, 2, 1, {0, 1}},
            {0x3012, 2, 4, {0x00000000, 0x40E00000}},
            {0x3013, 2, 1, {0, 1, 2}},
            {0x2500, 3, 2, {0, 500, 0xFFBA}},
            {0x2501, 3, 2, {10, 1000}},
            {0x4070, 0, 4, {0x00000000, 0x40C00000}},
            {0x4080, 0, 4, {0, 9}},
            {0x5555, 0, 1, {0, 1}},
        };
        return all;
    }
    static const std::vector<InputChoice>& inputs() {
        static const std::vector<InputChoice> all{
            {"acceleration_x", {0, 0.5, -0.7, 9}},
            {"acceleration_y", {0, 0.3}},
            {"acceleration_z", {-1, 0.8, 0}},
            {"accelerometer_fault", {0, 1}},
            {"sensor_temperature", {25, 130, -60}},
            {"processor_temperature", {30, 80}},
            {"supply_voltage", {23, 9}},
        };
        return all;
    }
};

}  // namespace

RC_GTEST_PROP(Ax060805Reset, ResetNodeStartsTheDeviceAsPowerOnDoes, ()) {
    verifies<req::CO_NMT_005>("property");
    restart_law<Ax060805Reset>(Reset::node);
}

RC_GTEST_PROP(Ax060805Reset, PowerOnClearsAllEarlierState, ()) {
    verifies<req::CO_NMT_001>("property");
    restart_law<Ax060805Reset>(Reset::power);
}

RC_GTEST_PROP(Ax060805Reset, ResetCommunicationRestartsCommunicationAndKeepsTheApplication, ()) {
    verifies<req::CO_NMT_006, req::CO_EMCY_018>("property");
    communication_law<Ax060805Reset>();
}

RC_GTEST_PROP(Ax060805Reset, NodeIdChangeByLssKeepsTheApplicationRunning, ()) {
    verifies<req::CO_LSS_011, req::CO_LSS_018>("property");
    lss_law<Ax060805Reset>();
}

}  // namespace canproof::test
