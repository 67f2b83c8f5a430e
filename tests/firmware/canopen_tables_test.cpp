// SPDX-License-Identifier: Apache-2.0
// Compares decision tables of CiA 301 and CiA 305 field by field.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "firmware/canopen/object_dictionary.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/enumerations.hpp"
#include "generated/canopen/requirements.hpp"
#include "generated/canopen/tables.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

namespace own = generated::canopen;

}  // namespace

// CiA 301, 7.3.5
TEST(CanopenTables, RestrictedIdentifiersFollowCiA301) {
    verifies<req::CO_T_RESTRICTED_COB_ID>();
    namespace t = own::restricted_cob_id;
    for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
        const bool restricted = id <= 0x7F || (0x101 <= id && id <= 0x180) || (0x581 <= id && id <= 0x5FF) ||
                                (0x601 <= id && id <= 0x67F) || (0x6E0 <= id && id <= 0x6FF) || 0x701 <= id;
        const auto* row = t::find(id);
        ASSERT_NE(row, nullptr) << id;
        EXPECT_EQ(row->restricted, restricted) << id;
    }
    EXPECT_EQ(t::find(0x800), nullptr);
}

// CiA 301, 7.4.1: communication objects from 1000h, manufacturer objects from 2000h, device profile objects from 6000h
TEST(CanopenTables, DictionaryAreasFollowCiA301) {
    verifies<req::CO_NMT_006>();
    EXPECT_EQ(parameter_group(0x1000), ParameterGroup::communication);
    EXPECT_EQ(parameter_group(0x1FFF), ParameterGroup::communication);
    EXPECT_EQ(parameter_group(0x2000), ParameterGroup::manufacturer);
    EXPECT_EQ(parameter_group(0x5FFF), ParameterGroup::manufacturer);
    EXPECT_EQ(parameter_group(0x6000), ParameterGroup::application);
    EXPECT_EQ(parameter_group(0x9FFF), ParameterGroup::application);
}

// CiA 301, 7.3.2.3: PDO, SDO, SYNC and EMCY do not work before boot-up and in stopped; PDO works in operational only.
TEST(CanopenTables, ServicesByStateFollowCiA301) {
    verifies<req::CO_T_SERVICES>();
    namespace t = own::nmt_services;
    using State = own::NmtState;
    for (const auto service : {t::Service::pdo, t::Service::sdo, t::Service::sync, t::Service::emcy}) {
        for (const State state : {State::initialising, State::stopped, State::operational, State::pre_operational}) {
            const auto* row = t::find(service, state);
            ASSERT_NE(row, nullptr);
            EXPECT_EQ(row->allowed,
                      state == State::operational || (state == State::pre_operational && service != t::Service::pdo));
        }
    }
    EXPECT_EQ(t::rows.size(), 4U * 4U);
}

// CiA 301, 7.5.2.35 and 7.5.2.37
TEST(CanopenTables, TransmissionTypesFollowCiA301) {
    verifies<req::CO_T_TRANSMISSION_TYPE>();
    namespace t = own::transmission_type;
    for (std::uint32_t type = 0; type <= 255; ++type) {
        const t::Applied applied = type <= 240   ? t::Applied::at_sync
                                   : type <= 253 ? t::Applied::refused
                                                 : t::Applied::at_once;
        const t::Sent sent = type == 0     ? t::Sent::at_sync_after_event
                             : type <= 240 ? t::Sent::each_nth_sync
                             : type <= 251 ? t::Sent::refused
                             : type == 252 ? t::Sent::sync_sample_on_request
                             : type == 253 ? t::Sent::on_request
                                           : t::Sent::on_event;
        const auto* row = t::find(type);
        ASSERT_NE(row, nullptr) << type;
        EXPECT_EQ(row->applied, applied) << type;
        EXPECT_EQ(row->sent, sent) << type;
        EXPECT_EQ(std::count_if(t::rows.begin(), t::rows.end(),
                                [&](const t::Row& one) { return one.type_first <= type && type <= one.type_last; }),
                  1)
            << type;
    }
}

// CiA 305, 6.7.4: an LSS Fastscan request has seven bytes after its command; the slave's answer is only the command 4Fh
TEST(CanopenTables, LengthsOfFastscanRequestAndAnswerFollowCiA305) {
    verifies<req::CO_T_LSS>();
    const auto* row = own::lss_requests::find(own::LssCommand::fastscan);
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->parameters, 7);
    EXPECT_EQ(row->answer_length, 1);
}

// CiA 301, 7.3.3
TEST(CanopenTables, GuardingIdentifiersBeginAt700h) {
    verifies<req::CO_K_GUARDING_ID>();
    EXPECT_EQ(own::guarding_cob_id_base, 0x700U);
}

}  // namespace canproof::test
