// SPDX-License-Identifier: Apache-2.0
// Tests views of bytes, which cannot be read or written beyond their end (firmware/base/bytes.hpp).
#include "firmware/base/bytes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "firmware/base/slots.hpp"
#include "firmware/canopen/pdo_mapping.hpp"
#include "tests/support/shows_rule.hpp"

namespace canproof::test {

TEST(Bytes, BytesBeyondTheEndOfAViewReadAsZeroAndAreNotWritten) {
    shows_rule("views of bytes cannot overrun");
    std::array<std::uint8_t, 6> room{{9, 9, 9, 9, 9, 9}};
    MutableBytes first_four{room.data(), 4U};
    EXPECT_EQ(first_four[3], 9U);
    EXPECT_EQ(first_four[4], 0U);
    first_four.set(3U, 1U);
    first_four.set(4U, 1U);
    EXPECT_EQ(room[3], 1U);
    EXPECT_EQ(room[4], 9U);
    EXPECT_EQ(first_four.view()[4], 0U);
}

TEST(Bytes, NumbersThatDoNotFitLoseTheirHighBytes) {
    shows_rule("views of bytes cannot overrun");
    std::array<std::uint8_t, 6> room{};
    MutableBytes first_four{room.data(), 4U};
    first_four.set_le(2U, 4U, 0x44332211U);
    EXPECT_EQ(room, (std::array<std::uint8_t, 6>{{0, 0, 0x11, 0x22, 0, 0}}));
    first_four.set_le(4U, 2U, 0xFFFFU);
    EXPECT_EQ(room, (std::array<std::uint8_t, 6>{{0, 0, 0x11, 0x22, 0, 0}}));
}

TEST(Bytes, PartOfANumberBeyondTheEndOfAViewReadsAsZeroAndIsNotWritten) {
    shows_rule("views of bytes cannot overrun");
    std::array<std::uint8_t, 8> room{{1, 2, 3, 4, 5, 6, 7, 8}};
    MutableBytes first_four{room.data(), 4U};
    EXPECT_EQ(get_le<2U>(first_four.view(), 2U), 0x0403U);
    EXPECT_EQ(get_le<2U>(first_four.view(), 3U), 0x04U);
    EXPECT_EQ(get_le<2U>(first_four.view(), 5U), 0U);
    first_four.put_le<2U>(5U, 0xFFFFU);
    EXPECT_EQ(room, (std::array<std::uint8_t, 8>{{1, 2, 3, 4, 5, 6, 7, 8}}));
    first_four.put_le<2U>(3U, 0xAABBU);
    EXPECT_EQ(room, (std::array<std::uint8_t, 8>{{1, 2, 3, 0xBB, 5, 6, 7, 8}}));
    first_four.put_le<2U>(0U, 0xAABBU);
    EXPECT_EQ(room, (std::array<std::uint8_t, 8>{{0xBB, 0xAA, 3, 0xBB, 5, 6, 7, 8}}));
}

TEST(Bytes, ExchangeReturnsWhetherItHasChangedAnyByte) {
    shows_rule("a value that stays is no change");
    for (std::size_t count = 0; count <= 8; ++count) {
        std::array<std::uint8_t, 10> room{{9, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
        MutableBytes view{room};
        const std::uint64_t present = read_le(view.view(), 1U, count);
        EXPECT_FALSE(view.exchange_le(1U, count, present)) << count;
        for (std::size_t changed = 0; changed < count; ++changed) {
            const std::uint64_t wanted = present ^ (std::uint64_t{0x80} << (8U * changed));
            EXPECT_TRUE(view.exchange_le(1U, count, wanted)) << count << ' ' << changed;
            EXPECT_EQ(read_le(view.view(), 1U, count), wanted);
            EXPECT_TRUE(view.exchange_le(1U, count, present)) << count << ' ' << changed;
        }
        EXPECT_EQ(room, (std::array<std::uint8_t, 10>{{9, 1, 2, 3, 4, 5, 6, 7, 8, 9}}));
    }
}

TEST(Bytes, ExchangeAcrossTheEndOfAViewWritesTheBytesThatFit) {
    shows_rule("views of bytes cannot overrun");
    std::array<std::uint8_t, 6> room{{1, 2, 3, 4, 5, 6}};
    MutableBytes first_four{room.data(), 4U};
    EXPECT_TRUE(first_four.exchange_le(2U, 4U, 0x44332211U));
    EXPECT_EQ(room, (std::array<std::uint8_t, 6>{{1, 2, 0x11, 0x22, 5, 6}}));
    EXPECT_FALSE(first_four.exchange_le(2U, 4U, 0x2211U));
}

TEST(Bytes, OffsetPlusLengthThatOverflowsCountsAsBeyondTheEndOfAView) {
    shows_rule("views of bytes cannot overrun");
    constexpr std::size_t highest = std::numeric_limits<std::size_t>::max();
    const std::array<std::uint8_t, 8> before{{1, 2, 3, 4, 5, 6, 7, 8}};
    for (std::size_t count = 0; count <= 8; ++count) {
        for (std::size_t below = 0; below <= 8; ++below) {
            std::array<std::uint8_t, 8> room{before};
            MutableBytes view{room};
            view.set_le(highest - below, count, 0xFFFFFFFFFFFFFFFFU);
            write_le(view, highest - below, count, 0xFFFFFFFFFFFFFFFFU);
            view.put_le<8U>(highest - below, 0xFFFFFFFFFFFFFFFFU);
            const std::uint64_t ones = (count == 8U) ? 0xFFFFFFFFFFFFFFFFU : ((std::uint64_t{1} << (8U * count)) - 1U);
            static_cast<void>(view.exchange_le(highest - below, count, ones));
            EXPECT_EQ(room, before) << count << " bytes at the highest place less " << below;
            EXPECT_EQ(read_le(view.view(), highest - below, count), 0U) << count << ' ' << below;
            EXPECT_EQ(get_le<8U>(view.view(), highest - below), 0U) << below;
        }
    }
}

TEST(Bytes, CopyEndsAtTheEndOfTheTarget) {
    shows_rule("views of bytes cannot overrun");
    const std::array<std::uint8_t, 4> source{{1, 2, 3, 4}};
    std::array<std::uint8_t, 6> room{};
    MutableBytes first_four{room.data(), 4U};
    first_four.copy(2U, ByteView{source});
    EXPECT_EQ(room, (std::array<std::uint8_t, 6>{{0, 0, 1, 2, 0, 0}}));
    first_four.copy(5U, ByteView{source});  // copies nothing: position 5 is beyond the end
    first_four.copy(1U, ByteView{source});  // three bytes fit: only 1, 2 and 3 are copied
    EXPECT_EQ(room, (std::array<std::uint8_t, 6>{{0, 1, 2, 3, 0, 0}}));
    first_four.copy(0U, ByteView{source});
    EXPECT_EQ(room, (std::array<std::uint8_t, 6>{{1, 2, 3, 4, 0, 0}}));
    first_four.copy(0U, ByteView{source.data() + 3, 1U});
    EXPECT_EQ(room, (std::array<std::uint8_t, 6>{{4, 2, 3, 4, 0, 0}}));
}

TEST(Bytes, PartOfAViewEndsAtTheEndOfTheView) {
    shows_rule("views of bytes cannot overrun");
    std::array<std::uint8_t, 8> room{{1, 2, 3, 4, 5, 6, 7, 8}};
    const ByteView four{room.data(), 4U};
    MutableBytes open_four{room.data(), 4U};
    EXPECT_EQ(four.part(1U, 2U).size(), 2U);
    EXPECT_EQ(four.part(3U, 2U).size(), 1U);
    EXPECT_EQ(four.part(3U, 2U)[0], 4U);
    EXPECT_EQ(four.part(4U, 2U).size(), 0U);
    EXPECT_EQ(four.part(6U, 2U).size(), 0U);
    EXPECT_EQ(open_four.part(1U, 2U).size(), 2U);
    EXPECT_EQ(open_four.part(1U, 3U).size(), 3U);
    EXPECT_EQ(open_four.part(1U, 4U).size(), 3U);
    EXPECT_EQ(open_four.part(6U, 2U).size(), 0U);
}

TEST(Bytes, NumberReadAcrossTheEndOfAViewHasZerosBeyondTheEnd) {
    shows_rule("views of bytes cannot overrun");
    const std::array<std::uint8_t, 8> room{{0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88}};
    const ByteView four{room.data(), 4U};
    EXPECT_EQ(get_le<4U>(four, 0U), 0x44332211U);
    EXPECT_EQ(get_le<4U>(four, 2U), 0x4433U);
    EXPECT_EQ(get_le<2U>(four, 3U), 0x44U);
    EXPECT_EQ(get_le<2U>(four, 4U), 0U);
    EXPECT_EQ(get_le<2U>(four, 6U), 0U);
    for (const std::size_t count : {std::size_t{1U}, std::size_t{2U}, std::size_t{3U}, std::size_t{4U}}) {
        EXPECT_EQ(read_le(four, 5U, count), 0U);  // starts beyond the end
    }
    EXPECT_EQ(read_le(four, 3U, 2U), 0x44U);
}

TEST(Bytes, NumberIsWrittenToTheGivenCountOfBytesAndNotBeyondTheEndOfTheView) {
    shows_rule("views of bytes cannot overrun");
    std::array<std::uint8_t, 8> room{{9, 9, 9, 9, 9, 9, 9, 9}};
    MutableBytes six{room.data(), 6U};
    six.set_le(0U, 3U, 0x44332211U);
    EXPECT_EQ(room, (std::array<std::uint8_t, 8>{{0x11, 0x22, 0x33, 9, 9, 9, 9, 9}}));
    six.put_le<2U>(7U, 0xFFFFU);  // starts beyond the end
    for (const std::size_t count : {std::size_t{1U}, std::size_t{2U}, std::size_t{3U}, std::size_t{4U}}) {
        six.set_le(7U, count, 0xFFFFFFFFU);
    }
    EXPECT_EQ(room, (std::array<std::uint8_t, 8>{{0x11, 0x22, 0x33, 9, 9, 9, 9, 9}}));
}

namespace {

constexpr std::size_t room_size = 18;  // a view of the first 8 bytes or fewer; the bytes after it must not change
using Room = std::array<std::uint8_t, room_size>;

constexpr Room numbered() {
    return {{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18}};
}

/// Returns the bytes that must result when `value` is written to `at` byte by byte; bytes beyond the first `size` stay
/// unchanged.
Room written(std::size_t size, std::size_t at, std::size_t count, std::uint64_t value) {
    Room room = numbered();
    for (std::size_t i = 0; i < count && at + i < size; ++i) {
        room.at(at + i) = static_cast<std::uint8_t>(value >> (8 * i));
    }
    return room;
}
std::uint64_t number(std::size_t size, std::size_t at, std::size_t count) {
    const Room room = numbered();
    std::uint64_t value{0};
    for (std::size_t i = 0; i < count && at + i < size; ++i) {
        value |= std::uint64_t{room.at(at + i)} << (8 * i);
    }
    return value;
}

/// Reads and writes `N` bytes at `at` in a view of `size` bytes. Expects the results of access byte by byte.
template <std::size_t N>
void expect_bytes(std::size_t size, std::size_t at, std::uint64_t value) {
    Room room = numbered();
    MutableBytes view{room.data(), size};
    EXPECT_EQ(read_le(view.view(), at, N), number(size, at, N)) << size << ' ' << at << ' ' << N;
    view.set_le(at, N, value);
    EXPECT_EQ(room, written(size, at, N, value)) << size << ' ' << at << ' ' << N << ' ' << value;
    if constexpr (N > 0) {
        room = numbered();
        EXPECT_EQ(get_le<N>(view.view(), at), number(size, at, N)) << size << ' ' << at << ' ' << N;
        view.put_le<N>(at, value);
        EXPECT_EQ(room, written(size, at, N, value)) << size << ' ' << at << ' ' << N << ' ' << value;
    }
}

}  // namespace

TEST(Bytes, NumberAccessEqualsByteByByteAccessAtEveryOffset) {
    shows_rule("views of bytes cannot overrun");
    for (std::size_t size = 0; size <= 8; ++size) {
        for (std::size_t at = 0; at <= size + 1; ++at) {
            for (const std::uint64_t value : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{0xFFEEDDCCBBAA9988}}) {
                expect_bytes<0>(size, at, value);
                expect_bytes<1>(size, at, value);
                expect_bytes<2>(size, at, value);
                expect_bytes<3>(size, at, value);
                expect_bytes<4>(size, at, value);
                expect_bytes<7>(size, at, value);
                expect_bytes<8>(size, at, value);
            }
        }
    }
}

TEST(Slots, PartOfAViewOfArrayElementsEndsAtTheEndOfTheView) {
    shows_rule("views of bytes cannot overrun");
    std::array<PdoLine, 6> room{};
    const Slots<PdoLine> four{room.data(), 4U};
    EXPECT_EQ(four.part(1U, 2U).size(), 2U);
    EXPECT_EQ(four.part(1U, 3U).size(), 3U);
    EXPECT_EQ(four.part(3U, 3U).size(), 1U);
    EXPECT_EQ(&four.part(3U, 3U)[0U], &room[3]);
    EXPECT_EQ(four.part(5U, 1U).size(), 0U);
    EXPECT_EQ(four.part(0U, 6U).size(), 4U);
    EXPECT_EQ(four.part(2U, 1U).size(), 1U);
}

}  // namespace canproof::test
