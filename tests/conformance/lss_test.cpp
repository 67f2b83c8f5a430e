// SPDX-License-Identifier: Apache-2.0
// Tests the LSS states of a slave and the frames that change them (CiA 305).
#include "generated/canopen/requirements.hpp"
#include "tests/conformance/lss_cases.hpp"
#include "tests/devices/cbx-ao412/bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

// -- states -----------------------------------------------------------------------------------------------------------

// CiA 305, 6.3.2
TEST_F(Lss, SwitchStateGlobalLeadsToLssConfigurationAndBackToLssWaiting) {
    verifies<req::CO_LSS_001, req::CO_LSS_067, req::CO_E_LSS_STATE, req::CO_E_LSS_COMMAND, req::CO_K_LSS_REQUEST_ID,
             req::CO_K_LSS_RESPONSE_ID, req::CO_LSS_082>();
    talk({{"7E5#5E00000000000000", {}},  // after power-on, in LSS waiting: the inquiry is not answered
          {"7E5#0401000000000000", {}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#0401000000000000", {}},  // configuration mode again: nothing changes
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#0402000000000000", {}},  // mode 2 does not exist
          {"7E5#04FF000000000000", {}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#0400000000000000", {}},
          {"7E5#5E00000000000000", {}},
          {"7E5#0402000000000000", {}},
          {"7E5#0481000000000000", {}},
          {"7E5#5E00000000000000", {}}});
}

// CiA 305, 6.3.3
TEST_F(Lss, SwitchStateSelectiveSelectsTheSlaveByItsFourNumbers) {
    verifies<req::CO_LSS_002, req::CO_E_LSS_ANSWER, req::CO_E_LSS_COMMAND>();
    talk(own_address);
    talk({{"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#0400000000000000", {}},
          {"7E5#5E00000000000000", {}}});
}

TEST_F(Lss, SwitchStateSelectiveWithWrongMissingOrMisplacedNumbersSelectsNoSlave) {
    verifies<req::CO_LSS_003>();
    const std::vector<std::vector<Exchange>> others{{{"7E5#4060000000000000", {}},  // the number of another vendor
                                                     {"7E5#41010302AA000000", {}},
                                                     {"7E5#4202000100000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},
                                                     {"7E5#41010302AB000000", {}},  // the number of another product
                                                     {"7E5#4202000100000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},
                                                     {"7E5#41010302AA000000", {}},
                                                     // the revision number is not that of the slave
                                                     {"7E5#4203000100000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},
                                                     {"7E5#41010302AA000000", {}},
                                                     {"7E5#4202000100000000", {}},
                                                     // the serial number is not that of the slave
                                                     {"7E5#4320112620000000", {}}},
                                                    {{"7E5#41010302AA000000", {}},  // the vendor-ID is missing
                                                     {"7E5#4202000100000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},  // the revision number is missing
                                                     {"7E5#41010302AA000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},  // two numbers in the wrong order
                                                     {"7E5#4202000100000000", {}},
                                                     {"7E5#41010302AA000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#405F000000000000", {}},
                                                     {"7E5#41010302AA000000", {}},
                                                     {"7E5#41010302AA000000", {}},  // the product code comes twice
                                                     {"7E5#4202000100000000", {}},
                                                     {"7E5#4321112620000000", {}}},
                                                    {{"7E5#4321112620000000", {}}}};  // the last number alone
    for (const auto& conversation : others) {
        talk(conversation);
        EXPECT_FALSE(is_configuring());
    }
}

TEST_F(Lss, VendorIdRestartsSwitchStateSelective) {
    verifies<req::CO_LSS_068>();
    talk({{"7E5#405F000000000000", {}},
          {"7E5#41010302AA000000", {}},
          {"7E5#405F000000000000", {}},
          {"7E5#41010302AA000000", {}},
          {"7E5#4202000100000000", {}},
          {"7E5#4321112620000000", {"7E4#4400000000000000"}}});
    talk({{"7E5#0400000000000000", {}}, {"7E5#4060000000000000", {}}});  // first another slave …
    talk(own_address);                                                   // … then this one
}

TEST_F(Lss, OtherLssServicesDoNotInterruptSwitchStateSelective) {
    verifies<req::CO_LSS_069>();
    talk({{"7E5#405F000000000000", {}},
          {"7E5#4C00000000000000", {}},
          {"7E5#41010302AA000000", {}},
          {"7E5#465F000000000000", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#0400000000000000", {}},
          {"7E5#4202000100000000", {}},
          {"605#4000100000000000", {"585#4300100078563412"}},
          {"7E5#4321112620000000", {"7E4#4400000000000000"}}});
}

// CiA 305, 6.3: an NMT reset also resets the LSS state and unfinished sequences
TEST_F(Lss, ResetsEndLssConfigurationAndUnfinishedLssSequences) {
    verifies<req::CO_LSS_004, req::CO_LSS_086>();
    for (const char* reset : {"000#8105", "000#8205"}) {
        configure();
        talk({{reset, {"705#00"}}, {"7E5#5E00000000000000", {}}});
        talk({{"7E5#405F000000000000", {}},
              {"7E5#41010302AA000000", {}},
              {reset, {"705#00"}},
              {"7E5#4202000100000000", {}},
              {"7E5#4321112620000000", {}}});
        talk({{"7E5#465F000000000000", {}},
              {"7E5#47010302AA000000", {}},
              {"7E5#4802000100000000", {}},
              {reset, {"705#00"}},
              {"7E5#4902000100000000", {}},
              {"7E5#4A21112620000000", {}},
              {"7E5#4B21112620000000", {}}});
        // After the reset, the first frame of the sequence is missing, so the slave is not selected.
        talk({{"7E5#41010302AA000000", {}}, {"7E5#4202000100000000", {}}, {"7E5#4321112620000000", {}}});
        talk({{"7E5#405F000000000000", {}}, {"7E5#465F000000000000", {}}, {reset, {"705#00"}}});
        talk({{"7E5#41010302AA000000", {}}, {"7E5#4202000100000000", {}}, {"7E5#4321112620000000", {}}});
        talk({{"7E5#47010302AA000000", {}},
              {"7E5#4802000100000000", {}},
              {"7E5#4902000100000000", {}},
              {"7E5#4A21112620000000", {}},
              {"7E5#4B21112620000000", {}}});
    }
    configure();
    EXPECT_EQ(start({5, 125000}), (Frames{"705#00"}));
    EXPECT_FALSE(is_configuring());
}

// Tests each field of table CO-T-LSS: the answer to each LSS service in LSS waiting, in LSS configuration, and in LSS
// configuration while the NMT state is operational.
TEST_F(Lss, EachLssServiceWorksInItsStatesOnly) {
    verifies<req::CO_LSS_005, req::CO_LSS_006, req::CO_LSS_070, req::CO_T_LSS>();
    struct Row {
        const char* request;
        Frames waiting;
        Frames configuration;
        Frames operational;
    };
    const Frames identified{"7E4#4F00000000000000"};
    const std::vector<Row> rows{{"7E5#1107000000000000", {}, {"7E4#1100000000000000"}, {}},
                                {"7E5#1300030000000000", {}, {"7E4#1300000000000000"}, {}},
                                {"7E5#1700000000000000", {}, {"7E4#1700000000000000"}, {}},
                                {"7E5#5A00000000000000", {}, {"7E4#5A5F000000000000"}, {"7E4#5A5F000000000000"}},
                                {"7E5#5B00000000000000", {}, {"7E4#5B010302AA000000"}, {"7E4#5B010302AA000000"}},
                                {"7E5#5C00000000000000", {}, {"7E4#5C02000100000000"}, {"7E4#5C02000100000000"}},
                                {"7E5#5D00000000000000", {}, {"7E4#5D21112620000000"}, {"7E4#5D21112620000000"}},
                                {"7E5#5E00000000000000", {}, {"7E4#5E05000000000000"}, {"7E4#5E05000000000000"}},
                                {"7E5#465F000000000000", {}, {}, {}},
                                {"7E5#47010302AA000000", {}, {}, {}},
                                {"7E5#4802000100000000", {}, {}, {}},
                                {"7E5#4902000100000000", {}, {}, {}},
                                {"7E5#4A21112620000000", {}, {}, {}},
                                {"7E5#4B21112620000000", identified, identified, identified},
                                {"7E5#405F000000000000", {}, {}, {}},
                                {"7E5#41010302AA000000", {}, {}, {}},
                                {"7E5#4202000100000000", {}, {}, {}},
                                {"7E5#4321112620000000", {"7E4#4400000000000000"}, {}, {}}};
    for (const Row& row : rows) {
        EXPECT_EQ(send(row.request), row.waiting) << "LSS waiting: " << row.request;
    }
    for (const Row& row : rows) {
        EXPECT_EQ(send(row.request), row.configuration) << "LSS configuration: " << row.request;
    }
    send("000#0105");
    for (const Row& row : rows) {
        EXPECT_EQ(send(row.request), row.operational) << "operational: " << row.request;
    }
    // The selection frames that were sent in LSS configuration have no effect afterwards.
    send("7E5#0400");
    EXPECT_TRUE(send("7E5#4321112620000000").empty());
}

TEST_F(Lss, SwitchStateSelectiveFramesInLssConfigurationHaveNoEffect) {
    verifies<req::CO_LSS_005, req::CO_T_LSS>();
    // In each round, one of the four frames (each in turn) is sent while the slave is in LSS configuration. There it
    // has no effect.
    for (std::size_t early = 0; early < own_address.size(); ++early) {
        for (std::size_t i = 0; i < own_address.size(); ++i) {
            send(i == early ? "7E5#0401" : "7E5#0400");
            EXPECT_TRUE(send(own_address[i].request).empty()) << early << ", frame " << i;
        }
        send("7E5#0400");
        EXPECT_FALSE(is_configuring()) << early;
    }
}

// CiA 301, 7.3.2.3
TEST_F(Lss, LssWorksInStopped) {
    verifies<req::CO_LSS_006>();
    talk({{"000#0205", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#1109000000000000", {"7E4#1100000000000000"}},
          {"7E5#1300020000000000", {"7E4#1300000000000000"}},
          {"7E5#1700000000000000", {"7E4#1700000000000000"}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#1500000000000000", {}},
          {"7E5#0400000000000000", {}}});
    EXPECT_EQ(bit_rate(), 500000U);
    EXPECT_EQ(state(), NmtState::stopped);
}

TEST_F(Lss, LssConfiguresNothingInOperational) {
    verifies<req::CO_LSS_070>();
    talk({{"7E5#0401000000000000", {}},
          {"7E5#1300020000000000", {"7E4#1300000000000000"}},
          {"000#0105", {"185#0000"}},
          {"7E5#1107000000000000", {}},
          {"7E5#1300030000000000", {}},
          {"7E5#1500000000000000", {}},
          {"7E5#1700000000000000", {}}});
    EXPECT_EQ(bit_rate(), 125000U);
    EXPECT_EQ(device->stored().node_id, 5);
    // The slave refuses to set a bit rate in operational, and does not keep the refused one either.
    talk({{"000#8005", {}}, {"7E5#1500000000000000", {}}, {"000#8205", {"705#00"}}});
    EXPECT_EQ(bit_rate(), 500000U);
}

TEST_F(Lss, SwitchStateGlobalWorksInOperational) {
    verifies<req::CO_LSS_006, req::CO_LSS_001>();
    send("000#0105");
    talk({{"7E5#0401000000000000", {}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}},
          {"7E5#0400000000000000", {}},
          {"7E5#5E00000000000000", {}}});
    talk(own_address);
    EXPECT_EQ(state(), NmtState::operational);
}

// -- frames -----------------------------------------------------------------------------------------------------------

// Each request is sent with too few bytes, with just enough bytes, with more, and with all eight bytes.
TEST_F(Lss, TooShortRequestIsIgnored_AndOnlyARequestOf8BytesGetsAnAnswerOf8Bytes) {
    verifies<req::CO_LSS_060, req::CO_LSS_080, req::CO_LSS_061, req::CO_LSS_081, req::CO_T_LSS>();
    configure();
    talk({{"7E5#", {}},
          {"7E5#11", {}},
          {"7E5#1107", {"7E4#110000"}},
          {"7E5#110799AABBCCDD", {"7E4#110000"}},
          {"7E5#110799AABBCCDDEE", {"7E4#1100000000000000"}},
          {"7E5#1100", {"7E4#110100"}},
          {"7E5#13", {}},
          {"7E5#1300", {}},
          {"7E5#130003", {"7E4#130000"}},
          {"7E5#13000399", {"7E4#130000"}},
          {"7E5#130003AABBCCDDEE", {"7E4#1300000000000000"}},
          {"7E5#17", {"7E4#170000"}},
          {"7E5#17AABB", {"7E4#170000"}},
          {"7E5#17AABBCCDDEEFF00", {"7E4#1700000000000000"}},
          {"7E5#5A", {"7E4#5A5F000000"}},
          {"7E5#5B", {"7E4#5B010302AA"}},
          {"7E5#5C", {"7E4#5C02000100"}},
          {"7E5#5D", {"7E4#5D21112620"}},
          {"7E5#5E", {"7E4#5E05"}},
          {"7E5#5EFFFFFFFFFFFF", {"7E4#5E05"}},
          {"7E5#5EFFFFFFFFFFFFFF", {"7E4#5E05000000000000"}},
          {"7E5#15", {}},
          {"7E5#1500", {}}});  // too short: no switch delays follow
    EXPECT_EQ(bit_rate(), 125000U);
    talk({{"7E5#5E", {"7E4#5E05"}}, {"7E5#04", {}}, {"7E5#5E", {"7E4#5E05"}}, {"7E5#150000", {}}});
    EXPECT_EQ(bit_rate(), 250000U);
    talk({{"7E5#0400", {}}, {"7E5#5E", {}}, {"7E5#04", {}}, {"7E5#5E", {}}, {"7E5#0401FFFFFFFFFFFF", {}}});
    EXPECT_TRUE(is_configuring());
}

TEST_F(Lss, TooShortFramesWithinASelectiveSwitchOrIdentifySequenceAreIgnored) {
    verifies<req::CO_LSS_060, req::CO_LSS_081, req::CO_T_LSS>();
    talk({{"7E5#405F0000", {}},
          {"7E5#41010302AA", {}},
          {"7E5#4202000100", {}},
          {"7E5#4321112620", {}},
          {"7E5#405F000000", {}},
          {"7E5#41010302", {}},  // 41010302h is too short and is ignored; the sequence
                                 // continues with the next frame
          {"7E5#41010302AA", {}},
          {"7E5#42020001", {}},
          {"7E5#4202000100", {}},
          {"7E5#43211126", {}},
          {"7E5#4321112620", {"7E4#44"}},
          {"7E5#465F000000", {}},
          {"7E5#47010302", {}},
          {"7E5#47010302AA", {}},
          {"7E5#48020001", {}},
          {"7E5#4802000100", {}},
          {"7E5#49020001", {}},
          {"7E5#4902000100", {}},
          {"7E5#4A211126", {}},
          {"7E5#4A21112620", {}},
          {"7E5#4B211126", {}},
          {"7E5#4B21112620", {"7E4#4F"}},
          {"7E5#465F0000", {}},
          {"7E5#47010302AA", {}},
          {"7E5#4802000100", {}},
          {"7E5#4902000100", {}},
          {"7E5#4A21112620", {}},
          {"7E5#4B21112620", {}}});
}

TEST_F(Unconfigured, FastscanRequestNeedsEightBytes) {
    verifies<req::CO_LSS_060, req::CO_LSS_080, req::CO_LSS_061, req::CO_LSS_081, req::CO_T_LSS>();
    talk({{"7E5#51000000008000", {}},
          {"7E5#5100000000800000", {"7E4#4F00000000000000"}},
          {"7E5#4C", {"7E4#50"}},
          {"7E5#4C00000000000000", {"7E4#5000000000000000"}}});
}

TEST_F(Lss, FramesOfOtherIdentifiersFormatsOrCommandsAreNoLssRequests) {
    verifies<req::CO_LSS_062, req::CO_K_LSS_REQUEST_ID>();
    talk({{"7E5#R", {}},
          {"7E5#R8", {}},
          {"000007E5#0401000000000000", {}},
          {"7E4#0401000000000000", {}},
          {"7E6#0401000000000000", {}}});
    EXPECT_FALSE(is_configuring());
    configure();
    for (int specifier = 0; specifier <= 255; ++specifier) {
        const bool known = specifier == 0x04 || specifier == 0x11 || specifier == 0x13 || specifier == 0x15 ||
                           specifier == 0x17 || (specifier >= 0x40 && specifier <= 0x43) ||
                           (specifier >= 0x46 && specifier <= 0x4C) || specifier == 0x51 ||
                           (specifier >= 0x5A && specifier <= 0x5E);
        char request[32];
        std::snprintf(request, sizeof request, "7E5#%02X01000000000000", static_cast<unsigned>(specifier) & 0xFFU);
        if (!known) {
            EXPECT_TRUE(send(request).empty()) << request;
            EXPECT_TRUE(is_configuring()) << request;
        }
    }
}

// CAN-CBX-AO412, 7.5: LSS identifiers are not among the identifiers of the device.
TEST_F(CbxTest, DeviceWithoutLssIgnoresLssFrames) {
    verifies<req::CO_LSS_064>();
    for (const char* frame : {"7E5#0401000000000000", "7E5#5E00000000000000", "7E5#110A000000000000",
                              "7E5#1300030000000000", "7E5#1700000000000000", "7E5#1564000000000000",
                              "7E5#0400000000000000", "7E5#4C00000000000000", "7E5#5100000000800000"}) {
        EXPECT_EQ(send(frame), Frames{}) << frame;
    }
    EXPECT_EQ(send("000#8203"), (Frames{"703#00"}));
}

}  // namespace canproof::test
