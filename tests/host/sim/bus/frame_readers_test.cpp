// SPDX-License-Identifier: Apache-2.0
// The readers that receive a frame, by exact identifier and by wider filters.
#include "host/sim/bus/frame_readers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/sim/bus/candump.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Frame frame_of(const char* text) {
    return parse_frame(text, "test");
}

}  // namespace

TEST(FrameReaders, ReadersOfAnIdentifierAreListedInAscendingOrder) {
    FrameReaders readers;
    readers.set(7, {{0x080, 0x7FF, false}, {0x205, 0x7FF, false}});
    readers.set(2, {{0x080, 0x7FF, false}});
    readers.set(9, {{0x206, 0x7FF, false}});
    EXPECT_THAT(readers.of(frame_of("080#")), ElementsAre(2U, 7U));
    EXPECT_THAT(readers.of(frame_of("205#00")), ElementsAre(7U));
    EXPECT_THAT(readers.of(frame_of("205#R")), ElementsAre(7U));
    EXPECT_THAT(readers.of(frame_of("207#")), IsEmpty());
}

TEST(FrameReaders, BaseAndExtendedIdentifiersAreSeparate) {
    FrameReaders readers;
    readers.set(1, {{0x205, 0x7FF, false}});
    readers.set(2, {{0x205, 0x1FFFFFFF, true}});
    EXPECT_THAT(readers.of(frame_of("205#")), ElementsAre(1U));
    EXPECT_THAT(readers.of(frame_of("00000205#")), ElementsAre(2U));
}

TEST(FrameReaders, ReaderIsListedOnceForEachIdentifierOfItsFilters) {
    FrameReaders readers;
    readers.set(3, accept_everything());
    readers.set(1, {{0x700, 0x780, false}, {0x705, 0x7FF, false}});  // 700h to 77Fh, and 705h a second time
    EXPECT_THAT(readers.of(frame_of("705#05")), ElementsAre(1U, 3U));
    EXPECT_THAT(readers.of(frame_of("77F#05")), ElementsAre(1U, 3U));
    EXPECT_THAT(readers.of(frame_of("780#05")), ElementsAre(3U));
    EXPECT_THAT(readers.of(frame_of("1FFFFFFF#05")), ElementsAre(3U));
}

TEST(FrameReaders, NewFiltersReplaceOnlyTheOldFiltersOfTheirReader) {
    FrameReaders readers;
    readers.set(1, {{0x205, 0x7FF, false}, {0x700, 0x780, false}});
    readers.set(2, {{0x205, 0x7FF, false}});
    readers.set(1, {{0x206, 0x7FF, false}});
    EXPECT_THAT(readers.of(frame_of("205#")), ElementsAre(2U));
    EXPECT_THAT(readers.of(frame_of("206#")), ElementsAre(1U));
    EXPECT_THAT(readers.of(frame_of("705#")), IsEmpty());
    readers.set(1, {});
    EXPECT_THAT(readers.of(frame_of("206#")), IsEmpty());
}

TEST(FrameReaders, ExtendedIdentifiersAreDistinguished) {
    FrameReaders readers;
    readers.set(2, {{0x205, 0x1FFFFFFF, true}});
    EXPECT_THAT(readers.of(frame_of("00000206#")), IsEmpty());
    EXPECT_THAT(readers.of(frame_of("000#")), IsEmpty());
}

TEST(FrameReaders, ExtendedFilterWithAn11BitMaskAcceptsSeveralIdentifiers) {
    FrameReaders readers;
    readers.set(1, {{0x705, 0x7FF, true}});
    // the filter compares the lowest 11 bits, which are 705h
    EXPECT_THAT(readers.of(frame_of("1FFFFF05#")), ElementsAre(1U));
    EXPECT_THAT(readers.of(frame_of("1FFFFF06#")), IsEmpty());
    EXPECT_THAT(readers.of(frame_of("705#")), IsEmpty());
}

TEST(FrameReaders, FilterComparesOnlyTheBitsOfItsMask) {
    FrameReaders readers;
    readers.set(1, {{0x7FF, 0x700, false}});
    readers.set(2, {{0xF05, 0x7FF, false}});  // bit 11 is outside the mask
    EXPECT_THAT(readers.of(frame_of("701#")), ElementsAre(1U));
    EXPECT_THAT(readers.of(frame_of("705#")), ElementsAre(1U, 2U));
    readers.set(2, {});
    EXPECT_THAT(readers.of(frame_of("705#")), ElementsAre(1U));
}

TEST(FrameReaders, RemovedFiltersCanBeSetAgain) {
    FrameReaders readers;
    for (int i = 0; i < 2; ++i) {
        readers.set(1, {{0x205, 0x7FF, false}, {0x205, 0x7FF, false}});  // a filter may be listed twice
        EXPECT_THAT(readers.of(frame_of("205#")), ElementsAre(1U)) << i;
        readers.set(1, {});
        EXPECT_THAT(readers.of(frame_of("205#")), IsEmpty()) << i;
    }
}

TEST(FrameReaders, OnlyFiltersForSeveralIdentifiersAreComparedWithEachFrame) {
    FrameReaders readers;
    readers.set(1, {{0x205, 0x7FF, false}, {0x206, 0x7FF, false}, {0x205, 0x1FFFFFFF, true}});
    EXPECT_EQ(readers.compared(), 0U);
    readers.set(2, {{0x205, 0x7FF, false}, {0x205, 0x7FF, true}, {0x200, 0x780, false}});
    EXPECT_EQ(readers.compared(), 2U);
    readers.set(2, {{0x200, 0x780, false}});
    EXPECT_EQ(readers.compared(), 1U);
    readers.set(2, {});
    EXPECT_EQ(readers.compared(), 0U);
}

TEST(FrameReaders, NothingIsKeptOfRemovedReaders) {
    FrameReaders readers;
    readers.set(1, {{0x205, 0x7FF, false}, {0x206, 0x7FF, false}});
    readers.set(2, {{0x205, 0x7FF, false}, {0x700, 0x780, false}});
    EXPECT_EQ(readers.kept(), 4U);  // two readers, two identifiers
    readers.set(1, {{0x205, 0x7FF, false}});
    EXPECT_EQ(readers.kept(), 3U);
    readers.set(1, {});
    EXPECT_EQ(readers.kept(), 2U);
    readers.set(2, {});
    EXPECT_EQ(readers.kept(), 0U);
    readers.set(3, {});
    EXPECT_EQ(readers.kept(), 0U);
}

}  // namespace canproof::host::test
