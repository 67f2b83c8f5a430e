// SPDX-License-Identifier: Apache-2.0
// Replays the LSS session of a screen capture to each device. The capture is in the Axiomatic manuals: AX130751 3.1.3,
// AX188001 3.1.1.2, AX060805 4.1.1.2.
#include <gtest/gtest.h>

#include <sstream>

#include "devices/catalogue.hpp"
#include "generated/canopen/requirements.hpp"
#include "host/sim/devices/simulated_device.hpp"
#include "host/sim/replay/replay.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// Frames 95, 96, 98, 99 and 101 of the capture, which the configuration tool sent. Second 0 of this log is
/// 11:42:44.248 in the capture.
const char* const captured =
    "(1.000000) can0 7E5#0401\n"
    "(10.220000) can0 7E5#130003\n"
    "(14.439000) can0 7E5#158813\n"
    "(32.331000) can0 7E5#17\n"
    "(38.769000) can0 7E5#0400\n";

/// The frames that the device must send: the boot-up message of power-on, then frames 97, 100 and 102 of the capture.
/// The device of the capture took 328 ms to store; a replay does not model this time.
const char* const answered =
    "(0.000000) can0 750#00\n"
    "(10.220000) can0 7E4#130000\n"
    "(32.331000) can0 7E4#170000\n"
    "(38.769000) can0 750#00\n";

std::string replayed(host::SimulatedDevice& device, const std::string& log) {
    std::istringstream in{log};
    std::ostringstream out;
    host::ReplayInput input;
    input.frames = host::read_candump_log(in, "capture");
    host::replay(device, input, out, nullptr);
    return out.str();
}

class LssReplay : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(LssReplay, ReplayOfTheCapturedLssSessionGivesTheSameBytes) {
    verifies<req::CO_LSS_019, req::CO_LSS_018, req::CO_LSS_081>();
    const auto device = host::make_device(GetParam());
    ASSERT_NE(device, nullptr);
    device->set_node_id(80);
    EXPECT_EQ(replayed(*device, captured), answered);
    EXPECT_EQ(device->node_id(), 80);
    EXPECT_EQ(device->bit_rate(), 250000U);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
}

TEST_P(LssReplay, ConfigurationStoredInTheLssSessionIsUsedAfterPowerOn) {
    verifies<req::CO_LSS_019, req::CO_LSS_017>();
    const auto device = host::make_device(GetParam());
    ASSERT_NE(device, nullptr);
    device->set_node_id(80);
    replayed(*device, captured);
    EXPECT_EQ(replayed(*device, "(0.500000) can0 7E5#5E\n"), "(0.000000) can0 750#00\n");
    EXPECT_EQ(device->bit_rate(), 250000U);
}

// Power fails between activate bit timing and store configuration: the node boots at 125 kbit/s.
TEST_P(LssReplay, ConfigurationOfAnLssSessionWithoutStoreIsLostAtPowerOn) {
    verifies<req::CO_LSS_017>();
    const auto device = host::make_device(GetParam());
    ASSERT_NE(device, nullptr);
    device->set_node_id(80);
    const std::string log = captured;
    replayed(*device, log.substr(0, log.find("(32.")) + "(30.000000) can0 7E5#5E\n");
    EXPECT_EQ(device->bit_rate(), 250000U);
    replayed(*device, "(0.500000) can0 7E5#5E\n");
    EXPECT_EQ(device->bit_rate(), 125000U);
}

INSTANTIATE_TEST_SUITE_P(Manuals, LssReplay, testing::Values("ax130751", "ax188001", "ax060805"));

}  // namespace canproof::test
