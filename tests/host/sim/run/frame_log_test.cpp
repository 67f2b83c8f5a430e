// SPDX-License-Identifier: Apache-2.0
// Tests the content that the option --log writes, byte for byte.
#include "host/sim/run/frame_log.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace canproof::host {

namespace {

std::string written(LogFormat format) {
    std::ostringstream out;
    FrameLog log{&out, format};
    log.begin("vcan0");
    log.write({Instant{1000001}, "vcan0", parse_frame("603#4000100000000000", "test")}, false);
    log.write({Instant{1000002}, "vcan0", parse_frame("703#00", "test")}, true);
    return out.str();
}

/// Returns the bytes of these hexadecimal digits; spaces are ignored.
std::string bytes(const std::string& digits) {
    std::string all;
    std::istringstream words{digits};
    for (std::string word; words >> word;) {
        for (std::size_t i = 0; i < word.size(); i += 2) {
            all += static_cast<char>(std::stoul(word.substr(i, 2), nullptr, 16));
        }
    }
    return all;
}

}  // namespace

TEST(FrameLog, UnmarkedLinesHaveTheFormatOfCandump) {
    EXPECT_EQ(written(LogFormat::candump), "(1.000001) vcan0 603#4000100000000000\n(1.000002) vcan0 703#00\n");
}

TEST(FrameLog, MarksShowWhetherAFrameWasSentOrReceived) {
    EXPECT_EQ(written(LogFormat::marked), "(1.000001) vcan0 603#4000100000000000 R\n(1.000002) vcan0 703#00 T\n");
}

TEST(FrameLog, FileNameSelectsTheFormat) {
    EXPECT_EQ(log_format("a.log", false), LogFormat::candump);
    EXPECT_EQ(log_format("a.log", true), LogFormat::marked);
    EXPECT_EQ(log_format("a.pcapng", false), LogFormat::pcapng);
    EXPECT_EQ(log_format("a.pcapng", true), LogFormat::pcapng);
    EXPECT_EQ(log_format("a.pcap", false), LogFormat::pcap);
    EXPECT_EQ(log_format("a.pcap", true), LogFormat::pcap);
    EXPECT_EQ(log_format(".pcapng", false), LogFormat::candump);
    EXPECT_EQ(log_format(".pcap", false), LogFormat::candump);
    EXPECT_EQ(log_format("", false), LogFormat::candump);
}

TEST(FrameLog, LogWithoutAStreamNeedsNoFramesAndIgnoresThem) {
    for (const LogFormat format : {LogFormat::candump, LogFormat::marked, LogFormat::pcap, LogFormat::pcapng}) {
        std::ostringstream out;
        EXPECT_TRUE((FrameLog{&out, format}.is_wanted()));
        EXPECT_EQ(out.str(), "");  // the header comes with begin()
        FrameLog none{nullptr, format};
        EXPECT_FALSE(none.is_wanted());
        none.begin("can0");
        none.write({}, true);  // must not access the stream, which does not exist here
    }
}

TEST(FrameLog, PcapngHasSectionInterfaceAndPackets) {
    const std::string section = "0A0D0D0A 1C000000 4D3C2B1A 0100 0000 FFFFFFFFFFFFFFFF 1C000000";
    // link type 227 (E3h), no limit of length; option 2 (name) with five bytes; end of options
    const std::string interface = "01000000 24000000 E300 0000 00000000 0200 0500 7663616E30 000000 00000000 24000000";
    // 1,000,001 us = F4241h; 16 bytes: the identifier with its most significant byte first, length, three zeros, eight
    // bytes. Option 2 (flags) has four bytes: 1 inbound, 2 outbound.
    const std::string heard =
        "06000000 3C000000 00000000 00000000 41420F00 10000000 10000000 00000603 08 000000 4000100000000000"
        "0200 0400 01000000 00000000 3C000000";
    const std::string own =
        "06000000 3C000000 00000000 00000000 42420F00 10000000 10000000 00000703 01 000000 0000000000000000"
        "0200 0400 02000000 00000000 3C000000";
    EXPECT_EQ(written(LogFormat::pcapng), bytes(section + " " + interface + " " + heard + " " + own));
}

TEST(FrameLog, PcapHasAHeaderAndPackets) {
    // version 2.4, no time zone, no accuracy, at most 65,535 bytes (FFFFh), link type 227 (E3h)
    const std::string header = "D4C3B2A1 0200 0400 00000000 00000000 FFFF0000 E3000000";
    // time stamp 1 s and 1 us; 16 bytes captured of 16, as in a pcapng packet
    const std::string heard = "01000000 01000000 10000000 10000000 00000603 08 000000 4000100000000000";
    const std::string own = "01000000 02000000 10000000 10000000 00000703 01 000000 0000000000000000";
    EXPECT_EQ(written(LogFormat::pcap), bytes(header + " " + heard + " " + own));
}

TEST(FrameLog, PcapngLogMarksExtendedAndRemoteFrames) {
    std::ostringstream out;
    FrameLog log{&out, LogFormat::pcapng};
    log.write({Instant{}, "can0", parse_frame("1FFFFFFF#", "test")}, false);
    log.write({Instant{}, "can0", parse_frame("703#R8", "test")}, false);
    EXPECT_EQ(out.str().substr(28, 8), bytes("9FFFFFFF 00 000000"));
    EXPECT_EQ(out.str().substr(60 + 28, 16), bytes("40000703 08 000000 0000000000000000"));
}

}  // namespace canproof::host
