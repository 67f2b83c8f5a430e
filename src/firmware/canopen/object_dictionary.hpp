// SPDX-License-Identifier: Apache-2.0
// The object dictionary for the services: a view of generated tables (on the host also run-time tables) and an image of
// the values.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "firmware/base/bytes.hpp"
#include "firmware/base/result.hpp"
#include "firmware/canopen/object_types.hpp"
#include "firmware/canopen/vocabulary.hpp"

namespace canproof {

/// An entry, as lookup() and find() return it.
struct EntryRef {
    const EntryRow* row{nullptr};
    std::uint16_t index{0U};

    bool is(const std::uint16_t wanted_index, const std::uint8_t subindex) const noexcept {
        return (std::uint32_t{index} == wanted_index) && (std::uint32_t{row->subindex} == subindex);
    }
    bool may(const std::uint32_t right) const noexcept { return row->may(right); }
    bool exists() const noexcept { return row != nullptr; }
};

/// The abort codes for a value outside its limits; the manuals differ here.
enum class LimitAbort : std::uint8_t {
    range,    ///< 06090030h (value range exceeded) above the maximum and below the minimum
    high_low  ///< 06090031h above the maximum, 06090032h below the minimum
};

/// Parameter groups of 1010h (store parameters) and 1011h (restore default parameters; CiA 301, 7.5.2.13).
enum class ParameterGroup : std::uint8_t { communication = 0U, application = 1U, manufacturer = 2U };
constexpr std::uint32_t parameter_group_count = 3U;

/// Returns the group of an index: 1000h–1FFFh communication, 2000h–5FFFh manufacturer, 6000h and above application.
ParameterGroup parameter_group(std::uint16_t index) noexcept;

/// Returns whether a type is a string or DOMAIN, whose values may be shorter than the capacity of the entry.
constexpr bool has_variable_length(const DataType type) noexcept {
    constexpr std::uint32_t such = (std::uint32_t{1U} << static_cast<std::uint32_t>(DataType::visible_string)) |
                                   (std::uint32_t{1U} << static_cast<std::uint32_t>(DataType::octet_string)) |
                                   (std::uint32_t{1U} << static_cast<std::uint32_t>(DataType::domain));
    return ((such >> static_cast<std::uint32_t>(type)) & 1U) != 0U;
}

class ObjectDictionary {
  public:
    /// Creates a view. `image` holds the values: at least tables.defaults.count bytes, owned by the device.
    ObjectDictionary(const DictionaryTables& tables, MutableBytes image, LimitAbort limit_abort) noexcept;

    /// Returns the entry. For an absent entry it returns one that has only the index, and whose exists() is false.
    EntryRef lookup(std::uint16_t index, std::uint8_t subindex) const noexcept;
    /// Returns the row of an entry that has a row for each lower sub-index of its object; nullptr for an absent entry
    /// and for any other entry, which only lookup() finds. The upload of a number uses this fast access.
    [[gnu::always_inline]] const EntryRow* near_row(const std::uint16_t index,
                                                    const std::uint8_t subindex) const noexcept {
        const ObjectRow* const object = object_row(index);
        return (object != nullptr) ? near_row(*object, subindex) : nullptr;
    }
    /// Returns why lookup() found nothing: 06020000h when the object is absent, 06090011h when only the sub-index is.
    /// Every object has a sub-index 0.
    AbortCode missing(std::uint16_t index) const noexcept;
    /// Returns the entry, or the abort code of missing().
    Result<EntryRef, AbortCode> find(std::uint16_t index, std::uint8_t subindex) const noexcept;
    bool has(const std::uint16_t index, const std::uint8_t subindex) const noexcept {
        return lookup(index, subindex).exists();
    }

    /// Returns whether the memory of the values has four bytes from the first byte of an entry on.
    bool has_word(const EntryRow& row) const noexcept {
        return (std::size_t{row.offset} + word_size) <= pool(row).size();
    }
    /// Returns a number of one to four bytes, for which has_word() is true.
    std::uint32_t short_number(const EntryRow& row) const noexcept {
        const std::uint32_t others = 8U * (word_size - row.size);  // bits of other values in the word
        return static_cast<std::uint32_t>(load_le<word_size>(pool(row), row.offset)) & (UINT32_MAX >> others);
    }
    /// Returns all bytes of the entry, without copying them.
    ByteView bytes(const EntryRow& row) const noexcept { return pool(row).part(row.offset, row.size); }
    /// Returns the entry's bytes as sent on the bus; a VISIBLE_STRING ends before its first zero byte.
    ByteView value(const EntryRef& entry) const noexcept {
        const ByteView all = bytes(*entry.row);
        return (entry.row->type == DataType::visible_string) ? text_of(all) : all;
    }
    /// Checks access, length, type and limits of a new value. Returns AbortCode::none when it may be written, otherwise
    /// the first fault as an abort code.
    AbortCode check_write(const EntryRef& entry, ByteView value) const noexcept;
    /// Checks only access and length: the first part of check_write().
    AbortCode check_length(const EntryRow& row, const std::size_t length) const noexcept {
        if (!row.may(rights::write)) {
            return AbortCode::read_only;
        }
        if (length > row.size) {
            return AbortCode::too_long;
        }
        return ((length == row.size) || has_variable_length(row.type)) ? AbortCode::none : AbortCode::too_short;
    }
    /// Checks only type and limits; every string and every DOMAIN is accepted.
    AbortCode check_value(const EntryRef& entry, ByteView value) const noexcept;
    /// Checks only type and limits of a number, for example one received by PDO.
    AbortCode check_bits(const EntryRow& row, const std::uint64_t bits) const noexcept {
        if ((row.type == DataType::boolean) && (bits > 1U)) {
            return AbortCode::value_range;
        }
        return (row.limit == no_limit) ? AbortCode::none : check_limits(row, bits);
    }
    /// Puts bytes that the caller has checked into the image. A short string is padded with zeros. Returns true when
    /// the value changes. Does nothing for an entry with rights::constant.
    bool put(const EntryRef& entry, ByteView value) noexcept;
    /// Does the same as put() for an entry of at most eight bytes, whose value is a number.
    bool put_bits(const EntryRow& row, std::uint64_t bits) noexcept;

    /// Returns an entry of at most eight bytes as a number, least significant byte first. The PDOs use this fast
    /// access.
    std::uint64_t bits(const EntryRow& row) const noexcept;

    /// Returns the default of an entry of at most eight bytes without rights::constant. The node-ID that
    /// rights::node_id adds is not included.
    std::uint64_t default_bits(const EntryRow& row) const noexcept;
    /// Loads the default values of one group; adds the node-ID to entries with rights::node_id. The error list 1003h is
    /// not a parameter and stays as it is.
    void load_defaults(ParameterGroup group, std::uint8_t node_id) noexcept;

    /// Returns the value of an entry of at most 32 bits; zero when the entry is absent, so that a service without its
    /// object does nothing.
    std::uint32_t read(std::uint16_t index, std::uint8_t subindex) const noexcept;
    /// Sets the value of an entry of at most 32 bits without any check, for values that the device itself maintains.
    /// `bits` must fit into the entry. Does nothing when the entry is absent or constant.
    void write(std::uint16_t index, std::uint8_t subindex, std::uint32_t bits) noexcept;

    template <typename T>
    T get(const Field<T> field) const noexcept {
        return from_bits<T>(get_le<sizeof(T)>(image_.view(), field.offset));
    }
    template <typename T>
    void set(const Field<T> field, const T value) noexcept {
        note_change_at(field.offset);
        image_.put_le<sizeof(T)>(field.offset, to_bits(value));
    }
    /// Sets the value of a field to `value`; without a `value` the field stays unchanged.
    template <typename T>
    void set_given(const Field<T> field, const std::optional<T>& value) noexcept {
        if (value.has_value()) {
            set(field, *value);
        }
    }

    /// Returns the part of the value image that holds the settings: the values that change only when they are written
    /// or loaded.
    ByteView settings() const noexcept { return image_.view().part(tables_.settings_at, SIZE_MAX); }
    /// Returns a number that changes with each change of a setting.
    std::uint32_t setting_changes() const noexcept { return setting_changes_; }

    const DictionaryTables& tables() const noexcept { return tables_; }
    ByteView image() const noexcept { return image_.view(); }
    MutableBytes image() noexcept { return image_; }

  private:
    static constexpr std::uint32_t word_size = 4U;

    [[gnu::always_inline]] const ObjectRow* object_row(const std::uint16_t index) const noexcept {
        // The generated hash table has free slots, so that every search ends after a few steps.
        const DictionaryTables& tables = tables_;
        std::size_t slot = object_slot(index, tables.slot_factor, tables.slots.count);
        std::uint16_t position = tables.slots[slot];
        while ((position != no_object) && (std::uint32_t{tables.objects[position].index} != index)) {
            slot = (slot + 1U) & (tables.slots.count - 1U);
            position = tables.slots[slot];
        }
        return (position != no_object) ? &tables.objects[position] : nullptr;
    }
    [[gnu::always_inline]] const EntryRow* near_row(const ObjectRow& object,
                                                    const std::uint8_t subindex) const noexcept {
        if (std::uint32_t{subindex} >= object.count) {
            return nullptr;
        }
        const EntryRow& row = tables_.entries[object.first_entry + std::size_t{subindex}];
        return (std::uint32_t{row.subindex} == subindex) ? &row : nullptr;
    }
    /// Notes that the value at an offset of the image is written.
    void note_change_at(const std::size_t offset) noexcept {
        setting_changes_ += (offset >= tables_.settings_at) ? 1U : 0U;
    }
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

    /// Returns the bytes before the first zero byte.
    static ByteView text_of(ByteView bytes) noexcept;
    /// Returns the memory that holds the entry's value.
    ByteView pool(const EntryRow& row) const noexcept {
        return row.may(rights::constant) ? ByteView{tables_.constants.rows, tables_.constants.count} : image_.view();
    }
    AbortCode check_limits(const EntryRow& row, std::uint64_t bits) const noexcept;
    bool in_list(const Limit& list, std::uint32_t bits) const noexcept;
    std::int64_t integer_limit(const Limit& limit, const EntryRow& row) const noexcept;

    const DictionaryTables& tables_;
    MutableBytes image_;
    LimitAbort limit_abort_;
    std::uint32_t setting_changes_{0U};
};

}  // namespace canproof
