// SPDX-License-Identifier: Apache-2.0
// Tests remote frames on the identifiers of RPDOs. In these tests the slave answers remote frames on RPDO2, which maps
// the four values of 2100h. It ignores remote frames on RPDO1.
#include <gtest/gtest.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

class RemoteRpdo : public testing::Test, public AlteredSlaveBench {
  protected:
    void SetUp() override {
        description.profile.rpdos_answering_remote = 0x02;  // bit 1: RPDO2
        power_on();
        talk(*this, {
                        {"605#2300180185010080", {"585#6000180100000000"}},  // 1800h:1 TPDO1 COB-ID, bit 31 (not valid)
                        {"605#2301180185020080", {"585#6001180100000000"}},
                        {"605#2B00210134120000", {"585#6000210100000000"}},  // 2100h:1 to 2100h:4
                        {"605#2B00210278560000", {"585#6000210200000000"}},
                        {"605#2B00210301000000", {"585#6000210300000000"}},
                        {"605#2B00210402000000", {"585#6000210400000000"}},
                        {"000#0105", {}},
                    });
    }
};

TEST_F(RemoteRpdo, RpdoThatAnswersRemoteFramesSendsTheValuesOfItsObjects) {
    verifies<req::CO_PDO_062>();
    talk(*this, {{"305#R8", {"305#3412785601000200"}}});
}

TEST_F(RemoteRpdo, RpdoThatAnswersRemoteFramesSendsTheValuesInTheOrderOfItsMapping) {
    verifies<req::CO_PDO_062>();
    talk(*this, {
                    {"605#2301140105030080", {"585#6001140100000000"}},  // 1401h:1, not valid
                    {"605#2F01160000000000", {"585#6001160000000000"}},
                    {"605#2301160110030021", {"585#6001160100000000"}},  // 1601h maps 2100h:3, then 2100h:1
                    {"605#2301160210010021", {"585#6001160200000000"}},
                    {"605#2F01160002000000", {"585#6001160000000000"}},
                    {"605#2301140105030000", {"585#6001140100000000"}},
                    {"305#R4", {"305#01003412"}},  // 2100h:3 = 0001h, 2100h:1 = 1234h
                });
}

TEST_F(RemoteRpdo, RpdoThatAnswersRemoteFramesIsSilentOutsideOperational) {
    verifies<req::CO_PDO_062>();
    for (const char* state : {"000#8005", "000#0205"}) {  // pre-operational, stopped
        talk(*this, {{state, {}}, {"305#R8", {}}});
    }
    talk(*this, {{"000#0105", {}}, {"305#R8", {"305#3412785601000200"}}});
}

TEST_F(RemoteRpdo, RpdoThatAnswersRemoteFramesIsSilentWhileBit30OfItsCobIdIsSet) {
    verifies<req::CO_PDO_062>();
    talk(*this, {
                    {"605#2301140105030080", {"585#6001140100000000"}},  // 1401h:1, not valid
                    {"305#R8", {}},
                    {"605#2301140105030040", {"585#6001140100000000"}},  // 1401h:1, valid, no remote frames (bit 30)
                    {"305#R8", {}},
                    {"605#2301140105030080", {"585#6001140100000000"}},
                    {"605#2301140105030000", {"585#6001140100000000"}},
                    {"305#R8", {"305#3412785601000200"}},
                });
}

TEST_F(RemoteRpdo, RpdoNotConfiguredToAnswerIgnoresRemoteFrames) {
    verifies<req::CO_PDO_063>();
    talk(*this, {{"205#R8", {}}, {"205#R2", {}}});
}

}  // namespace canproof::test
