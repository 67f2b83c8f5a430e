// SPDX-License-Identifier: Apache-2.0
// The rows of an object dictionary, which are generated from the requirements register: constants in flash.
// object_dictionary.hpp defines the view that the services use.
#pragma once

#include <cstddef>
#include <cstdint>

namespace canproof {

/// Data types of CiA 301. The numbers are the indices that CiA assigns to them.
enum class DataType : std::uint8_t {
    boolean = 0x01U,
    integer8 = 0x02U,
    integer16 = 0x03U,
    integer32 = 0x04U,
    unsigned8 = 0x05U,
    unsigned16 = 0x06U,
    unsigned32 = 0x07U,
    real32 = 0x08U,
    visible_string = 0x09U,
    octet_string = 0x0AU,
    domain = 0x0FU,
    real64 = 0x11U,
    integer64 = 0x15U,
    unsigned64 = 0x1BU
};

/// Returns whether a type is a number of one, two or four bytes.
constexpr bool is_short_number(const DataType type) noexcept {
    return static_cast<std::uint32_t>(type) <= static_cast<std::uint32_t>(DataType::real32);
}

/// Rights of SDO and PDO to an entry and further properties of it, as bits of EntryRow::rights.
namespace rights {
constexpr std::uint32_t read = 0x01U;
constexpr std::uint32_t write = 0x02U;
constexpr std::uint32_t rpdo = 0x04U;      ///< may be mapped into a receive PDO
constexpr std::uint32_t tpdo = 0x08U;      ///< may be mapped into a transmit PDO
constexpr std::uint32_t stored = 0x10U;    ///< a write to 1010h (store parameters) stores the value
constexpr std::uint32_t node_id = 0x20U;   ///< the node-ID is added to the default
constexpr std::uint32_t constant = 0x40U;  ///< the value lies in flash: `offset` refers to the constant pool
}  // namespace rights

/// The service that owns an entry: it checks a write before it happens and reacts afterwards.
enum class Service : std::uint8_t {
    none,
    sync,
    emcy,
    heartbeat,
    guarding,
    pdo,
    store,
    nmt,
    error_behaviour,
    program,
    lss,
    device
};

/// One sub-index. `offset` and `size` are bytes in the value image (or in the constant pool, see rights::constant).
/// `size` of a string is its capacity. DOMAIN has size 0.
struct EntryRow {
    std::uint16_t offset;
    std::uint16_t size;
    std::uint16_t limit;  ///< row of the limit table; no_limit when only the type limits the value
    std::uint8_t subindex;
    DataType type;
    std::uint8_t rights;
    Service service;

    constexpr bool may(const std::uint32_t right) const noexcept { return (rights & right) != 0U; }
};

constexpr std::uint32_t no_limit = 0xFFFFU;

enum class ObjectKind : std::uint8_t { var = 0x07U, array = 0x08U, record = 0x09U };

/// One index: `count` consecutive rows of the entry table, ascending by sub-index.
struct ObjectRow {
    std::uint16_t index;
    std::uint16_t first_entry;
    std::uint8_t count;
    ObjectKind kind;
};

/// How one end of a range is defined.
enum class LimitKind : std::uint8_t {
    none,          ///< the type's own range
    value,         ///< `bits` is the limit itself, in the entry's type
    entry,         ///< `bits` is index << 8 | sub-index of another entry; `add` is added to its value
    list,          ///< (minimum only) `bits` = first << 16 | count of the rows in DictionaryTables::allowed
    value_or_zero  ///< (minimum only, integers) like `value`, but 0 is allowed too (it switches a function off)
};

/// Sub-index in a LimitKind::entry that stands for the sub-index of the written entry.
constexpr std::uint32_t same_subindex = 0xFFU;

struct Limit {
    LimitKind kind;
    std::uint32_t bits;
    std::int32_t add;
};

struct LimitRow {
    Limit minimum;
    Limit maximum;
};

/// A pointer and a count, which describe one generated table.
template <typename Row>
struct TableView {
    const Row* rows{nullptr};
    std::size_t count{0U};

    constexpr const Row* begin() const noexcept { return rows; }
    constexpr const Row* end() const noexcept { return rows + count; }
    constexpr const Row& operator[](const std::size_t at) const noexcept { return rows[at]; }
};

template <typename Array>
constexpr auto table_view(const Array& rows) noexcept {
    return TableView<typename Array::value_type>{rows.data(), rows.size()};
}

/// The generated tables of one dictionary.
struct DictionaryTables {
    TableView<ObjectRow> objects;       ///< ascending by index
    TableView<EntryRow> entries;        ///< ascending by index, sub-index
    TableView<LimitRow> limits;         ///< limits of entries, by EntryRow::limit
    TableView<std::uint32_t> allowed;   ///< values of LimitKind::list, as bit patterns of the entry's type
    TableView<std::uint8_t> constants;  ///< values of rights::constant entries
    TableView<std::uint8_t> defaults;   ///< the value image as shipped, before the node-ID is added
    /// Hash of the stored and the mappable entries with their offsets, rights and limits: a stored set of parameters is
    /// valid for this layout only (CO-STORE-019).
    std::uint32_t layout{0U};
    TableView<std::uint16_t> slots;  ///< hash table of positions in `objects`, see object_slot(); no_object: free
    std::uint32_t slot_factor{0U};
    /// Offset of the settings in the value image: from here on, a value changes only by a write or when the parameters
    /// are loaded. A multiple of four.
    std::size_t settings_at{SIZE_MAX};
};

constexpr std::uint32_t no_object = 0xFFFFU;

/// Returns the slot where the search for an index begins, in a hash table of `count` slots (a power of two). The object
/// is in that slot or in one after it, before the next free slot.
constexpr std::size_t object_slot(const std::uint16_t index, const std::uint32_t factor,
                                  const std::size_t count) noexcept {
    return ((index * factor) >> 16U) & (count - 1U);
}

/// The place of a named value in the value image (see EntryRow), for the device code. `T` is the arithmetic type of the
/// value.
template <typename T>
struct Field {
    std::uint16_t offset;
};

/// The place of a named string in the value image: zero bytes pad the string to its capacity, `size`.
struct StringField {
    std::uint16_t offset;
    std::uint16_t size;
};

/// The places of the elements of an ARRAY in the value image, by sub-index 1…N.
template <typename T, std::uint8_t N>
struct ArrayField {
    std::uint16_t offset;
    static constexpr std::uint32_t count = N;

    constexpr Field<T> operator[](const std::uint8_t subindex) const noexcept {
        return Field<T>{static_cast<std::uint16_t>(offset + ((subindex - 1U) * sizeof(T)))};
    }
};

}  // namespace canproof
