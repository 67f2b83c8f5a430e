// SPDX-License-Identifier: Apache-2.0
// Tests how frames are described in words. The expected meaning of the bytes is written by hand from CiA 301 (7.2), CiA
// 305 and the manuals of the devices.
#include "host/sim/decode/decode_frame.hpp"

#include <gtest/gtest.h>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/selection/built_in.hpp"
#include "host/selection/chosen_devices.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host::test {

namespace {

/// An AX188001 with node-ID 2 and a CAN-CBX-AO412 with node-ID 3, both just powered on.
class DecodedFrame : public testing::Test {
  protected:
    DecodedFrame() : scanner_{choose_device("ax188001@2")}, outputs_{choose_device("cbx-ao412@3")} {
        scanner_.device->power_on(Instant{});
        outputs_.device->power_on(Instant{});
        nodes_ = {{"scanner", 2U, scanner_.part, scanner_.device->objects()},
                  {"outputs", 3U, outputs_.part, outputs_.device->objects()}};
    }

    FrameWords decode(const std::string& frame) const {
        return FrameDecoder{built_in_register()}.decode(parse_frame(frame, "test"), nodes_);
    }
    /// Returns the meaning of a frame as `service node: text`.
    std::string words(const std::string& frame) const {
        const FrameWords all = decode(frame);
        return std::string{service_word(all.service)} + " " + all.node + ": " + all.text;
    }

    ChosenDevice scanner_;
    ChosenDevice outputs_;
    std::vector<KnownNode> nodes_;
};

}  // namespace

TEST_F(DecodedFrame, NmtFrameIsDecodedToCommandAndNode) {
    EXPECT_EQ(words("000#0100"), "NMT : all nodes: start");
    EXPECT_EQ(words("000#0203"), "NMT : outputs: stop");
    EXPECT_EQ(words("000#8005"), "NMT : node 5: enter pre operational");
    EXPECT_EQ(words("000#8102"), "NMT : scanner: reset node");
    EXPECT_EQ(words("000#0300"), "NMT : all nodes: unknown command 3");
    EXPECT_EQ(words("000#01"), "NMT : no command: two bytes are needed");
}

TEST_F(DecodedFrame, ErrorControlFrameIsDecodedToBootUpStateAndToggle) {
    EXPECT_EQ(words("702#00"), "guard scanner: boot-up");
    EXPECT_EQ(words("703#05"), "guard outputs: operational");
    EXPECT_EQ(words("703#FF"), "guard outputs: pre operational, toggle 1");
    EXPECT_EQ(words("703#R"), "guard outputs: guarding request");
    EXPECT_EQ(words("710#04"), "guard node 16: stopped");
    EXPECT_EQ(words("703#06"), "guard outputs: unknown state 6");
    EXPECT_EQ(words("703#0500"), "guard outputs: malformed: one byte is needed");
}

TEST_F(DecodedFrame, SdoFrameIsDecodedToObjectAndTypedValue) {
    EXPECT_EQ(words("602#4020400100000000"), "SDO scanner: read 4020h:1 TC 1 High Shutdown Threshold");
    // 2500 tenths of a degree are 09C4h.
    EXPECT_EQ(words("582#4B204001C4090000"), "SDO scanner: answers 4020h:1 TC 1 High Shutdown Threshold = 2500");
    // −20.0 °C as shipped is FF38h.
    EXPECT_EQ(words("582#4B00400138FF0000"), "SDO scanner: answers 4000h:1 TC 1 Low Warning Threshold = -200");
    EXPECT_EQ(words("602#2B30400100000000"), "SDO scanner: write 4030h:1 TC 1 Error React Delay = 0");
    EXPECT_EQ(words("582#6030400100000000"), "SDO scanner: has written 4030h:1 TC 1 Error React Delay");
    // 25.0 as a REAL32 is 41C80000h.
    EXPECT_EQ(words("582#430061010000C841"), "SDO scanner: answers 6100h:1 TC 1 Input Field Value = 25");
}

TEST_F(DecodedFrame, SdoAbortIsDecodedToItsMeaning) {
    EXPECT_EQ(words("582#8034120000000206"), "SDO scanner: abort 1234h:0: 06020000h object missing");
    EXPECT_EQ(words("582#8034120078563412"), "SDO scanner: abort 1234h:0: 12345678h unknown reason");
}

TEST_F(DecodedFrame, SdoSegmentsAndBlocksAreDecoded) {
    EXPECT_EQ(words("583#4108100010000000"),
              "SDO outputs: answers 1008h Manufacturer Device Name, 16 bytes in segments");
    EXPECT_EQ(words("603#6000000000000000"), "SDO outputs: read next segment");
    // Five of the seven bytes are unused, and no segment follows.
    EXPECT_EQ(words("583#0B41420000000000"), "SDO outputs: answers last segment: 41 42");
    EXPECT_EQ(words("603#A408100020000000"), "SDO outputs: read 1008h Manufacturer Device Name in blocks");
    EXPECT_EQ(words("602#40"), "SDO scanner: malformed: eight bytes are needed");
    EXPECT_EQ(words("602#E000000000000000"), "SDO scanner: unknown command E0 00 00 00 00 00 00 00");
}

TEST_F(DecodedFrame, EmcyIsDecodedToTheErrorOfTheDevice) {
    // AX188001 manual, 3.2.4: code, register, channel, description 40h.
    EXPECT_EQ(words("082#11F0010140000000"),
              "EMCY scanner: F011h limit exceeded, channel 1, positive shutdown, error register 01h");
    EXPECT_EQ(words("082#0000000000000000"), "EMCY scanner: 0000h no error, error register 00h");
}

TEST_F(DecodedFrame, EmcyOfAnUnknownErrorIsDecodedToItsClassOfCia301) {
    EXPECT_EQ(words("083#3081110100000000"),
              "EMCY outputs: 8130h life guard or heartbeat error, error register 11h, details 01 00 00 00 00");
    EXPECT_EQ(words("085#0133040000000000"), "EMCY node 5: 3301h output voltage, error register 04h");
}

TEST_F(DecodedFrame, PdoIsDecodedToItsMappedObjects) {
    // AX188001 manual, 3.2.15: TPDO1 contains 7130h:1 and 7130h:2; 12A0h is 4768, 12D0h is 4816.
    EXPECT_EQ(words("182#A012D012"),
              "PDO scanner: TPDO 1: TC 1 Input Process Value = 4768, TC 2 Input Process Value = 4816");
    EXPECT_EQ(words("182#R"), "PDO scanner: TPDO 1: asked for");
}

TEST_F(DecodedFrame, FrameOfAnInvalidPdoIsDecodedAsOther) {
    EXPECT_EQ(words("282#0102"), "other : 01 02");  // TPDO2 is not valid as shipped
}

TEST_F(DecodedFrame, SyncTimeAndOtherFramesAreRecognised) {
    EXPECT_EQ(words("080#"), "SYNC : SYNC");
    EXPECT_EQ(words("080#07"), "SYNC : SYNC, counter 7");
    EXPECT_EQ(decode("100#000000000000").service, FrameService::time);
    EXPECT_EQ(words("12345678#AB"), "other : 29-bit identifier; AB");
}

TEST_F(DecodedFrame, LssFrameIsDecodedToItsCommand) {
    EXPECT_EQ(words("7E5#0401000000000000"), "LSS : switch state global: 01 00 00 00 00 00 00");
    EXPECT_EQ(words("7E4#1100000000000000"), "LSS : configure node id (answer)");
    EXPECT_EQ(words("7E4#4400000000000000"), "LSS : selected (answer)");
}

TEST_F(DecodedFrame, EveryBaseIdentifierIsDecodedAtEveryLength) {
    for (std::uint32_t id = 0; id <= 0x7FFU; ++id) {
        for (std::uint8_t length = 0; length <= 8U; ++length) {
            Frame frame = data_frame(id, length);
            frame.data.fill(0xFFU);
            const FrameWords all = FrameDecoder{built_in_register()}.decode(frame, nodes_);
            ASSERT_TRUE(!all.text.empty() || length == 0U) << std::hex << id;
        }
    }
}

}  // namespace canproof::host::test
