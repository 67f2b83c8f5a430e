// SPDX-License-Identifier: Apache-2.0
// Compares the decision tables of the AX188001 manual field by field.
#include "generated/ax188001/tables.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "generated/ax188001/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

namespace own = generated::ax188001;

}  // namespace

// Section 3.3.6, Table 7: open circuit has priority over shutdown, shutdown over a high warning, a high warning over a
// low warning.
TEST(Ax188001Tables, ChannelStatusTableFollowsTheManual) {
    verifies<req::TCS_T7>();
    namespace t = own::channel_status;
    for (int told = 0; told < 16; ++told) {
        const bool open = (told & 1) != 0;
        const bool shutdown = (told & 2) != 0;
        const bool high = (told & 4) != 0;
        const bool low = (told & 8) != 0;
        const int status = open ? 5 : shutdown ? 3 : high ? 2 : low ? 4 : 0;
        const auto* row = t::find(open, shutdown, high, low);
        ASSERT_NE(row, nullptr) << told;
        EXPECT_EQ(row->status, status) << told;
    }
    EXPECT_EQ(t::rows.size(), 16U);
}

// AX188001, 1.4 Table 3
TEST(Ax188001Tables, StartModeTableFollowsTheManual) {
    verifies<req::TCS_T3>();
    namespace t = own::start_mode;
    for (std::uint32_t option = 0; option < 3; ++option) {
        ASSERT_NE(t::find(option), nullptr);
        EXPECT_EQ(t::find(option)->start, option != 0) << option;
        EXPECT_EQ(t::find(option)->others, option == 2) << option;
    }
    EXPECT_EQ(t::find(3), nullptr);
}

// AX188001, 3.2.13
TEST(Ax188001Tables, ErrorBehaviourTableFollowsTheManual) {
    verifies<req::TCS_T_BEHAVIOUR>();
    namespace t = own::error_behaviour;
    const std::array<t::Action, 3> actions{t::Action::pre_operational, t::Action::no_change, t::Action::stopped};
    for (std::uint32_t value = 0; value < 3; ++value) {
        ASSERT_NE(t::find(value), nullptr);
        EXPECT_EQ(t::find(value)->action, actions[value]);
    }
    EXPECT_EQ(t::find(3), nullptr);
}

// Section 3.2.4, Tables 5 and 6: the error code is 8100h (communication), without channel and description.
TEST(Ax188001Tables, OverdueRpdoHasTheErrorCodeOfTheManual) {
    verifies<req::TCS_T5>();
    const auto* row = own::error_codes::find(ErrorId::rpdo_timeout);
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(static_cast<int>(row->code), 0x8100);
    EXPECT_EQ(static_cast<int>(row->description), 0);
    EXPECT_EQ(row->channel, 0);
}

// Section 3.2.4: 1003h (error list) has the active errors. A bus-off is over when it is reported, so it is not listed.
TEST(Ax188001Tables, EveryErrorExceptTheEndOfBusOffEntersTheErrorList) {
    verifies<req::TCS_T5>();
    EXPECT_EQ(own::error_codes::rows.size(), 17U);
    for (const auto& row : own::error_codes::rows) {
        EXPECT_EQ(row.listed, row.error != ErrorId::bus_off_recovered) << static_cast<int>(row.error);
    }
}

// Appendix A: hum at the frequency of the filter is damped by 110 dB, that is to 10^(-110/20). For hum of the other
// mains frequency, the values are those of the converter.
TEST(Ax188001Tables, MainsHumRejectionTableFollowsTheManual) {
    verifies<req::TCS_T_REJECTION>();
    namespace t = own::hum_rejection;
    const auto left = [](t::FilterHz filter, t::MainsHz mains) {
        const auto* row = t::find(filter, mains);
        return row == nullptr ? -1.0F : row->left;
    };
    EXPECT_EQ(left(t::FilterHz::hz_50, t::MainsHz::hz_50), 3.1623e-6F);
    EXPECT_EQ(left(t::FilterHz::hz_60, t::MainsHz::hz_60), 3.1623e-6F);
    EXPECT_EQ(left(t::FilterHz::hz_50, t::MainsHz::hz_60), 5.9e-4F);
    EXPECT_EQ(left(t::FilterHz::hz_60, t::MainsHz::hz_50), 1.33e-3F);
    EXPECT_EQ(left(t::FilterHz::hz_50, t::MainsHz::none), 0.0F);
    EXPECT_EQ(left(t::FilterHz::hz_60, t::MainsHz::none), 0.0F);
}

// Section 1.1: harmonics are also rejected. A sinc filter of fourth order passes the share (sin(pi x) / (pi x))^4 of
// hum whose frequency is x times that of the filter.
TEST(Ax188001Tables, MainsHarmonicsAreRejectedAtLeastAsMuchAsTheirFundamental) {
    verifies<req::TCS_T_REJECTION>();
    namespace t = own::hum_rejection;
    const auto passes = [](double x) {
        constexpr double pi = 3.14159265358979323846;
        return std::pow(std::sin(pi * x) / (pi * x), 4.0);
    };
    for (const double filter : {50.0, 60.0}) {
        for (const double mains : {50.0, 60.0}) {
            const auto* row = t::find(filter == 50.0 ? t::FilterHz::hz_50 : t::FilterHz::hz_60,
                                      mains == 50.0 ? t::MainsHz::hz_50 : t::MainsHz::hz_60);
            ASSERT_NE(row, nullptr);
            for (int harmonic = 2; harmonic <= 50; ++harmonic) {
                EXPECT_LT(passes(harmonic * mains / filter), row->left) << filter << ' ' << harmonic * mains;
            }
        }
    }
}

}  // namespace canproof::test
