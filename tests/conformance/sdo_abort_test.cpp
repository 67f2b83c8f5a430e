// SPDX-License-Identifier: Apache-2.0
// Tests every abort code of CiA 301 (7.2.4.3.17, Table 22) on the conformance slave, node 5: exchanges of frames whose
// last answer is the abort. Codes that the slave never sends are listed with the reason.
#include <fmt/format.h>

#include <map>
#include <set>

#include "generated/canopen/requirements.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/sdo_text.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class SdoAbort : public testing::Test, public SlaveBench {};

/// One abort code, and the exchange that causes it. The last answer in the exchange is the abort.
struct Case {
    std::uint32_t code;
    std::string when;
    std::vector<Exchange> conversation;
};

const std::vector<Case> cases{
    {0x05030000,
     "the first segment of a download with toggle 1",
     {{"605#2100230003000000", {"585#6000230000000000"}}, {"605#1978797A00000000", {"585#8000230000000305"}}}},
    {0x05030000,
     "the second segment of a download with toggle 0",
     {{"605#210023000A000000", {"585#6000230000000000"}},
      {"605#0061626364656667", {"585#2000000000000000"}},
      {"605#0968696A00000000", {"585#8000230000000305"}}}},
    {0x05030000,
     "the second segment of an upload asked for with toggle 0",
     {{"605#4008100000000000", {"585#4108100011000000"}},
      {"605#6000000000000000", {"585#00436F6E666F726D"}},
      {"605#6000000000000000", {"585#8008100000000305"}}}},
    {0x05040001, "the unassigned specifier 7", {{"605#E000100000000000", {"585#8000100001000405"}}}},
    {0x05040001, "a download segment without a transfer", {{"605#0041000000000000", {"585#8000000001000405"}}}},
    {0x05040001, "an upload segment without a transfer", {{"605#6000000000000000", {"585#8000000001000405"}}}},
    {0x05040001, "start of a block upload that nobody initiated", {{"605#A300000000000000", {"585#8000000001000405"}}}},
    {0x05040001, "end of a block download that nobody initiated", {{"605#C100000000000000", {"585#8000000001000405"}}}},
    {0x05040001,
     "an upload segment in a download",
     {{"605#2100230003000000", {"585#6000230000000000"}}, {"605#6000000000000000", {"585#8000230001000405"}}}},
    {0x05040002, "a block upload in blocks of none", {{"605#A400100000000000", {"585#8000100002000405"}}}},
    {0x05040002, "a block upload in blocks of 128", {{"605#A400100080000000", {"585#8000100002000405"}}}},
    {0x05040002,
     "an acknowledgement that asks for blocks of none",
     {{"605#A400100001000000", {"585#C600100004000000"}},
      {"605#A300000000000000", {"585#8178563412000000"}},
      {"605#A201000000000000", {"585#8000100002000405"}}}},
    {0x05040003,
     "a segment of a block download with number 0",
     {{"605#C600240009000000", {"585#A40024007F000000"}}, {"605#0031323334353637", {"585#8000240003000405"}}}},
    {0x05040003,
     "acknowledgement of a segment that was not sent",
     {{"605#A400100001000000", {"585#C600100004000000"}},
      {"605#A300000000000000", {"585#8178563412000000"}},
      {"605#A202010000000000", {"585#8000100003000405"}}}},
    {0x05040004,
     "another CRC than that of 123456789",
     {{"605#C600240009000000", {"585#A40024007F000000"}},
      {"605#0131323334353637", {}},
      {"605#8238390000000000", {"585#A2027F0000000000"}},
      {"605#D5C3320000000000", {"585#8000240004000405"}}}},
    {0x05040005, "a DOMAIN for which there is no memory", {{"605#2001240000000000", {"585#8001240005000405"}}}},
    {0x05040005, "a string longer than what the server holds", {{"605#2102230005000000", {"585#8002230005000405"}}}},
    {0x06010000,
     "a DOMAIN that cannot be read for want of memory",
     {{"605#4001240000000000", {"585#8001240000000106"}}}},
    {0x06010001, "reading a write-only entry", {{"605#4005220000000000", {"585#8005220001000106"}}}},
    {0x06010002, "writing a read-only entry", {{"605#2300100000000000", {"585#8000100002000106"}}}},
    {0x06010002, "writing a constant entry", {{"605#2101230036000000", {"585#8001230002000106"}}}},
    {0x06020000, "reading an object that is absent", {{"605#40FF5F0000000000", {"585#80FF5F0000000206"}}}},
    {0x06020000, "writing an object that is absent", {{"605#2FFF5F0000000000", {"585#80FF5F0000000206"}}}},
    {0x06040041,
     "mapping an object that cannot be mapped into an RPDO",
     {{"605#2300140105020080", {"585#6000140100000000"}},
      {"605#2F00160000000000", {"585#6000160000000000"}},
      {"605#2300160120000010", {"585#8000160141000406"}}}},
    {0x06040042,
     "mapping 64 and 32 bits into one RPDO",
     {{"605#2300140105020080", {"585#6000140100000000"}},
      {"605#2F00160000000000", {"585#6000160000000000"}},
      {"605#2300160140000622", {"585#6000160100000000"}},
      {"605#2300160220000722", {"585#6000160200000000"}},
      {"605#2F00160002000000", {"585#8000160042000406"}}}},
    {0x06040043,
     "one producer in two entries of 1016h",
     {{"605#23161001E8030900", {"585#6016100100000000"}}, {"605#23161002E8030900", {"585#8016100243000406"}}}},
    {0x06070010,
     "three bytes announced, two sent",
     {{"605#2100230003000000", {"585#6000230000000000"}}, {"605#0B61620000000000", {"585#8000230010000706"}}}},
    {0x06070012, "four bytes for a UNSIGNED8", {{"605#2301220002000000", {"585#8001220012000706"}}}},
    {0x06070012, "41 bytes announced for a string of 40", {{"605#2100230029000000", {"585#8000230012000706"}}}},
    {0x06070013, "one byte for an INTEGER16", {{"605#2F00220002000000", {"585#8000220013000706"}}}},
    {0x06090011, "a sub-index that an object does not have", {{"605#4018100500000000", {"585#8018100511000906"}}}},
    {0x06090030, "3 where only 2 and 8 are allowed", {{"605#2F01220003000000", {"585#8001220030000906"}}}},
    {0x06090030, "2 for a BOOLEAN", {{"605#2F02200102000000", {"585#8002200130000906"}}}},
    {0x06090031, "101 where 100 is the limit", {{"605#2B00220065000000", {"585#8000220031000906"}}}},
    {0x06090031, "a lower bound above the upper one", {{"605#2B03220033000000", {"585#8003220031000906"}}}},
    {0x06090032, "-101 where -100 is the limit", {{"605#2B0022009BFF0000", {"585#8000220032000906"}}}},
    {0x08000020, "1010h without the signature", {{"605#2310100101000000", {"585#8010100120000008"}}}},
    {0x08000020, "1011h with the signature of 1010h", {{"605#2311100173617665", {"585#8011100120000008"}}}},
    {0x08000022, "mapping an RPDO that is valid", {{"605#2F00160000000000", {"585#8000160022000008"}}}},
    {0x08000024, "a DOMAIN that holds nothing", {{"605#4000240000000000", {"585#8000240024000008"}}}},
};

/// Abort codes that the SDO server never sends (CO-SDO-036), each with the reason.
const std::map<std::uint32_t, std::string> never_sent{
    {0x06040047, "general internal incompatibility: no part of the slave can be incompatible with another"},
    {0x06090036, "maximum below minimum: a limit that is another object gets the code of a limit"},
    {0x060A0023, "resource not available: the server needs no other resource"},
    {0x08000000, "general error: there is always a code that says more"},
    {0x08000021, "local control: no value here belongs to a local operator"},
    {0x08000023, "no dictionary: the dictionary is not made at run time"},
};

std::uint32_t code_of(const std::string& abort) {
    // The text of an abort: 585#80, index, sub-index, then (from position 12) the code, least significant byte first.
    std::uint32_t code = 0;
    for (std::size_t byte = 0; byte < 4; ++byte) {
        const auto bits = static_cast<std::uint32_t>(std::stoul(abort.substr(12 + 2 * byte, 2), nullptr, 16));
        code |= bits << (8 * byte);
    }
    return code;
}

}  // namespace

TEST(SdoAbortTable, EachAbortCodeIsCausedByTheListedFrames) {
    verifies<req::CO_SDO_040, req::CO_E_ABORT, req::CO_SDO_005, req::CO_SDO_006, req::CO_SDO_008, req::CO_SDO_009,
             req::CO_SDO_010, req::CO_SDO_023, req::CO_SDO_024, req::CO_SDO_027, req::CO_SDO_028, req::CO_SDO_046,
             req::CO_SDO_034, req::CO_SDO_056, req::CO_SDO_057, req::CO_SDO_058, req::CO_SDO_059, req::CO_SDO_060,
             req::CO_SDO_061, req::CO_SDO_062>();
    for (const Case& one : cases) {
        SCOPED_TRACE(one.when);
        SlaveBench bench;
        talk(bench, one.conversation);
        EXPECT_EQ(code_of(one.conversation.back().answers.back()), one.code);
    }
}

TEST_F(SdoAbort, StalledTransferIsAbortedByTimeOut) {
    verifies<req::CO_SDO_014, req::CO_E_ABORT>();
    send("605#4008100000000000");
    EXPECT_EQ(pass(1000), (Frames{"1000:585#8008100000000405"}));
}

TEST_F(SdoAbort, FailedMemoryIsReportedAsAHardwareError) {
    verifies<req::CO_E_ABORT>();
    memory.cut_power_after(3);
    EXPECT_EQ(send("605#2310100173617665"), (Frames{"585#8010100100000606"}));
}

TEST_F(SdoAbort, EveryAbortCodeOfCiA301IsTestedOrListedAsNeverSent) {
    verifies<req::CO_E_ABORT, req::CO_SDO_036>();
    // All abort codes of CiA 301, Table 22, in the order of the table
    const std::vector<std::uint32_t> all{
        0x05030000, 0x05040000, 0x05040001, 0x05040002, 0x05040003, 0x05040004, 0x05040005, 0x06010000,
        0x06010001, 0x06010002, 0x06020000, 0x06040041, 0x06040042, 0x06040043, 0x06040047, 0x06060000,
        0x06070010, 0x06070012, 0x06070013, 0x06090011, 0x06090030, 0x06090031, 0x06090032, 0x06090036,
        0x060A0023, 0x08000000, 0x08000020, 0x08000021, 0x08000022, 0x08000023, 0x08000024};
    std::set<std::uint32_t> provoked{0x05040000, 0x06060000};  // two tests above this one cause these codes
    for (const Case& one : cases) {
        provoked.insert(one.code);
    }
    for (const std::uint32_t code : all) {
        EXPECT_NE(provoked.count(code), never_sent.count(code)) << fmt::format("{:08X}h", code);
    }
    EXPECT_EQ(provoked.size() + never_sent.size(), all.size());
}

TEST_F(SdoAbort, NoSingleRequestCausesAnAbortCodeListedAsNeverSent) {
    verifies<req::CO_SDO_036>();
    // Sends requests with every possible first byte, to many objects of the slave and to absent objects, each with
    // three values.
    std::set<std::uint32_t> seen;
    const auto ask = [&](const std::string& request) {
        for (const auto& answer : send(request)) {
            if (answer.rfind("585#80", 0) == 0) {
                const std::uint32_t code = code_of(answer);
                seen.insert(code);
                ASSERT_EQ(never_sent.count(code), 0U) << request << " was answered " << answer;
            }
        }
        send("605#8000000000000000");
    };
    for (unsigned index : {0x0000U, 0x0005U, 0x1000U, 0x1003U, 0x1005U, 0x1006U, 0x1008U, 0x100CU, 0x1010U, 0x1011U,
                           0x1014U, 0x1016U, 0x1017U, 0x1019U, 0x1020U, 0x1029U, 0x1400U, 0x1600U, 0x1800U, 0x1A00U,
                           0x2000U, 0x2002U, 0x2100U, 0x2200U, 0x2201U, 0x2202U, 0x2203U, 0x2204U, 0x2205U, 0x2206U,
                           0x2300U, 0x2301U, 0x2302U, 0x2400U, 0x2401U, 0x2402U, 0x5FFFU, 0xFFFFU}) {
        for (unsigned subindex : {0U, 1U, 2U, 5U, 255U}) {
            for (unsigned command = 0; command < 256; ++command) {
                for (const char* data : {"00000000", "FFFFFFFF", "65000000"}) {
                    ask("605#" + hex_le(command, 1) + hex_le(index, 2) + hex_le(subindex, 1) + data);
                }
            }
        }
    }
    EXPECT_GE(seen.size(), 10U);  // at least ten different abort codes occurred, so the requests reached many checks
}

}  // namespace canproof::test
