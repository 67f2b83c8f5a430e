// SPDX-License-Identifier: Apache-2.0
// Checks that a reset of the CAN-CBX-AO412 clears its state. The property itself is in
// properties/support/reset_law.hpp.
#include <gtest/gtest.h>

#include "properties/support/reset_law.hpp"
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

struct CbxAo412Reset : UsualTraits {
    using Device = cbx_ao412::Device;
    using Inputs = cbx_ao412::Inputs;
    using FactoryData = cbx_ao412::FactoryData;
    static constexpr std::size_t memory_size = 1024;

    /// Returns whether an output keeps its value when the node is reset. It does during an internal failure if 6443h
    /// (Analogue Output Error Mode) is 2 (section 7.10.3).
    static bool keeps_outputs(const Device& device, const Inputs& inputs) {
        bool keeps = false;
        for (std::uint8_t output = 1; output <= 4; ++output) {
            keeps = keeps || device.objects().read(0x6443, output) == 2;
        }
        return keeps && (inputs.internal_fault || inputs.hardware_fault);
    }
    static const std::vector<Setting>& settings() {
        static const std::vector<Setting> all{
            {0x6411, 4, 2, {0, 5000, 0xEC78, 32767}},
            {0x6443, 4, 1, {0, 1, 2}},
            {0x6444, 4, 4, {0, 0x20000000, 0xE0000000}},
            {0x2404, 4, 2, {0, 900, 0xFC7C}},
            {0x2405, 4, 2, {0, 3000, 0xF448}},
            {0x1F91, 6, 2, {0, 30, 500}},
            {0x1F80, 0, 4, {0, 8}},
        };
        return all;
    }
    static const std::vector<InputChoice>& inputs() {
        static const std::vector<InputChoice> all{
            {"internal_fault", {0, 1}},
            {"hardware_fault", {0, 1}},
        };
        return all;
    }
};

}  // namespace

RC_GTEST_PROP(CbxAo412Reset, ResetNodeStartsTheDeviceAsPowerOnDoes, ()) {
    verifies<req::CO_NMT_005>("property");
    restart_law<CbxAo412Reset>(Reset::node);
}

RC_GTEST_PROP(CbxAo412Reset, PowerOnClearsAllEarlierState, ()) {
    verifies<req::CO_NMT_001>("property");
    restart_law<CbxAo412Reset>(Reset::power);
}

RC_GTEST_PROP(CbxAo412Reset, ResetCommunicationRestartsCommunicationAndKeepsTheApplication, ()) {
    verifies<req::CO_NMT_006>("property");
    communication_law<CbxAo412Reset>();
}

}  // namespace canproof::test
