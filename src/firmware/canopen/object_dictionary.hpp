// The object dictionary as services see it: a view over generated (or, on the host, run-time) tables and an image of
// values.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "firmware/base/bytes.hpp"
#include "firmware/base/result.hpp"
#include "firmware/canopen/object_types.hpp"
#include "firmware/canopen/vocabulary.hpp"

namespace canproof {

/// An entry: what lookup() and find() hand out.
struct EntryRef {
    const EntryRow* row{nullptr};
    std::uint16_t index{0U};

    bool is(const std::uint16_t wanted_index, const std::uint8_t subindex) const noexcept {
        return (std::uint32_t{index} == wanted_index) && (std::uint32_t{row->subindex} == subindex);
    }
    bool may(const std::uint32_t right) const noexcept { return row->may(right); }
    bool exists() const noexcept { return row != nullptr; }
};

/// Which abort codes a value outside its limits gets; the manuals differ in what they list.
enum class LimitAbort : std::uint8_t {
    range,    ///< 06090030h for both ends
    high_low  ///< 06090031h above, 06090032h below
};

/// Parameter groups of 1010h and 1011h (CiA 301, 7.5.2.13).
enum class ParameterGroup : std::uint8_t { communication = 0U, application = 1U, manufacturer = 2U };
constexpr std::uint32_t parameter_group_count = 3U;

/// 1000h–1FFFh communication, 2000h–5FFFh manufacturer, all above application.
ParameterGroup parameter_group(std::uint16_t index) noexcept;

/// Whether a type is a string or domain, whose values may be shorter than the capacity.
constexpr bool has_variable_length(const DataType type) noexcept {
    return (type == DataType::visible_string) || (type == DataType::octet_string) || (type == DataType::domain);
}

class ObjectDictionary {
  public:
    /// `image` holds the values; at least tables.defaults.count bytes, owned by the device.
    ObjectDictionary(const DictionaryTables& tables, MutableBytes image, LimitAbort limit_abort) noexcept;

    /// The entry, or one that does not exist.
    EntryRef lookup(std::uint16_t index, std::uint8_t subindex) const noexcept;
    /// Why lookup() found nothing: 06020000h when the object is absent, 06090011h when only the sub-index is. An object
    /// that exists has a sub-index 0.
    AbortCode missing(std::uint16_t index) const noexcept;
    /// Both at once.
    Result<EntryRef, AbortCode> find(std::uint16_t index, std::uint8_t subindex) const noexcept;
    bool has(const std::uint16_t index, const std::uint8_t subindex) const noexcept {
        return lookup(index, subindex).exists();
    }

    /// All bytes of the entry, where they lie.
    ByteView bytes(const EntryRow& row) const noexcept { return pool(row).part(row.offset, row.size); }
    /// The entry's bytes as they go on the bus; a string ends before its first zero byte.
    ByteView value(const EntryRef& entry) const noexcept;
    /// Whether `value` may be written here: access, length, type and limits. `none` when it may.
    AbortCode check_write(const EntryRef& entry, ByteView value) const noexcept;
    /// Access and length alone: the first part of check_write().
    AbortCode check_length(const EntryRow& row, const std::size_t length) const noexcept {
        if (!row.may(rights::write)) {
            return AbortCode::read_only;
        }
        if (length > row.size) {
            return AbortCode::too_long;
        }
        return ((length == row.size) || has_variable_length(row.type)) ? AbortCode::none : AbortCode::too_short;
    }
    /// Type and limits alone.
    AbortCode check_value(const EntryRef& entry, ByteView value) const noexcept;
    /// The same for a number: what is received by PDO.
    AbortCode check_bits(const EntryRow& row, const std::uint64_t bits) const noexcept {
        if ((row.type == DataType::boolean) && (bits > 1U)) {
            return AbortCode::value_range;
        }
        return (row.limit == no_limit) ? AbortCode::none : check_limits(row, bits);
    }
    /// Puts the bytes into the image; the caller has checked them. A string is padded with zeros. True when the value
    /// is another than before.
    bool put(const EntryRef& entry, ByteView value) noexcept;
    /// The same for an entry of at most eight bytes.
    bool put_bits(const EntryRow& row, std::uint64_t bits) noexcept;

    /// An entry of at most eight bytes as a number, least significant byte first: the short way of the PDOs.
    std::uint64_t bits(const EntryRow& row) const noexcept { return read_le(pool(row), row.offset, row.size); }

    /// The default of an entry of at most eight bytes, without the node-ID that rights::node_id adds.
    std::uint64_t default_bits(const EntryRow& row) const noexcept {
        return read_le(ByteView{tables_.defaults.rows, tables_.defaults.count}, row.offset, row.size);
    }
    /// Default values of one group as shipped; entries with rights::node_id get the node-ID added. The error list
    /// 1003h is none of the parameters: it stays as it is.
    void load_defaults(ParameterGroup group, std::uint8_t node_id) noexcept;

    /// Value of an entry of at most 32 bits; zero when the entry is absent, so that a service without its object is
    /// idle.
    std::uint32_t read(std::uint16_t index, std::uint8_t subindex) const noexcept;
    /// Sets a value of at most 32 bits that the device itself keeps; without the entry nothing happens.
    void write(std::uint16_t index, std::uint8_t subindex, std::uint32_t bits) noexcept;

    template <typename T>
    T get(const Field<T> field) const noexcept {
        return from_bits<T>(get_le<sizeof(T)>(image_.view(), field.offset));
    }
    template <typename T>
    void set(const Field<T> field, const T value) noexcept {
        image_.put_le<sizeof(T)>(field.offset, to_bits(value));
    }
    /// Leaves the value as it is where none is given.
    template <typename T>
    void set_given(const Field<T> field, const std::optional<T>& value) noexcept {
        if (value.has_value()) {
            set(field, *value);
        }
    }

    const DictionaryTables& tables() const noexcept { return tables_; }
    ByteView image() const noexcept { return image_.view(); }
    MutableBytes image() noexcept { return image_; }

  private:
    template <typename T>
    static T from_bits(const std::uint64_t bits) noexcept {
        if constexpr (std::is_same_v<T, float>) {
            return bit_cast<float>(static_cast<std::uint32_t>(bits));
        } else if constexpr (std::is_same_v<T, bool>) {
            return bits != 0U;
        } else {
            return static_cast<T>(bits);
        }
    }
    template <typename T>
    static std::uint64_t to_bits(const T value) noexcept {
        if constexpr (std::is_same_v<T, float>) {
            return bit_cast<std::uint32_t>(value);
        } else {
            return static_cast<std::uint64_t>(value);
        }
    }

    /// Where the entry's value lies.
    ByteView pool(const EntryRow& row) const noexcept {
        return row.may(rights::constant) ? ByteView{tables_.constants.rows, tables_.constants.count} : image_.view();
    }
    AbortCode check_limits(const EntryRow& row, std::uint64_t bits) const noexcept;
    bool in_list(const Limit& list, std::uint32_t bits) const noexcept;
    std::int64_t integer_limit(const Limit& limit, const EntryRow& row) const noexcept;

    const DictionaryTables& tables_;
    MutableBytes image_;
    LimitAbort limit_abort_;
};

}  // namespace canproof
