// SPDX-License-Identifier: Apache-2.0
// The value of a text in the dictionary ends before its first zero byte (firmware/canopen/object_dictionary.hpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "firmware/canopen/object_dictionary.hpp"
#include "tests/support/shows_rule.hpp"

namespace canproof {
namespace {

constexpr std::size_t capacity = 20U;  // the text is compared in two groups of eight bytes and one of four

/// 2000h:0, a text. With the hash factor 1 << 16, index i is in slot i & 1.
struct TextDictionary {
    std::array<ObjectRow, 1> rows{{{0x2000U, 0U, 1U, ObjectKind::var}}};
    std::array<EntryRow, 1> entries{
        {{0U, capacity, no_limit, 0U, DataType::visible_string, rights::read, Service::none}}};
    std::array<std::uint16_t, 2> slots{{0U, no_object}};
    DictionaryTables tables{table_view(rows), table_view(entries), {}, {}, {}, {}, 0U, table_view(slots), 0x10000U};
    std::array<std::uint8_t, capacity> image{};
    ObjectDictionary objects{tables, MutableBytes{image}, LimitAbort::range};
};

TEST(TextValue, TextEndsBeforeItsFirstZeroByte) {
    test::shows_rule("a text is sent up to its first zero byte");
    TextDictionary dictionary;
    // The bytes before the zero byte, and those behind it, have these values: 1, 255, a letter, and the values around
    // 80h.
    const std::array<std::uint8_t, 6> letters{{0x01U, 0x41U, 0x7FU, 0x80U, 0x81U, 0xFFU}};
    for (const std::uint8_t before : letters) {
        for (const std::uint8_t behind : letters) {
            for (std::size_t length = 0U; length <= capacity; ++length) {
                dictionary.image.fill(behind);
                std::fill_n(dictionary.image.begin(), length, before);
                if (length < capacity) {
                    dictionary.image[length] = 0U;
                }
                const ByteView value = dictionary.objects.value(dictionary.objects.lookup(0x2000U, 0U));
                ASSERT_EQ(value.size(), length) << "of bytes " << int{before} << " before " << int{behind};
                ASSERT_EQ(value.data(), dictionary.image.data());
            }
        }
    }
}

}  // namespace
}  // namespace canproof
