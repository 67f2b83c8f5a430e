// SPDX-License-Identifier: Apache-2.0
// Tests that bytes from a firmware image are refused if they are no message of the protocol.
#include "host/sim/image/image_link.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "host/base/input_error.hpp"
#include "host/sim/image/start_image.hpp"
#include "tests/host/sim/image/bridged_image.hpp"

namespace canproof::host::test {

namespace {

using bridge::Kind;
using bridge::Message;

/// Sends bytes that a Channel would never send.
ImageLink saying(const std::string& bytes) {
    Pipe to = make_pipe();
    Pipe from = make_pipe();
    EXPECT_EQ(write(from.writes.number(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    return ImageLink{std::move(to.writes), std::move(from.reads), "box.elf"};
}

std::string why(ImageLink link) {
    try {
        static_cast<void>(link.greeting());
    } catch (const ImageFailed& failed) {
        return failed.what();
    }
    return "";
}

}  // namespace

TEST(ImageMessage, MessageReturnsTheValuesThatWereWritten) {
    Message sent{Kind::receive};
    sent.put(std::uint16_t{0x1234U});
    sent.put(-2.5);
    Frame frame = data_frame(0x603U, 2U);
    frame.remote = true;
    frame.data = {1, 2, 3, 4, 5, 6, 7, 8};
    sent.put_frame(frame);
    const ByteView bytes = sent.sent();
    // After the head the message has 1 byte for the kind, 2 for the integer, 8 for the double, 14 for the frame.
    ASSERT_EQ(bytes.size(), Message::head + 1U + 2U + 8U + 14U);
    EXPECT_EQ(bytes[0], 25U);
    EXPECT_EQ(bytes[3], 0x34U);

    Message received;
    std::copy_n(bytes.data(), bytes.size(), received.buffer());
    received.filled();
    EXPECT_EQ(received.kind(), Kind::receive);
    EXPECT_EQ(received.take<std::uint16_t>(), 0x1234U);
    EXPECT_EQ(received.take<double>(), -2.5);
    const Frame got = received.take_frame();
    EXPECT_EQ(got.id, 0x603U);
    EXPECT_TRUE(got.remote);
    EXPECT_FALSE(got.extended);
    EXPECT_EQ(got.length, 2U);
    EXPECT_EQ(got.data, frame.data);
    EXPECT_TRUE(received.is_sound());
}

TEST(ImageMessage, ReadOrWritePastTheEndMakesTheMessageInvalid) {
    Message full{Kind::state};
    for (std::size_t i = 0; i < Message::capacity - Message::head - 1U; ++i) {
        full.put(std::uint8_t{0U});
    }
    EXPECT_TRUE(full.is_sound());
    full.put(std::uint8_t{0U});
    EXPECT_FALSE(full.is_sound());

    Message empty{Kind::commit};
    empty.filled();
    EXPECT_FALSE(empty.is_sound());  // the length of a message that was never sent is 0
    empty = Message{Kind::commit};
    static_cast<void>(empty.sent());
    empty.filled();
    EXPECT_TRUE(empty.is_sound());
    EXPECT_EQ(empty.take<std::uint32_t>(), 0U);
    EXPECT_FALSE(empty.is_sound());
}

TEST(ImageLink, InvalidGreetingOfAFirmwareImageIsRefused) {
    const std::string misunderstood =
        "box.elf sent a message that this program does not understand; build both from the same sources";
    EXPECT_EQ(why(saying(std::string{"\x01\x00\x01", 3})), misunderstood);      // a state, not a greeting
    EXPECT_EQ(why(saying(std::string{"\x05\x00\x00XXXX", 7})), misunderstood);  // greeting of another protocol
    // a greeting that announces a name of 9 characters, which does not follow
    EXPECT_EQ(why(saying(std::string{"\x08\x00\x00"
                                     "CBP1\x01\x01\x09",
                                     10})),
              misunderstood);
    EXPECT_EQ(why(saying(std::string{"\xff\xff", 2})), misunderstood);  // longer than any message
    EXPECT_EQ(why(saying(std::string{"\x00\x00", 2})), misunderstood);  // a message without a kind
}

TEST(ImageLink, EndOfTheFirmwareImageProgramIsReported) {
    EXPECT_EQ(why(saying("")), "box.elf has ended; see the messages of the emulator");
    EXPECT_EQ(why(saying("\x05")), "box.elf has ended; see the messages of the emulator");
    ImageLink link = saying("");
    Message message{Kind::look};
    EXPECT_THROW(link.send(message), ImageFailed);
}

TEST(StartImage, MissingImageFileIsRefused) {
    EXPECT_THROW(static_cast<void>(start_image("no/such/image.elf")), InputError);
}

}  // namespace canproof::host::test
