// SPDX-License-Identifier: Apache-2.0
// Compares the decision tables of the CAN-CBX-AO412 manual field by field, and the constants of its outputs.
#include "generated/cbx_ao412/tables.hpp"

#include <gtest/gtest.h>

#include <array>

#include "generated/cbx_ao412/constants.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

namespace own = generated::cbx_ao412;
using State = own::IndicatorState;

}  // namespace

// Section 7.9.4: every error except those of software and hardware sets bit 4 (communication) of the error register in
// addition to bit 0. Error 8140h (bus-off) is over when it is reported.
TEST(CbxTables, ErrorTableFollowsTheManual) {
    verifies<req::AO4_T_ERRORS>();
    namespace t = own::error_codes;
    struct Error {
        ErrorId error;
        int code;
        int bits;
        bool sent;
    };
    for (const Error& one : {Error{ErrorId::can_overrun, 0x8110, 0x11, true},
                             {ErrorId::error_passive, 0x8120, 0x11, true},
                             {ErrorId::guard_or_heartbeat, 0x8130, 0x11, true},
                             {ErrorId::bus_off_recovered, 0x8140, 0x00, true},
                             {ErrorId::sync_length, 0x8240, 0x11, true},
                             {ErrorId::stored_set_checksum, 0x6000, 0x01, false},
                             {ErrorId::internal_software, 0x6110, 0x01, true},
                             {own::error::hardware, 0x5000, 0x01, true}}) {
        const auto* row = t::find(one.error);
        ASSERT_NE(row, nullptr) << one.code;
        EXPECT_EQ(row->code, one.code);
        EXPECT_EQ(row->register_bits, one.bits) << one.code;
        EXPECT_EQ(row->sent, one.sent) << one.code;
        EXPECT_TRUE(row->listed) << one.code;
    }
    EXPECT_EQ(t::rows.size(), 8U);
}

// Section 3.2.1, Table 5: blinking at 2.5 Hz is 200 ms on and 200 ms off, at 10 Hz 50 ms on and 50 ms off. In patterns
// of n flashes, the pause follows the last flash.
TEST(CbxTables, IndicatorStatesFollowTheManual) {
    verifies<req::AO4_T5, req::AO4_E_INDICATOR>();
    namespace t = own::indicator_flashes;
    struct Indicator {
        State state;
        int flashes;
        int on;
        int gap;
        int pause;
    };
    for (const Indicator& one : {Indicator{State::off, 0, 0, 0, 0},
                                 {State::on, 0, 1, 0, 0},
                                 {State::blinking, 1, 200, 200, 200},
                                 {State::flickering, 1, 50, 50, 50},
                                 {State::flash1, 1, 200, 200, 1400},
                                 {State::flash2, 2, 200, 200, 1000},
                                 {State::flash3, 3, 200, 200, 1000},
                                 {State::flash4, 4, 200, 200, 1000}}) {
        const auto* row = t::find(one.state);
        ASSERT_NE(row, nullptr);
        const std::array<int, 4> times{row->flashes, row->on_ms, row->gap_ms, row->pause_ms};
        EXPECT_EQ(times, (std::array<int, 4>{one.flashes, one.on, one.gap, one.pause})) << static_cast<int>(one.state);
    }
}

// Section 3.2.2, Table 6, and section 3.2.6: an invalid node-ID or bus-off has priority over a guarding error, and a
// guarding error over the warnings of the controller.
TEST(CbxTables, CanErrorLedTableFollowsTheManual) {
    verifies<req::AO4_T6>();
    namespace t = own::can_error_led;
    const auto led = [](bool invalid, t::Can can, bool guard) {
        const auto* row = t::find(invalid, can, guard);
        return row == nullptr ? State::flickering : row->led;
    };
    for (const auto can : {t::Can::error_active, t::Can::warning, t::Can::error_passive, t::Can::bus_off}) {
        for (const bool guard : {false, true}) {
            EXPECT_EQ(led(true, can, guard), State::on);
        }
    }
    for (const bool guard : {false, true}) {
        EXPECT_EQ(led(false, t::Can::bus_off, guard), State::on);
    }
    for (const auto can : {t::Can::error_active, t::Can::warning, t::Can::error_passive}) {
        EXPECT_EQ(led(false, can, true), State::flash2);
    }
    EXPECT_EQ(led(false, t::Can::warning, false), State::flash1);
    EXPECT_EQ(led(false, t::Can::error_passive, false), State::flash1);
    EXPECT_EQ(led(false, t::Can::error_active, false), State::off);
}

// CAN-CBX-AO412 manual, section 3.2.3 (Table 7) and section 3.2.6. While the boot loader runs or the node-ID is
// invalid, the application does not run. In initialising the LED shows the pattern of pre-operational (AO4-D-156).
TEST(CbxTables, StatusLedTableFollowsTheManual) {
    verifies<req::AO4_T7>();
    namespace t = own::status_led;
    for (const auto& [state, led] :
         std::array<std::pair<t::State, State>, 4>{{{t::State::initialising, State::blinking},
                                                    {t::State::pre_operational, State::blinking},
                                                    {t::State::operational, State::on},
                                                    {t::State::stopped, State::flash1}}}) {
        ASSERT_NE(t::find(true, state), nullptr);
        EXPECT_EQ(t::find(true, state)->led, led) << static_cast<int>(state);
        ASSERT_NE(t::find(false, state), nullptr);
        EXPECT_EQ(t::find(false, state)->led, State::flash3) << static_cast<int>(state);
    }
}

// CAN-CBX-AO412 manual, section 3.2.4 (Table 8) and section 3.2.5 (Table 9)
TEST(CbxTables, ModuleErrorAndPowerLedTablesFollowTheManual) {
    verifies<req::AO4_T8, req::AO4_T9>();
    namespace m = own::error_led;
    for (const bool overrun : {false, true}) {
        ASSERT_NE(m::find(overrun, true), nullptr);
        EXPECT_EQ(m::find(overrun, true)->led, State::flash2);
        ASSERT_NE(m::find(overrun, false), nullptr);
        EXPECT_EQ(m::find(overrun, false)->led, overrun ? State::on : State::off);
    }
    namespace p = own::power_led;
    for (const bool runs : {false, true}) {
        ASSERT_NE(p::find(runs), nullptr);
        EXPECT_EQ(p::find(runs)->led, runs ? State::on : State::off);
    }
}

// CAN-CBX-AO412 manual, section 7.10.3
TEST(CbxTables, ErrorModesFollowTheManual) {
    verifies<req::AO4_T_ERROR_MODE>();
    namespace t = own::error_mode;
    const std::array<t::Action, 3> actions{t::Action::zero, t::Action::error_value, t::Action::keep};
    for (std::uint32_t mode = 0; mode < 3; ++mode) {
        ASSERT_NE(t::find(mode), nullptr);
        EXPECT_EQ(t::find(mode)->action, actions[mode]);
    }
    EXPECT_EQ(t::find(3), nullptr);
}

// Section 2.4: the converter has 12 bits. Section 7.11.2: an offset of 8000h means 10.24 V. Section 7.11.3: the gain is
// divided by 2 to the 18th.
TEST(CbxTables, ConstantsFollowTheManual) {
    verifies<req::AO4_K_DAC_STEPS, req::AO4_K_OFFSET_SCALE, req::AO4_K_GAIN_DIVISOR>();
    EXPECT_EQ(own::dac_steps, 1 << 12);
    EXPECT_EQ(own::calibration_offset_full_scale, 10.24F);
    EXPECT_EQ(own::calibration_gain_divisor, 1 << 18);
}

}  // namespace canproof::test
