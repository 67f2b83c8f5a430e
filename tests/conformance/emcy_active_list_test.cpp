// SPDX-License-Identifier: Apache-2.0
// Tests the error list of the Axiomatic devices, which contains the active errors, each with description and channel
// (AX188001, 3.2.4).
#include "generated/canopen/requirements.hpp"
#include "tests/support/shows_rule.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// An object dictionary whose 1003h lists active errors, with its own EMCY service. There are two errors, one for each
/// of two channels.
class ActiveList : public testing::Test {
  protected:
    static constexpr ErrorId channel_1 = ErrorId::first_of_device;
    static constexpr ErrorId channel_2 = error_after(ErrorId::first_of_device, 1);

    ActiveList() {
        // AX188001 Tables 5 and 6: F001h (open circuit) has description 0 on channel 1, F011h (limit) has description
        // 10h on channel 2.
        errors[static_cast<std::size_t>(channel_1)] = ErrorRow{0xF001, 0x81, true, true, 0x0001};
        errors[static_cast<std::size_t>(channel_2)] = ErrorRow{0xF011, 0x81, true, true, 0x1002};
        errors[static_cast<std::size_t>(ErrorId::heartbeat_1)] = ErrorRow{0x8130, 0x11, true, true, 0x8000};
        objects.load_defaults(ParameterGroup::communication, 5);
        emcy.reset();
        emcy.enable(true, Instant{});
    }
    Frames sent() {
        Frames all;
        while (!queue.empty()) {
            all.push_back(host::format_frame(queue.pop()));
        }
        return all;
    }
    std::vector<std::uint32_t> listed() const {
        std::vector<std::uint32_t> all;
        for (std::uint8_t sub = 1; sub <= objects.read(0x1003, 0); ++sub) {
            all.push_back(objects.read(0x1003, sub));
        }
        return all;
    }

    host::DictionaryRows rows{slave().rows};
    DictionaryTables tables{rows.tables()};
    std::vector<std::uint8_t> image = std::vector<std::uint8_t>(rows.layout.image.size());
    ObjectDictionary objects{tables, MutableBytes{image.data(), image.size()}, LimitAbort::high_low};
    TransmitQueue queue;
    ErrorTable errors{};
    Emcy emcy{objects, queue, errors, ErrorList::active, EmcyContent::detail};
};

}  // namespace

TEST_F(ActiveList, EndOfAnErrorRemovesItFromTheErrorListAndTheOthersMoveUp) {
    verifies<req::CO_EMCY_007>();
    emcy.set(channel_1, true, Instant{});
    emcy.set(channel_2, true, Instant{});
    emcy.set(ErrorId::heartbeat_1, true, Instant{}, 0x31);
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x80318130, 0x1002F011, 0x0001F001}));
    emcy.set(channel_2, false, Instant{});
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x80318130, 0x0001F001}));
    EXPECT_EQ(objects.read(0x1003, 3), 0U);
    emcy.set(channel_1, false, Instant{});
    emcy.set(ErrorId::heartbeat_1, false, Instant{});
    EXPECT_TRUE(listed().empty());
}

TEST_F(ActiveList, DetailsOfAnErrorAreInTheErrorListAndInTheEmcyMessage) {
    verifies<req::CO_EMCY_008, req::CO_EMCY_023, req::CO_EMCY_033>();
    emcy.set(channel_2, true, Instant{});
    EXPECT_EQ(sent(), Frames{"085#11F0810210000000"});
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x1002F011}));  // description 10h, channel 02h
    emcy.set(ErrorId::heartbeat_1, true, Instant{}, 0x31);
    EXPECT_EQ(sent(), Frames{"085#3081913180000000"});  // 1001h (error register) is 81h | 11h = 91h
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x80318130, 0x1002F011}));
    emcy.set(channel_2, false, Instant{});
    EXPECT_EQ(sent(), Frames{"085#0000110000000000"});
}

TEST_F(ActiveList, ErrorsOfOneCodeAreDistinguishedByTheirChannel) {
    verifies<req::CO_EMCY_007>();
    errors[static_cast<std::size_t>(channel_2)] = ErrorRow{0xF001, 0x81, true, true, 0x0002};
    emcy.set(channel_1, true, Instant{});
    emcy.set(channel_2, true, Instant{});
    emcy.set(channel_1, false, Instant{});
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x0002F001}));
}

TEST_F(ActiveList, WaitingEmcyMessagesOfDifferentErrorsAreKeptApart) {
    verifies<req::CO_EMCY_006, req::CO_EMCY_022>();
    emcy.enable(false, Instant{});
    emcy.set(channel_1, true, Instant{});
    emcy.set(channel_1, false, Instant{});
    emcy.set(channel_2, true, Instant{});
    emcy.set(channel_1, true, Instant{});  // the message about the end of this error, which waits, is dropped
    EXPECT_TRUE(sent().empty());
    emcy.enable(true, Instant{});
    // both errors are active, so 1001h (error register) is 81h
    EXPECT_EQ(sent(), (Frames{"085#01F0810100000000", "085#11F0810210000000"}));
}

TEST_F(ActiveList, EmcyMessageThatWasSentIsNotSentAgain) {
    verifies<req::CO_EMCY_006>();
    for (int round = 0; round < 2; ++round) {
        emcy.enable(false, Instant{});
        emcy.set(channel_1, true, Instant{});
        emcy.set(channel_1, false, Instant{});
        emcy.enable(true, Instant{});
        EXPECT_EQ(sent(), (Frames{"085#01F0000100000000", "085#0000000000000000"}))
            << round;  // the error has ended: 1001h (error register) reads 00h
    }
}

TEST_F(ActiveList, ErrorReportedTwiceWhileItsMessageWaitsIsSentOnce) {
    verifies<req::CO_EMCY_006>();
    emcy.enable(false, Instant{});
    emcy.report(channel_1, Instant{});
    emcy.report(channel_1, Instant{});
    emcy.enable(true, Instant{});
    EXPECT_EQ(sent(), Frames{"085#01F0000100000000"});  // report() reports an error that is over at once: 1001h (error
                                                        // register) is 00h
}

TEST_F(ActiveList, ResetCommunicationKeepsTheListOfActiveErrors) {
    verifies<req::CO_EMCY_011, req::CO_NMT_006>();
    emcy.set(channel_2, true, Instant{});
    emcy.set(channel_1, true, Instant{});  // this error begins later, but has the lower ErrorId
    const std::vector<std::uint32_t> order{0x0001F001, 0x1002F011};
    EXPECT_EQ(listed(), order);
    objects.load_defaults(ParameterGroup::communication, 5);
    emcy.refresh();
    EXPECT_EQ(listed(), order);
    EXPECT_EQ(objects.read(0x1001, 0), 0x81U);
    objects.write(0x1003, 0, 0);
    emcy.after_write(objects.lookup(0x1003, 0));  // the user clears the list
    objects.load_defaults(ParameterGroup::communication, 5);
    emcy.refresh();
    EXPECT_TRUE(listed().empty());
    EXPECT_EQ(objects.read(0x1003, 1), 0U);
    EXPECT_EQ(objects.read(0x1001, 0), 0x81U);
    emcy.set(channel_1, false, Instant{});
    emcy.set(channel_1, true, Instant{});
    EXPECT_EQ(listed(), (std::vector<std::uint32_t>{0x0001F001}));
}

TEST_F(ActiveList, ErrorWithoutACodeIsIgnored) {
    shows_rule("a device is silent about errors that it does not know");
    errors[static_cast<std::size_t>(channel_1)] = ErrorRow{0x0000, 0x81, true, true, 0x0001};
    emcy.set(channel_1, true, Instant{});
    EXPECT_FALSE(emcy.is_active(channel_1));
    emcy.report(channel_1, Instant{});
    EXPECT_TRUE(sent().empty());
    EXPECT_TRUE(listed().empty());
    EXPECT_EQ(objects.read(0x1001, 0), 0U);
}

TEST_F(ActiveList, ErrorRegisterChangeIsReturnedByTheNextQueryAndByNoLaterOne) {
    verifies<req::CO_EMCY_001>();
    emcy.take_register_change();
    emcy.set(channel_1, true, Instant{});
    emcy.set(channel_2, true, Instant{});  // 1001h (error register) keeps the value 81h
    EXPECT_TRUE(emcy.take_register_change());
    EXPECT_FALSE(emcy.take_register_change());
}

TEST_F(ActiveList, ErrorWhoseBitsAreAlreadySetLeavesTheErrorRegisterUnchanged) {
    verifies<req::CO_EMCY_001, req::CO_EMCY_012, req::CO_EMCY_025>();
    emcy.set(channel_1, true, Instant{});
    emcy.take_register_change();
    emcy.set(channel_2, true, Instant{});  // 1001h (error register) is 81h, as after the first error
    EXPECT_FALSE(emcy.take_register_change());
    emcy.set(channel_1, false, Instant{});
    EXPECT_FALSE(emcy.take_register_change());
    emcy.enable(false, Instant{});
    emcy.set(ErrorId::heartbeat_1, true, Instant{});  // 1001h becomes 91h
    emcy.set(channel_1, true, Instant{});
    EXPECT_TRUE(emcy.take_register_change());  // 1001h (error register) has changed, although no message could be sent
}

TEST_F(ActiveList, ResetNodeClearsAnActiveError) {
    verifies<req::CO_EMCY_025>();
    emcy.set(channel_1, true, Instant{});
    sent();
    emcy.reset();
    EXPECT_EQ(objects.read(0x1001, 0), 0U);
    EXPECT_TRUE(emcy.take_register_change());
    emcy.enable(true, Instant{});
    emcy.report(channel_2, Instant{});
    EXPECT_EQ(sent(), Frames{"085#11F0000210000000"});
}

TEST_F(ActiveList, ResetNodeDropsWaitingEmcyMessagesAndEndsTheirInhibitTime) {
    verifies<req::CO_EMCY_003>();
    objects.write(0x1015, 0, 10000);  // 1015h inhibit time EMCY: 1 s
    emcy.set(channel_1, true, Instant{});
    EXPECT_EQ(sent(), Frames{"085#01F0810100000000"});
    emcy.set(channel_1, false, Instant{});
    emcy.reset();
    emcy.enable(true, Instant{});
    EXPECT_EQ(sent(), Frames{});
    emcy.set(channel_2, true, Instant{});
    EXPECT_EQ(sent(), Frames{"085#11F0810210000000"});
}

TEST_F(ActiveList, EmcyMessageThatAFullQueueRefusesIsTriedAgainAfterAMillisecond) {
    verifies<req::CO_EMCY_001>();
    while (queue.push(data_frame(0x701, 1))) {
        // fills the queue
    }
    emcy.set(channel_1, true, Instant{});
    while (!queue.empty()) {
        queue.pop();
    }
    emcy.advance(Instant{999});
    EXPECT_EQ(sent(), Frames{});
    emcy.advance(Instant{1000});
    EXPECT_EQ(sent(), Frames{"085#01F0810100000000"});
}

/// The reset restores the stored value of 1014h (COB-ID EMCY), which disables the messages.
TEST_F(ActiveList, WaitingEmcyMessagesAreDroppedWhenAResetDisablesEmcy) {
    verifies<req::CO_EMCY_002, req::CO_EMCY_011>();
    emcy.enable(false, Instant{});
    emcy.set(channel_1, true, Instant{});
    objects.write(0x1014, 0, 0x80000085);
    emcy.refresh();
    emcy.enable(true, Instant{});
    EXPECT_EQ(sent(), Frames{});
    objects.write(0x1014, 0, 0x85);
    emcy.after_write(objects.lookup(0x1014, 0));
    emcy.advance(Instant{1000000});
    EXPECT_EQ(sent(), Frames{});
}

}  // namespace canproof::test
