// SPDX-License-Identifier: Apache-2.0
// Tests that a receive PDO with a value that is refused counts as not received, and that error 8200h reports it (CiA
// 301, 7.2.7.1, 7.5.2.35).
#include "generated/canopen/requirements.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/rpdo_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class MovingLimit : public testing::Test, public AlteredSlaveBench {};

}  // namespace

TEST_F(Rpdo, DummyBehindAValueWithLimitsMayHaveAnyBits) {
    verifies<req::CO_PDO_012, req::CO_PDO_005>();
    map_rpdo3({"10000022", "08000500"});  // maps 2200h, which accepts -100 … 100, and a gap of 8 bits
    talk(*this, {
                    {"405#6400FF", {}},
                    {"605#4000220000000000", {"585#4B00220064000000"}},
                    {"405#650000", {"085#0082110100000000"}},  // 101 is refused
                    {"605#4000220000000000", {"585#4B00220064000000"}},
                    {"405#630080", {"085#0000000100000000"}},
                    {"605#4000220000000000", {"585#4B00220063000000"}},
                });
}

TEST_F(Rpdo, RefusedRpdoDoesNotRestartTheEventTimer) {
    verifies<req::CO_PDO_033, req::CO_PDO_034, req::CO_PDO_021>();
    send("605#2F29100101000000");                // 1029h:1 (error behaviour) = 1: no change of state
    map_rpdo3({"10000022"});                     // maps 2200h, which accepts -100 … 100
    send("605#2B02140532000000");                // 1402h:5 event timer of RPDO3: 50 ms
    EXPECT_TRUE(send("405#6500").size() == 1U);  // the value 101 is refused with error 8200h
    EXPECT_TRUE(pass(1000).empty());             // no valid RPDO3 has started the monitoring
    EXPECT_EQ(send("405#6400"), (Frames{"085#0000000100000000"}));
    EXPECT_TRUE(pass(40).empty());
    EXPECT_EQ(send("405#6500"), (Frames{"085#0082110200000000"}));
    // 50 ms after the last accepted RPDO3: time-out, error 8250h
    EXPECT_EQ(pass(60), (Frames{"10:085#5082110300000000"}));
    EXPECT_TRUE(send("405#9BFF").empty());  // -101 is refused, so the RPDO stays overdue
    EXPECT_EQ(send("605#4001100000000000"), (Frames{"585#4F01100011000000"}));
    // 99 is accepted: both errors end
    EXPECT_EQ(send("405#6300"), (Frames{"085#0000110300000000", "085#0000000300000000"}));
    EXPECT_EQ(send("605#4001100000000000"), (Frames{"585#4F01100000000000"}));
}

TEST_F(Rpdo, RefusedRpdoDoesNotReplaceOneThatWaitsForTheSync) {
    verifies<req::CO_PDO_034, req::CO_PDO_002, req::CO_PDO_065>();
    map_rpdo3({"10000022"});
    talk(*this, {
                    {"605#2F02140201000000", {"585#6002140200000000"}},  // 1402h:2 transmission type of RPDO3: 1
                    {"405#3200", {}},                                    // the value 50 waits for a SYNC
                    {"405#6500", {"085#0082110100000000"}},              // 101: reported on reception
                    {"605#4000220000000000", {"585#4B00220007000000"}},  // 2200h still has its default
                    {"080#", {}},
                    {"605#4000220000000000", {"585#4B00220032000000"}},
                    // 1001h (error register) still shows the error, because the latest RPDO3 was refused
                    {"605#4001100000000000", {"585#4F01100011000000"}},
                    {"405#3300", {"085#0000000100000000"}},
                    {"080#", {}},
                    {"605#4000220000000000", {"585#4B00220033000000"}},
                });
}

TEST_F(Rpdo, ValueErrorLastsWhileAnyRpdoIsRefused) {
    verifies<req::CO_PDO_034, req::CO_PDO_038>();
    map_rpdo3({"10000022"});
    talk(*this, {
                    {"605#2303140105050080", {"585#6003140100000000"}},  // RPDO4 on 505h maps 2202h
                    {"605#2303160120000222", {"585#6003160100000000"}},
                    {"605#2F03160001000000", {"585#6003160000000000"}},
                    {"605#2303140105050000", {"585#6003140100000000"}},
                    {"405#6500", {"085#0082110100000000"}},
                    {"505#0000807F", {}},  // 2202h = infinity: refused
                    // RPDO3 is accepted, but the error lasts, because the latest RPDO4 was refused
                    {"405#6400", {}},
                    {"505#0000", {"085#1082110200000000"}},  // RPDO4 is too short: an additional error
                    {"505#00000000", {"085#0000110200000000", "085#0000000200000000"}},
                    {"405#6500", {"085#0082110300000000"}},
                    // A write to 1402h:2 also ends the error of RPDO3.
                    {"605#2F021402FE000000", {"085#0000000300000000", "585#6002140200000000"}},
                });
    EXPECT_EQ(device->node().state(), NmtState::operational);  // a refused RPDO is no communication error of 1029h:1
}

// The minimum of 2200h is -100, its maximum is the value of 2100h:1. This value changes between the reception of the
// RPDO and the SYNC.
TEST_F(MovingLimit, WaitingRpdoIsRefusedAtTheSyncWhenALimitHasChanged) {
    verifies<req::CO_PDO_034>();
    limit(0x2200, 0, {{LimitKind::value, 0xFF9C, 0}, {LimitKind::entry, 0x210001, 0}});
    ship(0x2100, 1, 100);
    power_on();
    talk(*this, {
                    {"605#2300180185010080", {"585#6000180100000000"}},  // TPDO1 and TPDO2 are not valid
                    {"605#2301180185020080", {"585#6001180100000000"}},
                    {"605#2F02160000000000", {"585#6002160000000000"}},
                    {"605#2302160110000022", {"585#6002160100000000"}},
                    {"605#2F02160001000000", {"585#6002160000000000"}},
                    {"605#2F02140201000000", {"585#6002140200000000"}},  // 1402h:2 type 1: applied at the next SYNC
                    {"605#2302140105040000", {"585#6002140100000000"}},
                    {"000#0105", {}},
                    {"405#3200", {}},  // the value 50 waits for a SYNC
                    // 2100h:1 = 40: the waiting value 50 is now above the maximum
                    {"605#2B00210128000000", {"585#6000210100000000"}},
                    {"080#", {"085#0082110100000000"}},
                    {"605#4000220000000000", {"585#4B00220007000000"}},  // 2200h still has its default
                    // has no effect: the refused RPDO does not wait any more
                    {"080#", {}},
                    {"405#2800", {"085#0000000100000000"}},  // the value 40 is accepted
                    {"080#", {}},
                    {"605#4000220000000000", {"585#4B00220028000000"}},
                });
}

}  // namespace canproof::test
