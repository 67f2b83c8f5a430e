// SPDX-License-Identifier: Apache-2.0
// The exact writes of the Zynq UltraScale+'s CAN driver to the registers of the controller, with values that are
// written out from UG1087.
#include <gmock/gmock.h>

#include <algorithm>

#include "generated/canopen/requirements.hpp"
#include "target/zynqmp/can.hpp"
#include "tests/support/stm32f405/chip_model.hpp"
#include "tests/support/verifies.hpp"
#include "tests/support/zynqmp/zynq_can_model.hpp"

namespace canproof::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

}  // namespace

// UG1087, module CAN1 at FF070000h. SRR: SRST (0). AFR = 0 ends the use of the filters before they are written. At 24
// MHz, 500 kbit/s are 48 clocks: 16 quanta of 3 clocks, 13 before and 2 after the sample point, a jump width of 2. BRPR
// = 3 - 1; BTR: TS1 = 12 from bit 0, TS2 = 1 from bit 4, SJW = 1 from bit 7. AFMR1: IDE (19) is compared with AFIR1 =
// 0, then AFR: UAF1 (0). MSR = 0, the normal mode. SRR: CEN (1), last, because it ends the configuration mode.
TEST(ZynqWrites, JoiningWritesTheRegistersOfTheRegisterReference) {
    verifies<req::CO_ZCAN_001, req::CO_ZCAN_006>();
    constexpr std::uintptr_t can1 = 0xFF070000;
    ZynqCanModel model;
    Window at_can{can1, model.registers()};
    AccessLog log;
    zynqmp::Can can{stm32f405::registers_at<zynqmp::CanRegisters>(can1), 24000000};
    TransmitQueue queue;
    can.set_bit_rate(500000, Instant{});
    for (std::uint64_t us = 1000; us <= 4000; us += 1000) {
        can.advance(queue, Instant{us});
    }
    EXPECT_TRUE(can.is_on_bus());
    auto writes = log.take_writes();
    ASSERT_EQ(writes.size(), 9U);
    const auto by_address = [](const Write& a, const Write& b) { return a.address < b.address; };
    std::sort(writes.begin() + 2, writes.begin() + 6, by_address);  // the hardware permits any order of these
    std::sort(writes.begin() + 6, writes.begin() + 8, by_address);  // and of these
    EXPECT_THAT(writes,
                ElementsAre(Write{can1, 1U}, Write{can1 + 0x60, 0U}, Write{can1 + 0x08, 2U},
                            Write{can1 + 0x0C, 1U << 7U | 1U << 4U | 12U}, Write{can1 + 0x64, 1U << 19U},
                            Write{can1 + 0x68, 0U}, Write{can1 + 0x04, 0U}, Write{can1 + 0x60, 1U}, Write{can1, 2U}));
    EXPECT_THAT(model.faults(), IsEmpty());
}

}  // namespace canproof::test
