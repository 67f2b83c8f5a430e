// SPDX-License-Identifier: Apache-2.0
// Checks that a reset of the AX188001 clears its state. The property itself is in properties/support/reset_law.hpp.
#include <gtest/gtest.h>

#include "properties/support/reset_law.hpp"
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "devices/ax188001/firmware/ax188001.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

struct Ax188001Reset : UsualTraits {
    using Device = ax188001::Device;
    using Inputs = ax188001::Inputs;
    using FactoryData = ax188001::FactoryData;
    static constexpr std::size_t memory_size = 4096;

    static const std::vector<Setting>& settings() {
        static const std::vector<Setting> all{
            {0x6110, 2, 2, {1, 2, 3, 4, 5}},
            {0x6112, 2, 1, {0, 1}},
            {0x2000, 2, 1, {0, 1}},
            {0x2020, 0, 1, {50, 60}},
            {0x2112, 0, 1, {0, 1}},
            {0x6126, 2, 4, {0x41800000, 0x3F800000}},
            {0x2127, 0, 4, {0x00000000, 0x42C80000}},
            {0x4000, 2, 2, {0xFF38, 0xF830, 240}},
            {0x4010, 2, 2, {1250, 300, 2000}},
            {0x4020, 2, 2, {2500, 500}},
            {0x4030, 2, 2, {0, 30, 700, 5000}},
            {0x5041, 3, 2, {1100, 900, 500, 90}},
            {0x5042, 3, 2, {850, 480, 120}},
            {0x5050, 2, 1, {0, 1}},
            {0x5051, 2, 2, {0, 30, 700}},
            {0x5555, 0, 1, {0, 1, 2}},
            {0x5556, 0, 2, {0, 20, 400}},
        };
        return all;
    }
    static const std::vector<InputChoice>& inputs() {
        static const std::vector<InputChoice> all{
            {"tc1_microvolts", {0, 8000, -3000, 60000}},
            {"tc2_microvolts", {0, 9000, -4000, 70000}},
            {"tc1_open", {0, 1}},
            {"tc2_open", {0, 1}},
            {"tc1_hum", {0, 30000}},
            {"mains_frequency", {50, 60, 0}},
            {"cold_junction", {25, -10}},
            {"cpu_temperature", {35, 115}},
            {"supply", {24, 8, 52}},
        };
        return all;
    }
};

}  // namespace

RC_GTEST_PROP(Ax188001Reset, ResetNodeStartsTheDeviceAsPowerOnDoes, ()) {
    verifies<req::CO_NMT_005>("property");
    restart_law<Ax188001Reset>(Reset::node);
}

RC_GTEST_PROP(Ax188001Reset, PowerOnClearsAllEarlierState, ()) {
    verifies<req::CO_NMT_001>("property");
    restart_law<Ax188001Reset>(Reset::power);
}

RC_GTEST_PROP(Ax188001Reset, ResetCommunicationRestartsCommunicationAndKeepsTheApplication, ()) {
    verifies<req::CO_NMT_006, req::CO_EMCY_018>("property");
    communication_law<Ax188001Reset>();
}

RC_GTEST_PROP(Ax188001Reset, NodeIdChangeByLssKeepsTheApplicationRunning, ()) {
    verifies<req::CO_LSS_011, req::CO_LSS_018>("property");
    lss_law<Ax188001Reset>();
}

}  // namespace canproof::test
