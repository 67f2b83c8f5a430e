// SPDX-License-Identifier: Apache-2.0
// `zero = true` allows 0 in addition to a range that begins above it, from the register to the abort code and the data
// sheet.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "firmware/canopen/object_dictionary.hpp"
#include "host/codegen/dictionary_rows.hpp"
#include "host/codegen/write_objects.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/register/load.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;

const std::string period = R"([[object]]
index = 0x2000
name = "Period"
type = "UNSIGNED16"
access = "rw"
default = 0
range = { min = 10, max = 5000, zero = true }
source = ["M1:1"]
)";

class ZeroRange : public testing::Test {
  protected:
    ZeroRange() : loaded_{load_register(with(items_file, period))}, rows_{make_rows(*loaded_.content.part("box"))} {}
    void SetUp() override { ASSERT_EQ(all_faults(loaded_), ""); }

    AbortCode writing(std::uint16_t value) {
        const DictionaryTables tables = rows_.tables();
        std::vector<std::uint8_t> image = rows_.layout.image;
        ObjectDictionary objects{tables, MutableBytes{image.data(), image.size()}, LimitAbort::high_low};
        const std::array<std::uint8_t, 2> bytes{static_cast<std::uint8_t>(value),
                                                static_cast<std::uint8_t>(value >> 8U)};
        return objects.check_write(objects.find(0x2000, 0).value(), ByteView{bytes.data(), bytes.size()});
    }

    LoadResult loaded_;
    DictionaryRows rows_;
};

}  // namespace

TEST_F(ZeroRange, ZeroAndTheRangeAreAllowedAndNothingBetween) {
    EXPECT_EQ(writing(0), AbortCode::none);
    EXPECT_EQ(writing(1), AbortCode::value_too_low);
    EXPECT_EQ(writing(9), AbortCode::value_too_low);
    EXPECT_EQ(writing(10), AbortCode::none);
    EXPECT_EQ(writing(5000), AbortCode::none);
    EXPECT_EQ(writing(5001), AbortCode::value_too_high);
}

TEST_F(ZeroRange, RangeThatAlsoAllows0HasItsOwnLimitKindInTheTables) {
    // The limits are 10 = Ah and 5000 = 1388h.
    EXPECT_THAT(write_objects(*loaded_.content.part("box")),
                HasSubstr("{{LimitKind::value_or_zero, 0x0000000AU, 0}, {LimitKind::value, 0x00001388U, 0}},"));
}

TEST_F(ZeroRange, RangeThatAlsoAllows0HasTheLowLimit0InTheDataSheet) {
    const std::string sheet = write_eds(loaded_.content, *loaded_.content.part("box"));
    EXPECT_THAT(sheet, HasSubstr("LowLimit=0\r\nHighLimit=5000\r\n"));
}

}  // namespace canproof::host::test
