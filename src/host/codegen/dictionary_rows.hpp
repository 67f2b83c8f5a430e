// The rows of an object dictionary as values: what the compiler prints as C++, and what the host runs a dictionary on
// that was read at run time.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/canopen/object_types.hpp"
#include "host/register/layout.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// A dictionary as the firmware sees it. Objects and entries stand in the order of Part::objects; limits and lists of
/// allowed values are shared by the entries that have the same.
struct DictionaryRows {
    std::vector<ObjectRow> objects;
    std::vector<EntryRow> entries;
    std::vector<LimitRow> limits;
    std::vector<std::uint32_t> allowed;
    std::vector<std::uint16_t> slots;  ///< see object_slot()
    std::uint32_t slot_factor{0};
    Layout layout;

    /// A view that lives as long as these rows do.
    DictionaryTables tables() const;
};

/// Whether entries with the same range share its row.
enum class Limits { shared, one_an_entry };
DictionaryRows make_rows(const Part& part, Limits limits = Limits::shared);

/// `UNSIGNED16` as the firmware's data type.
DataType data_type(const std::string& cia_type);

}  // namespace canproof::host
