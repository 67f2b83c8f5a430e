// SPDX-License-Identifier: Apache-2.0
// 29-bit identifiers (CiA 301, 7.2): a frame with a 29-bit identifier reaches no service, even when its identifier has
// the same value as the 11-bit identifier of the service.
#include <gtest/gtest.h>

#include "generated/canopen/requirements.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class IdentifierFormat : public CbxTest {
  protected:
    void SetUp() override {
        CbxTest::SetUp();
        send("000#0103");
    }
    /// Sends `frame` with its identifier in the 29-bit format.
    Frames send_as_29_bits(const std::string& frame) { return send("00000" + frame); }
};

}  // namespace

/// Reset communication comes last in the list, because it makes the node leave operational.
TEST_F(IdentifierFormat, SdoPdoGuardingAndNmtIgnore29BitFrames) {
    verifies<req::CO_FRAME_001>();
    for (const char* const request : {"603#4000100000000000", "303#R8", "703#R1", "000#8203"}) {
        EXPECT_EQ(send_as_29_bits(request), Frames{}) << request;
        EXPECT_EQ(send(request).size(), 1U) << request;
    }
}

/// A heartbeat in the 29-bit format neither begins the monitoring of its producer nor keeps the producer alive.
TEST_F(IdentifierFormat, HeartbeatConsumerIgnores29BitFrames) {
    verifies<req::CO_FRAME_001>();
    write("603#2316100164000500");  // 1016h:1 consumer heartbeat time: node 5, 100 ms
    send_as_29_bits("705#05");
    EXPECT_EQ(pass(200), Frames{});
    send("705#05");
    pass(60);
    send_as_29_bits("705#05");
    EXPECT_EQ(pass(39), Frames{});
    EXPECT_EQ(pass(1), (Frames{"1:083#3081110100000000"})) << "error 8130h: a heartbeat is missing";
}

}  // namespace canproof::test
