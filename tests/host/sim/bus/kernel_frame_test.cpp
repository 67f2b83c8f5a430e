// SPDX-License-Identifier: Apache-2.0
// Frames, filters and error frames in the structures of the kernel (linux/can.h, linux/can/error.h).
#include "host/sim/bus/kernel_frame.hpp"

#include <gtest/gtest.h>
#include <linux/can/error.h>

#include "host/sim/bus/candump.hpp"

namespace canproof::host::test {

TEST(KernelFrame, KernelFrameHasIdentifierFlagsLengthAndBytes) {
    const can_frame base = to_kernel(parse_frame("703#0102", "test"));
    EXPECT_EQ(base.can_id, 0x703U);
    EXPECT_EQ(base.can_dlc, 2U);
    EXPECT_EQ(base.data[0], 1U);
    EXPECT_EQ(base.data[1], 2U);
    EXPECT_EQ(base.data[2], 0U);
    const can_frame extended = to_kernel(parse_frame("00000703#R3", "test"));
    EXPECT_EQ(extended.can_id, 0x80000000U | 0x40000000U | 0x703U);
    EXPECT_EQ(extended.can_dlc, 3U);
}

TEST(KernelFrame, RemoteFrameIsConvertedWithoutBytes) {
    Frame request = parse_frame("703#R2", "test");
    request.data[0] = 0xAA;
    EXPECT_EQ(to_kernel(request).data[0], 0U);
    can_frame from_others{};
    from_others.can_id = 0x703U | CAN_RTR_FLAG;
    from_others.can_dlc = 2;
    from_others.data[0] = 0xAA;
    EXPECT_EQ(from_kernel(from_others).data[0], 0U);
    EXPECT_EQ(from_kernel(from_others).length, 2U);
}

TEST(KernelFrame, LengthAboveEightIsReadAsEight) {
    can_frame odd{};
    odd.can_id = 0x123;
    odd.can_dlc = 15;
    odd.data[7] = 9;
    EXPECT_EQ(from_kernel(odd).length, 8U);
    EXPECT_EQ(from_kernel(odd).data[7], 9U);
}

TEST(KernelFrame, IdentifierHasTheBitsOfItsFormat) {
    can_frame frame{};
    frame.can_id = 0x1FFFFFFFU;  // without CAN_EFF_FLAG, only eleven bits count
    EXPECT_EQ(from_kernel(frame).id, 0x7FFU);
    EXPECT_FALSE(from_kernel(frame).extended);
    frame.can_id |= CAN_EFF_FLAG;
    EXPECT_EQ(from_kernel(frame).id, 0x1FFFFFFFU);
    EXPECT_TRUE(from_kernel(frame).extended);
}

TEST(KernelFrame, ErrorFrameIsIdentifiedByItsFlag) {
    can_frame frame{};
    frame.can_id = CAN_ERR_BUSOFF;  // the same value without the flag is an identifier
    EXPECT_FALSE(is_error_frame(frame));
    frame.can_id |= CAN_ERR_FLAG;
    EXPECT_TRUE(is_error_frame(frame));
}

TEST(KernelFilter, KernelFilterComparesIdentifierAndFrameFormat) {
    const auto filters = kernel_filters({{0x122, 0x7FF, false}, {0x123, 0x1FFFFFFF, true}});
    ASSERT_EQ(filters.size(), 2U);
    EXPECT_EQ(filters[0].can_id, 0x122U);
    EXPECT_EQ(filters[0].can_mask, 0x7FFU | CAN_EFF_FLAG);
    EXPECT_EQ(filters[1].can_id, 0x123U | CAN_EFF_FLAG);
    EXPECT_EQ(filters[1].can_mask, 0x1FFFFFFFU | CAN_EFF_FLAG);
}

TEST(KernelErrorFrame, MostSevereControllerStateIsReported) {
    const auto state_of = [](std::uint32_t error_class, std::uint8_t controller) {
        can_frame frame{};
        frame.can_id = CAN_ERR_FLAG | error_class;
        frame.data[1] = controller;
        return read_error_frame(frame).state;
    };
    EXPECT_EQ(state_of(CAN_ERR_CRTL, 0x04 | 0x10), CanState::error_passive);  // error passive is worse than warning
    EXPECT_EQ(state_of(CAN_ERR_CRTL, 0x04 | 0x40), CanState::warning);        // warning is worse than active
    EXPECT_EQ(state_of(CAN_ERR_CRTL | CAN_ERR_BUSOFF, 0x10), CanState::bus_off);
    EXPECT_EQ(state_of(CAN_ERR_RESTARTED | CAN_ERR_BUSOFF, 0), CanState::bus_off);
    EXPECT_EQ(state_of(CAN_ERR_CRTL, 0), std::nullopt);
    EXPECT_EQ(state_of(CAN_ERR_PROT, 0x10), std::nullopt);  // byte 1 belongs to the controller class only
}

TEST(KernelErrorFrame, OverrunNeedsTheControllerErrorClass) {
    can_frame frame{};
    frame.can_id = CAN_ERR_FLAG | CAN_ERR_PROT;
    frame.data[1] = 0x03;
    EXPECT_FALSE(read_error_frame(frame).overrun);
    frame.can_id = CAN_ERR_FLAG | CAN_ERR_CRTL;
    frame.data[1] = 0x11;  // overrun and error passive in one frame
    EXPECT_TRUE(read_error_frame(frame).overrun);
    EXPECT_EQ(read_error_frame(frame).state, CanState::error_passive);
}

}  // namespace canproof::host::test
