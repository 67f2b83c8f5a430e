// SPDX-License-Identifier: Apache-2.0
// Tests a slave that accepts 1010h (store parameters) only in pre-operational.
#include <gtest/gtest.h>

#include "generated/canopen/requirements.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

class StoreInPreOperational : public testing::Test, public AlteredSlaveBench {
  protected:
    void SetUp() override {
        description.profile.saves_in_pre_operational_only = true;
        power_on();
        talk(*this, {
                        {"605#2300180185010080", {"585#6000180100000000"}},  // 1800h:1 TPDO1 COB-ID, bit 31 (not valid)
                        {"605#2301180185020080", {"585#6001180100000000"}},
                        {"605#2B00210134120000", {"585#6000210100000000"}},  // 2100h:1
                    });
    }
};

TEST_F(StoreInPreOperational, SaveInOperationalIsRefusedAndStoresNothing) {
    verifies<req::CO_STORE_015>();
    talk(*this, {
                    {"000#0105", {}},
                    {"605#2310100173617665", {"585#8010100122000008"}},
                });
    power_on();
    talk(*this, {{"605#4000210100000000", {"585#4B00210100000000"}}});
}

TEST_F(StoreInPreOperational, RestoreInOperationalIsAccepted) {
    verifies<req::CO_STORE_015>();
    talk(*this, {
                    {"000#0105", {}},
                    {"605#231110016C6F6164", {"585#6011100100000000"}},
                });
}

TEST_F(StoreInPreOperational, SaveInPreOperationalIsKept) {
    verifies<req::CO_STORE_015>();
    talk(*this, {{"605#2310100173617665", {"585#6010100100000000"}}});
    power_on();
    talk(*this, {{"605#4000210100000000", {"585#4B00210134120000"}}});
}

}  // namespace canproof::test
