// SPDX-License-Identifier: Apache-2.0
// Tests that a relay of the AX130751 goes OFF without its delay when an input has a source without a value
// (manual, 1.4).
#include "generated/ax130751/requirements.hpp"
#include "tests/devices/ax130751/ax130751_blocks.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax130751RelayInterlock : public Ax130751Blocks {
  protected:
    void choose(std::uint16_t source_index, int source, int number) {
        set8(source_index, 1, source);
        set8(static_cast<std::uint16_t>(source_index + 1), 1, number);
        pass(1);
    }
};

}  // namespace

TEST_F(Ax130751RelayInterlock, RelayDoesNotWaitForItsOffDelayWhenItsOverrideOrUnlatchSourceHasNoValue) {
    verifies<req::AOR_RELAY_018, req::AOR_RELAY_028>();
    set8(0x2293, 1, 1);  // override state ON
    set32(0x22A1, 1, 0);
    set32(0x22A2, 1, 1000);  // OFF delay: 1 s
    set8(0x22A0, 1, 1);
    for (const Choice& choice : without_value) {
        SCOPED_TRACE(fmt::format("source {}, number {}", choice.source, choice.number));
        set8(0x6220, 3, 1);
        pass(1);
        EXPECT_TRUE(relay_on());
        choose(0x2290, choice.source, choice.number);
        EXPECT_FALSE(relay_on()) << "override";
        set8(0x2290, 1, not_used);
        for (const int logic : {3, 4}) {  // latched logic, inverse latched logic
            set8(0x2242, 1, 1);
            pass(1);
            EXPECT_TRUE(relay_on());
            set8(0x2242, 1, logic);
            pass(1);
            EXPECT_TRUE(relay_on()) << "logic " << logic;
            choose(0x2270, choice.source, choice.number);
            EXPECT_FALSE(relay_on()) << "unlatch, logic " << logic;
            set8(0x2270, 1, not_used);
        }
        set8(0x2242, 1, 1);
    }
}

}  // namespace canproof::test
