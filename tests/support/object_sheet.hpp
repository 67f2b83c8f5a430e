// SPDX-License-Identifier: Apache-2.0
// A test fixture that compares a dictionary with the object pages of the device's manual: type, access, mapping,
// default and limits of each entry. It reads the generated tables directly; other tests cover the access over the bus.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "firmware/canopen/object_dictionary.hpp"

namespace canproof::test {

/// Types and constants with which a test writes down the objects of a manual, one row for each object.
namespace sheet {

enum class Access { ro, rw };
enum class Map { no, both, rpdo, tpdo };

/// One object of a manual: its elements 1…count, or the object itself when count is 0. `values` has one default for all
/// elements or one default for each. Defaults and limits of a REAL32 are bit patterns.
struct Row {
    std::uint16_t index;
    int count;
    DataType type;
    Access access;
    std::vector<std::int64_t> values;
    std::optional<std::int64_t> low;
    std::optional<std::int64_t> high;
    Map map{Map::no};
    bool stored{true};  ///< the value is stored by 1010h (store parameters); used for writable entries only
};

constexpr auto u8 = DataType::unsigned8;
constexpr auto u16 = DataType::unsigned16;
constexpr auto u32 = DataType::unsigned32;
constexpr auto i8 = DataType::integer8;
constexpr auto i16 = DataType::integer16;
constexpr auto i32 = DataType::integer32;
constexpr auto flag = DataType::boolean;
constexpr auto real = DataType::real32;
constexpr auto none = std::nullopt;

inline std::int64_t bits(float value) {
    std::uint32_t pattern = 0;
    std::memcpy(&pattern, &value, sizeof pattern);
    return pattern;
}

inline float number(std::int64_t bits) {
    const auto pattern = static_cast<std::uint32_t>(bits);
    float value = 0.0F;
    std::memcpy(&value, &pattern, sizeof value);
    return value;
}

inline std::size_t size_of(DataType type) {
    switch (type) {
        case DataType::boolean:
        case DataType::integer8:
        case DataType::unsigned8:
            return 1;
        case DataType::integer16:
        case DataType::unsigned16:
            return 2;
        default:
            return 4;
    }
}

inline std::int64_t least(DataType type) {
    switch (type) {
        case DataType::integer8:
            return -128;
        case DataType::integer16:
            return -32768;
        case DataType::integer32:
            return -2147483648LL;
        case DataType::real32:
            return bits(std::numeric_limits<float>::lowest());
        default:
            return 0;
    }
}

inline std::int64_t greatest(DataType type) {
    switch (type) {
        case DataType::boolean:
            return 1;
        case DataType::integer8:
            return 127;
        case DataType::unsigned8:
            return 255;
        case DataType::integer16:
            return 32767;
        case DataType::unsigned16:
            return 65535;
        case DataType::integer32:
            return 2147483647LL;
        case DataType::real32:
            return bits(std::numeric_limits<float>::max());
        default:
            return 4294967295LL;
    }
}

/// Returns the next greater (`step` 1) or next smaller (`step` -1) value of the type.
inline std::int64_t neighbour(std::int64_t value, DataType type, int step) {
    const float end = std::numeric_limits<float>::infinity();
    return type == real ? bits(std::nextafter(number(value), step > 0 ? end : -end)) : value + step;
}

}  // namespace sheet

class ObjectSheet : public testing::Test {
  protected:
    /// Makes a dictionary with the default values for `node_id`.
    ObjectSheet(const DictionaryTables& tables, std::size_t image_size, LimitAbort abort, std::uint8_t node_id)
        : image_(tables.defaults.begin(), tables.defaults.begin() + image_size),
          objects_{tables, MutableBytes{image_.data(), image_.size()}, abort},
          abort_{abort} {
        for (const auto group :
             {ParameterGroup::communication, ParameterGroup::manufacturer, ParameterGroup::application}) {
            objects_.load_defaults(group, node_id);
        }
    }

    EntryRef entry(std::uint16_t index, int sub) const {
        const auto found = objects_.find(index, static_cast<std::uint8_t>(sub));
        EXPECT_TRUE(found.ok()) << fmt::format("{:04X}h:{} is missing", index, sub);
        return found.value();
    }
    AbortCode writing(const EntryRef& entry, std::int64_t value) const {
        return objects_.check_write(entry, ByteView{bytes_of(value).data(), entry.row->size});
    }
    /// Checks a value against the limits of the entry. Ignores whether the entry is read-only.
    AbortCode within(const EntryRef& entry, std::int64_t value) const {
        return objects_.check_value(entry, ByteView{bytes_of(value).data(), entry.row->size});
    }
    AbortCode writing(std::uint16_t index, int sub, std::int64_t value) const {
        return writing(entry(index, sub), value);
    }
    void set(std::uint16_t index, int sub, std::int64_t value) {
        objects_.write(index, static_cast<std::uint8_t>(sub), static_cast<std::uint32_t>(value));
    }
    /// Returns all values from 0 to 65535 (for an entry of one byte: from 0 to 255) that a client may write to the
    /// entry.
    std::set<int> taken(std::uint16_t index, int sub) const {
        const EntryRef one = entry(index, sub);
        std::set<int> values;
        for (int value = 0; value <= (one.row->size == 1 ? 255 : 65535); ++value) {
            if (writing(one, value) == AbortCode::none) {
                values.insert(value);
            }
        }
        return values;
    }

    /// Checks the limits of an entry, also when the entry is read-only.
    void check_limits(const sheet::Row& row, const EntryRef& one) const {
        const std::int64_t least = sheet::least(row.type);
        const std::int64_t greatest = sheet::greatest(row.type);
        EXPECT_EQ(within(one, row.low.value_or(least)), AbortCode::none);
        EXPECT_EQ(within(one, row.high.value_or(greatest)), AbortCode::none);
        if (row.low && *row.low != least) {
            EXPECT_EQ(within(one, sheet::neighbour(*row.low, row.type, -1)), too_low());
        }
        if (row.high && *row.high != greatest) {
            EXPECT_EQ(within(one, sheet::neighbour(*row.high, row.type, 1)), too_high());
        }
    }
    void check_entry(const sheet::Row& row, int sub, std::int64_t value) const {
        SCOPED_TRACE(fmt::format("{:04X}h:{}", row.index, sub));
        const EntryRef one = entry(row.index, sub);
        EXPECT_EQ(one.row->type, row.type);
        EXPECT_EQ(one.row->size, sheet::size_of(row.type));
        check_rights(row, one);
        const std::uint64_t mask = (std::uint64_t{1} << (8U * sheet::size_of(row.type))) - 1U;
        EXPECT_EQ(read_le(objects_.value(one), 0, sheet::size_of(row.type)), static_cast<std::uint64_t>(value) & mask);
        check_limits(row, one);
        EXPECT_EQ(writing(one, value), row.access == sheet::Access::rw ? AbortCode::none : AbortCode::read_only);
    }
    /// Checks type, access and default of an entry as check_entry() does, and that the entry accepts exactly `values`.
    void check_choice(const sheet::Row& row, int sub, std::int64_t value, const std::set<int>& values) const {
        SCOPED_TRACE(fmt::format("{:04X}h:{}", row.index, sub));
        const EntryRef one = entry(row.index, sub);
        EXPECT_EQ(one.row->type, row.type);
        EXPECT_EQ(one.row->size, sheet::size_of(row.type));
        check_rights(row, one);
        EXPECT_EQ(objects_.read(row.index, static_cast<std::uint8_t>(sub)), static_cast<std::uint32_t>(value));
        EXPECT_EQ(taken(row.index, sub), values);
    }
    /// Checks sub-index 0 of an array or record: it is read-only and contains the number of elements.
    void check_count(std::uint16_t index, int count) const {
        check_entry(sheet::Row{index, 0, sheet::u8, sheet::Access::ro, {count}, sheet::none, sheet::none}, 0, count);
        EXPECT_EQ(objects_.find(index, static_cast<std::uint8_t>(count + 1)).error(), AbortCode::subindex_missing);
    }
    void check(const std::vector<sheet::Row>& rows) {
        for (const sheet::Row& row : rows) {
            EXPECT_TRUE(seen_.insert(row.index).second) << fmt::format("{:04X}h twice", row.index);
            if (row.count == 0) {
                check_entry(row, 0, row.values.at(0));
                EXPECT_EQ(objects_.find(row.index, 1).error(), AbortCode::subindex_missing);
                continue;
            }
            check_count(row.index, row.count);
            for (int sub = 1; sub <= row.count; ++sub) {
                check_entry(row, sub, row.values.at(row.values.size() == 1 ? 0 : static_cast<std::size_t>(sub - 1)));
            }
        }
    }
    /// Checks an entry with a read-only text of at most `capacity` characters.
    void check_text(std::uint16_t index, std::size_t capacity, const std::string& text) const {
        SCOPED_TRACE(fmt::format("{:04X}h", index));
        const EntryRef one = entry(index, 0);
        EXPECT_EQ(one.row->type, DataType::visible_string);
        EXPECT_EQ(one.row->size, capacity);
        check_rights({index, 0, DataType::visible_string, sheet::Access::ro, {}, sheet::none, sheet::none}, one);
        const ByteView value = objects_.value(one);
        EXPECT_EQ(std::string(value.data(), value.data() + value.size()), text);
        EXPECT_EQ(objects_.find(index, 1).error(), AbortCode::subindex_missing);
    }

    std::vector<std::uint8_t> image_;
    ObjectDictionary objects_;
    LimitAbort abort_;
    std::set<std::uint16_t> seen_;

  private:
    static std::array<std::uint8_t, 4> bytes_of(std::int64_t value) {
        std::array<std::uint8_t, 4> bytes{};
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            bytes[i] = static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8U * i));
        }
        return bytes;
    }
    AbortCode too_low() const {
        return abort_ == LimitAbort::range ? AbortCode::value_range : AbortCode::value_too_low;
    }
    AbortCode too_high() const {
        return abort_ == LimitAbort::range ? AbortCode::value_range : AbortCode::value_too_high;
    }
    void check_rights(const sheet::Row& row, const EntryRef& one) const {
        EXPECT_TRUE(one.may(rights::read));
        EXPECT_EQ(one.may(rights::write), row.access == sheet::Access::rw);
        EXPECT_EQ(one.may(rights::rpdo), row.map == sheet::Map::both || row.map == sheet::Map::rpdo);
        EXPECT_EQ(one.may(rights::tpdo), row.map == sheet::Map::both || row.map == sheet::Map::tpdo);
        EXPECT_EQ(one.may(rights::stored), row.access == sheet::Access::rw && row.stored);
    }
};

}  // namespace canproof::test
