// SPDX-License-Identifier: Apache-2.0
// Tests LSS inquiry, LSS identification and LSS Fastscan (CiA 305, 6.5 to 6.7).
#include "generated/canopen/requirements.hpp"
#include "tests/conformance/lss_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

// -- inquiry and identification ---------------------------------------------------------------------------------------

// CiA 305, 6.5
TEST_F(Lss, InquiriesReturnTheLssAddressAndTheNodeId) {
    verifies<req::CO_LSS_040, req::CO_LSS_041, req::CO_E_LSS_COMMAND>();
    configure();
    talk({{"7E5#5A00000000000000", {"7E4#5A5F000000000000"}},
          {"7E5#5B00000000000000", {"7E4#5B010302AA000000"}},
          {"7E5#5C00000000000000", {"7E4#5C02000100000000"}},
          {"7E5#5D00000000000000", {"7E4#5D21112620000000"}},
          {"7E5#5E00000000000000", {"7E4#5E05000000000000"}}});
}

// CiA 305, 6.6.2: the request contains a range of revision numbers and a range of serial numbers; both include their
// bounds
TEST_F(Lss, IdentifyRemoteSlaveIsAnsweredByASlaveWithinTheRanges) {
    verifies<req::CO_LSS_042, req::CO_E_LSS_ANSWER>();
    talk({{"7E5#465F000000000000", {}},
          {"7E5#47010302AA000000", {}},
          {"7E5#4802000100000000", {}},  // both bounds equal the revision number of the slave
          {"7E5#4902000100000000", {}},
          {"7E5#4A21112620000000", {}},
          {"7E5#4B21112620000000", {"7E4#4F00000000000000"}}});
    talk({{"7E5#465F000000000000", {}},
          {"7E5#47010302AA000000", {}},
          {"7E5#4800000000000000", {}},  // ranges of all revision numbers and all serial numbers
          {"7E5#49FFFFFFFF000000", {}},
          {"7E5#4A00000000000000", {}},
          {"7E5#4BFFFFFFFF000000", {"7E4#4F00000000000000"}}});
    EXPECT_FALSE(is_configuring());  // identified, not selected
}

TEST_F(Lss, IdentifyRemoteSlaveIsIgnoredUnlessAllSixNumbersFitAndArriveInOrder) {
    verifies<req::CO_LSS_043>();
    const std::vector<Exchange> fitting{{"7E5#465F000000000000", {}}, {"7E5#47010302AA000000", {}},
                                        {"7E5#4801000100000000", {}}, {"7E5#4903000100000000", {}},
                                        {"7E5#4A20112620000000", {}}, {"7E5#4B22112620000000", {}}};
    const std::vector<std::pair<std::size_t, const char*>> misfits{
        {0, "7E5#465E000000000000"},   // the number of another vendor
        {1, "7E5#4702030200000000"},   // the number of another product
        {1, "7E5#47FFFFFFFF000000"},   // a product code above that of the slave
        {2, "7E5#4803000100000000"},   // lowest revision number: 00010003h
        {3, "7E5#4901000100000000"},   // highest revision number: 00010001h
        {4, "7E5#4A22112620000000"},   // lowest serial number: 20261122h
        {5, "7E5#4B20112620000000"}};  // highest serial number: 20261120h
    for (const auto& [at, request] : misfits) {
        std::vector<Exchange> conversation = fitting;
        conversation[at].request = request;
        talk(conversation);
    }
    for (std::size_t missing = 0; missing < fitting.size(); ++missing) {
        std::vector<Exchange> conversation = fitting;
        conversation.erase(conversation.begin() + static_cast<std::ptrdiff_t>(missing));
        talk(conversation);
    }
    std::vector<Exchange> twisted = fitting;
    std::swap(twisted[2], twisted[3]);
    talk(twisted);
    std::vector<Exchange> whole = fitting;
    whole[5].answers = {"7E4#4F00000000000000"};
    talk(whole);
    talk({{"7E5#4B22112620000000", {}}});  // no answer: the last frame of the sequence alone has no effect
}

TEST_F(Lss, IdentifyRemoteSlaveRestartsWithAVendorId) {
    verifies<req::CO_LSS_077>();
    talk({{"7E5#465F000000000000", {}},
          {"7E5#47010302AA000000", {}},
          {"7E5#4802000100000000", {}},
          {"7E5#465F000000000000", {}},
          {"7E5#47010302AA000000", {}},
          {"7E5#4802000100000000", {}},
          {"7E5#4902000100000000", {}},
          {"7E5#4A21112620000000", {}},
          {"7E5#4B21112620000000", {"7E4#4F00000000000000"}}});
}

TEST_F(Lss, IdentifyRemoteSlaveBeginsWithAVendorIdAfterAReset) {
    verifies<req::CO_LSS_042, req::CO_LSS_077>();
    talk({{"7E5#465F000000000000", {}},
          {"000#8205", {"705#00"}},
          {"7E5#47010302AA000000", {}},  // ignored: the vendor-ID came before the reset
          {"7E5#4802000100000000", {}},
          {"7E5#4902000100000000", {}},
          {"7E5#4A21112620000000", {}},
          {"7E5#4B21112620000000", {}}});
}

TEST_F(Lss, SwitchStateSelectiveBeginsWithAVendorIdAfterAReset) {
    verifies<req::CO_LSS_002, req::CO_LSS_003>();
    talk({{"7E5#405F000000000000", {}},
          {"000#8205", {"705#00"}},
          {"7E5#41010302AA000000", {}},  // ignored: the vendor-ID came before the reset
          {"7E5#4202000100000000", {}},
          {"7E5#4321112620000000", {}}});
    EXPECT_FALSE(is_configuring());
}

TEST_F(Lss, OtherLssServicesDoNotInterruptIdentifyRemoteSlave) {
    verifies<req::CO_LSS_078>();
    talk({{"7E5#465F000000000000", {}},
          {"7E5#4C00000000000000", {}},
          {"7E5#47010302AA000000", {}},
          {"7E5#405F000000000000", {}},
          {"7E5#4802000100000000", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#4902000100000000", {}},
          {"7E5#0400000000000000", {}},
          {"7E5#4A21112620000000", {}},
          {"605#4000100000000000", {"585#4300100078563412"}},
          {"7E5#4B21112620000000", {"7E4#4F00000000000000"}}});
}

// CiA 305, 6.6.4
TEST_F(Lss, IdentifyNonConfiguredIsIgnoredByASlaveWithANodeId) {
    verifies<req::CO_LSS_044, req::CO_E_LSS_ANSWER>();
    talk({{"7E5#4C00000000000000", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#4C00000000000000", {}},
          {"7E5#11FF000000000000", {"7E4#1100000000000000"}},
          {"7E5#4C00000000000000", {}}});  // no answer: the active node-ID is still 5
}

TEST_F(Unconfigured, IdentifyNonConfiguredIsAnsweredInLssWaitingAndLssConfiguration) {
    verifies<req::CO_LSS_044, req::CO_E_LSS_ANSWER>();
    talk({{"7E5#4C00000000000000", {"7E4#5000000000000000"}},
          {"7E5#0401000000000000", {}},
          {"7E5#4C00000000000000", {"7E4#5000000000000000"}},
          {"7E5#1107000000000000", {"7E4#1100000000000000"}},
          {"7E5#4C00000000000000", {}},  // no answer: a node-ID is pending
          {"7E5#0400000000000000", {"707#00"}},
          {"7E5#4C00000000000000", {}}});
}

// -- Fastscan, 6.7: 51h, number (32 bits), bit check, selected number (0 to 3), next number ------------------------

TEST_F(Unconfigured, FastscanConfirmsTheFourNumbersOfTheLssAddress) {
    verifies<req::CO_LSS_050, req::CO_LSS_051, req::CO_LSS_052, req::CO_LSS_079, req::CO_LSS_053, req::CO_LSS_054,
             req::CO_E_LSS_NUMBER, req::CO_K_LSS_RESTART, req::CO_K_LSS_HIGHEST_BIT>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#5100000000800000", yes},  // asks for any unconfigured slave
          {"7E5#51000000001F0000", yes},  // vendor-ID, bit 31 is 0
          {"7E5#51000000801F0000", {}},   // bit 31 is not 1
          {"7E5#5100000000070000", yes},  // bits 31 to 7 are 0 (5Fh = 0101 1111b)
          {"7E5#5100000000060000", {}},   // bit 6 is not 0
          {"7E5#5140000000060000", yes},
          {"7E5#5140000000050000", yes},
          {"7E5#5140000000040000", {}},
          {"7E5#515E000000010000", yes},
          {"7E5#515E000000000000", {}},   // the last bit is 1
          {"7E5#515F000000000000", yes},  // all bits match; "next number" 0 stays at the vendor-ID
          {"7E5#51010302AA000101", {}},   // no answer: the product code is not selected yet
          {"7E5#515F000000000001", yes},  // the vendor-ID is confirmed; the product code is next
          {"7E5#515F000000000001", {}},   // no answer: the product code is selected now, so the vendor-ID is not
                                          // expected
          {"7E5#51000000001F0101", {}},   // AA020301h: bit 31 is 1
          {"7E5#51000000801F0101", yes},
          {"7E5#51010302AA000102", yes},
          {"7E5#5102000100000203", yes}});
    EXPECT_FALSE(is_configuring());
    talk({{"7E5#5121112620000300", yes}});
    EXPECT_TRUE(is_configuring());
    talk({{"7E5#1107000000000000", {"7E4#1100000000000000"}}, {"7E5#0400000000000000", {"707#00"}}});
}

TEST_F(Unconfigured, FastscanFindsTheLssAddressBitByBit) {
    verifies<req::CO_LSS_052, req::CO_LSS_053, req::CO_LSS_054, req::CO_E_LSS_NUMBER, req::CO_K_LSS_RESTART,
             req::CO_K_LSS_HIGHEST_BIT>();
    const auto ask = [this](std::uint32_t number, unsigned bit_check, unsigned which, unsigned next) {
        char request[32];
        std::snprintf(request, sizeof request, "7E5#51%02X%02X%02X%02X%02X%02X%02X",
                      static_cast<unsigned>(number & 0xFFU), static_cast<unsigned>((number >> 8U) & 0xFFU),
                      static_cast<unsigned>((number >> 16U) & 0xFFU), static_cast<unsigned>(number >> 24U), bit_check,
                      which, next);
        return !send(request).empty();
    };
    ASSERT_TRUE(ask(0, 128, 0, 0));
    std::vector<std::uint32_t> found;
    for (unsigned which = 0; which < 4; ++which) {
        std::uint32_t number = 0;
        for (unsigned bit = 32; bit-- > 0;) {
            number |= ask(number, bit, which, which) ? 0U : 1U << bit;
        }
        EXPECT_FALSE(is_configuring());
        ASSERT_TRUE(ask(number, 0, which, (which + 1) % 4));
        found.push_back(number);
    }
    EXPECT_TRUE(is_configuring());
    EXPECT_EQ(found, (std::vector<std::uint32_t>{0x5F, 0xAA020301, 0x00010002, 0x20261121}));
}

TEST_F(Unconfigured, FastscanIsCompleteOnlyAfterAllFourNumbers) {
    verifies<req::CO_LSS_054, req::CO_LSS_053>();
    const Frames yes{"7E4#4F00000000000000"};
    const std::vector<std::vector<Exchange>> shortcuts{
        // after the vendor-ID, the master sends the serial number at once
        {{"7E5#515F000000000003", yes}, {"7E5#5121112620000300", yes}},
        // the product code names the vendor-ID as the next number
        {{"7E5#515F000000000001", yes}, {"7E5#51010302AA000100", yes}},
        {{"7E5#515F000000000002", yes}, {"7E5#5102000100000203", yes}, {"7E5#5121112620000300", yes}},
        {{"7E5#515F000000000001", yes}, {"7E5#51010302AA000103", yes}, {"7E5#5121112620000300", yes}},
        {{"7E5#515F000000000001", yes},
         {"7E5#51010302AA000102", yes},
         {"7E5#5102000100000203", yes},
         // the serial number names itself as the next number, so the scan does not end
         {"7E5#5121112620000303", yes}},
        {{"7E5#515F000000000001", yes},
         {"7E5#51010302AA000102", yes},
         {"7E5#5102000100000203", yes},
         {"7E5#5120112620010300", yes}},  // bit check 1 leaves out bit 0, so the scan does not end
        {{"7E5#515F000000000001", yes},
         {"7E5#51010302AA000102", yes},
         {"7E5#5102000100000203", yes},
         {"7E5#5122112620000300", {}}},  // the serial number of another unit
        {{"7E5#515F000000000001", yes},
         {"7E5#5100000080010103", {}},  // a mismatch in some bits does not confirm the number …
         {"7E5#5121112620000300", {}},
         {"7E5#51000000801F0103", yes},  // … and a match in only some bits does not confirm it either
         {"7E5#5121112620000300", {}}}};
    for (const auto& conversation : shortcuts) {
        talk({{"7E5#5100000000800000", yes}});
        talk(conversation);
        EXPECT_FALSE(is_configuring());
    }
}

TEST_F(Unconfigured, FastscanMasterMayChooseTheOrderOfTheFourAddressNumbers) {
    verifies<req::CO_LSS_053, req::CO_LSS_054>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#5100000000800000", yes},
          {"7E5#515F000000000003", yes},
          {"7E5#5121112620000301", yes},
          {"7E5#51010302AA000102", yes}});
    EXPECT_FALSE(is_configuring());
    talk({{"7E5#5102000100000200", yes}});
    EXPECT_TRUE(is_configuring());
}

TEST_F(Unconfigured, FastscanBeginsWithTheVendorIdAndBitCheck128RestartsIt) {
    verifies<req::CO_LSS_051, req::CO_LSS_083>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#51010302AA000102", {}},  // no answer: power-on has selected the vendor-ID, not the product code
          {"7E5#515F000000000001", yes},
          {"7E5#51010302AA000102", yes},
          {"7E5#5102000100000203", yes},
          {"7E5#51FFFFFFFF800203", yes},  // with bit check 128 the other fields have no meaning
          {"7E5#5121112620000300", {}},   // no answer: bit check 128 has restarted the scan at the vendor-ID
          {"7E5#515F000000000003", yes},
          {"7E5#5121112620000300", yes}});
    EXPECT_FALSE(is_configuring());  // product code and revision number must be confirmed again, so the scan is not
                                     // complete
}

TEST_F(Unconfigured, FastscanRestartsAfterPowerOnAndAfterCompletion) {
    verifies<req::CO_LSS_054, req::CO_LSS_086>();
    const Frames yes{"7E4#4F00000000000000"};
    const std::vector<Exchange> three{
        {"7E5#515F000000000001", yes}, {"7E5#51010302AA000102", yes}, {"7E5#5102000100000203", yes}};
    talk(three);
    start({255, 125000});
    talk({{"7E5#5121112620000300", {}}, {"7E5#515F000000000003", yes}, {"7E5#5121112620000300", yes}});
    EXPECT_FALSE(is_configuring());
    talk({{"7E5#5100000000800000", yes}});
    talk(three);
    talk({{"7E5#5121112620000300", yes}, {"7E5#0400000000000000", {}}});
    // the next scan has begun: the vendor-ID and the serial number are confirmed, two of four numbers
    talk({{"7E5#515F000000000003", yes}, {"7E5#5121112620000300", yes}});
    EXPECT_FALSE(is_configuring());
}

TEST_F(Unconfigured, FastscanInterruptedByResetCommunicationRestarts) {
    verifies<req::CO_LSS_086>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#515F000000000001", yes},
          {"7E5#51010302AA000102", yes},
          {"7E5#5102000100000203", yes},
          {"7E5#0401000000000000", {}},
          {"7E5#1105000000000000", {"7E4#1100000000000000"}},
          {"7E5#0400000000000000", {"705#00"}},
          {"7E5#0401000000000000", {}},
          {"7E5#11FF000000000000", {"7E4#1100000000000000"}},
          {"000#8205", {}},
          {"7E5#5121112620000300", {}},
          {"7E5#515F000000000003", yes},
          {"7E5#5121112620000300", yes}});
    EXPECT_FALSE(is_configuring());
}

TEST_F(Unconfigured, FastscanContinuesAfterAVisitToLssConfiguration) {
    verifies<req::CO_LSS_054>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#515F000000000001", yes},
          {"7E5#0401000000000000", {}},
          {"7E5#0400000000000000", {}},  // the node gets no node-ID, so it does not reset itself
          {"7E5#515F000000000001", {}},  // no answer: the product code is selected, not the vendor-ID
          {"7E5#51010302AA000102", yes}});
}

TEST_F(Unconfigured, FastscanIgnoresInvalidParameters) {
    verifies<req::CO_LSS_055, req::CO_K_LSS_RESTART, req::CO_K_LSS_HIGHEST_BIT, req::CO_LSS_084>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#5100000000800000", yes},
          {"7E5#515F0000001F0000", yes},
          {"7E5#515F000000200000", {}},  // bit check 32
          {"7E5#515F0000007F0000", {}},  // bit check 127
          {"7E5#515F000000810000", {}},  // bit check 129
          {"7E5#515F000000FF0000", {}},
          {"7E5#515F000000000400", {}},  // no answer: there is no fifth number
          {"7E5#515F00000000FF00", {}},
          {"7E5#515F000000000004", {}},  // no answer: the next number would be a fifth one
          {"7E5#515F0000000000FF", {}},
          {"7E5#515F0000001F0004", {}},
          {"7E5#515F000000010000", yes},
          {"7E5#515F000000000001", yes},
          {"7E5#5100000000800404", yes}});  // bit check 128 restarts whatever number is selected
}

TEST_F(Lss, FastscanIsIgnoredByASlaveWithANodeId) {
    verifies<req::CO_LSS_050>();
    talk({{"7E5#5100000000800000", {}},
          {"7E5#515F000000000000", {}},
          {"7E5#0401000000000000", {}},
          {"7E5#11FF000000000000", {"7E4#1100000000000000"}},
          {"7E5#0400000000000000", {}},
          {"7E5#5100000000800000", {}}});  // its active node-ID is still 5
}

TEST_F(Unconfigured, FastscanIsIgnoredInLssConfiguration) {
    verifies<req::CO_LSS_050, req::CO_T_LSS>();
    const Frames yes{"7E4#4F00000000000000"};
    talk({{"7E5#5100000000800000", yes},
          {"7E5#0401000000000000", {}},
          {"7E5#5100000000800000", {}},
          {"7E5#0400000000000000", {}},
          {"7E5#5100000000800000", yes}});
}

}  // namespace canproof::test
