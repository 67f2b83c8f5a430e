// SPDX-License-Identifier: Apache-2.0
// Checks that a reset of the AX130751 clears its state. The property itself is in properties/support/reset_law.hpp.
#include <gtest/gtest.h>

#include "properties/support/reset_law.hpp"
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "devices/ax130751/firmware/ax130751.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

struct Ax130751Reset : UsualTraits {
    using Device = ax130751::Device;
    using Inputs = ax130751::Inputs;
    using FactoryData = ax130751::FactoryData;
    static constexpr std::size_t memory_size = 8192;

    /// Returns whether the property may write an object. It must not write 5B50h (Change Baud Rate) and 5B51h (Change
    /// Node ID), which take effect at the next power-on and not with reset node.
    static bool may_write(unsigned index) { return index != 0x5B50U && index != 0x5B51U; }
    /// Returns writes after which the device has states that change by themselves: a ramp, a latched relay with a
    /// delay, and a time profile that the supply voltage starts.
    static std::vector<Write> lively() {
        return {{0x5555, 0, 1, 1},   {0x2330, 1, 2, 700}, {0x2242, 1, 1, 3},   {0x22A0, 1, 1, 1},
                {0x22A1, 1, 4, 25},  {0x3010, 0, 1, 8},   {0x3011, 0, 1, 1},   {0x3015, 1, 1, 1},
                {0x3016, 2, 4, 500}, {0x3016, 3, 4, 900}, {0x3017, 2, 2, 300}, {0x3017, 3, 2, 600}};
    }
    static const std::vector<Setting>& settings() {
        static const std::vector<Setting> all{
            {0x6310, 2, 2, {0, 10, 20, 40, 500, 1000, 1020}},
            {0x7300, 2, 2, {0, 2500, 5000, 0xFC18}},
            {0x6220, 3, 1, {0, 1}},
            {0x2500, 6, 2, {0, 1, 250, 990}},
            {0x2330, 2, 2, {0, 20, 700}},
            {0x2331, 2, 2, {0, 20, 700}},
            {0x2340, 2, 1, {0, 1, 2, 3, 4, 5}},
            {0x2341, 2, 1, {1, 2, 3}},
            {0x2350, 2, 1, {0, 1, 2}},
            {0x2351, 2, 1, {1, 2, 3, 4}},
            {0x2352, 2, 1, {0, 1, 2, 3, 4, 5}},
            {0x2360, 2, 1, {0, 1, 2}},
            {0x2361, 2, 1, {1, 2, 3}},
            {0x2362, 2, 1, {0, 1}},
            {0x2300, 2, 2, {0, 1, 3000}},
            {0x6340, 2, 1, {0, 1}},
            {0x7341, 2, 2, {0, 1500}},
            {0x2241, 2, 1, {0, 1, 2, 3}},
            {0x2223, 2, 2, {0, 15, 300}},
            {0x6250, 2, 1, {0, 1}},
            {0x6260, 2, 1, {0, 1}},
            {0x2242, 1, 1, {1, 2, 3, 4, 5}},
            {0x2250, 1, 2, {0, 10, 400}},
            {0x2260, 1, 1, {0, 1, 2}},
            {0x2261, 1, 1, {1, 2, 3, 4}},
            {0x2270, 1, 1, {0, 1, 2}},
            {0x2271, 1, 1, {1, 2, 3}},
            {0x2280, 1, 1, {0, 1, 2}},
            {0x2281, 1, 1, {1, 2, 3}},
            {0x2282, 1, 1, {0, 1, 2, 3, 4, 5}},
            {0x2290, 1, 1, {0, 1, 2}},
            {0x2291, 1, 1, {1, 2, 3}},
            {0x2292, 1, 1, {0, 1}},
            {0x2293, 1, 1, {0, 1}},
            {0x22A0, 1, 1, {0, 1}},
            {0x22A1, 1, 4, {0, 25, 600}},
            {0x22A2, 1, 4, {0, 25, 600}},
            {0x3010, 0, 1, {0, 1, 2, 3}},
            {0x3011, 0, 1, {1, 2, 3}},
            {0x3012, 0, 1, {0, 1}},
            {0x3015, 11, 1, {0, 1, 2}},
            {0x3016, 11, 4, {0, 5, 20, 60}},
            {0x3017, 11, 2, {0, 30, 0xFF38}},
            {0x3300, 3, 1, {0, 1}},
            {0x3401, 3, 1, {1, 2, 3}},
            {0x4000, 4, 1, {0, 1}},
            {0x4100, 4, 1, {0, 1, 2, 3}},
            {0x4101, 4, 1, {1, 2, 3}},
            {0x4150, 3, 1, {0, 12, 13, 14, 15}},
            {0x5021, 0, 1, {0, 1}},
            {0x5025, 0, 1, {0, 1}},
            {0x5031, 0, 1, {0, 1}},
            {0x5034, 0, 1, {0, 1}},
            {0x5555, 0, 1, {0, 1}},
        };
        return all;
    }
    static const std::vector<InputChoice>& inputs() {
        static const std::vector<InputChoice> all{
            {"supply", {24, 6, 8.5, 38, 41}},
            {"cpu_temperature", {35, 95, 70}},
            {"load1", {250, 5000}},
            {"load2", {250, 5000}},
        };
        return all;
    }
};

}  // namespace

RC_GTEST_PROP(Ax130751Reset, ResetNodeStartsTheDeviceAsPowerOnDoes, ()) {
    verifies<req::CO_NMT_005>("property");
    restart_law<Ax130751Reset>(Reset::node);
}

RC_GTEST_PROP(Ax130751Reset, PowerOnClearsAllEarlierState, ()) {
    verifies<req::CO_NMT_001>("property");
    restart_law<Ax130751Reset>(Reset::power);
}

RC_GTEST_PROP(Ax130751Reset, ResetCommunicationRestartsCommunicationAndKeepsTheApplication, ()) {
    verifies<req::CO_NMT_006>("property");
    communication_law<Ax130751Reset>();
}

RC_GTEST_PROP(Ax130751Reset, NodeIdChangeByLssKeepsTheApplicationRunning, ()) {
    verifies<req::CO_LSS_011, req::CO_LSS_018>("property");
    lss_law<Ax130751Reset>();
}

}  // namespace canproof::test
