// SPDX-License-Identifier: Apache-2.0
// The rows of an object dictionary as values. The program speccompiler, which compiles the requirements register,
// prints them as C++. The host uses the rows directly for a dictionary that it reads at run time.
#pragma once

#include <cstdint>
#include <vector>

#include "firmware/canopen/object_types.hpp"
#include "host/register/layout.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// A dictionary in the form of the firmware. Objects and entries are in the order of Part::objects; entries can share
/// limits and lists of allowed values.
struct DictionaryRows {
    std::vector<ObjectRow> objects;
    std::vector<EntryRow> entries;
    std::vector<LimitRow> limits;
    std::vector<std::uint32_t> allowed;
    std::vector<std::uint16_t> slots;  ///< hash slots: position in `objects`, or no_object
    std::uint32_t slot_factor{0};      ///< factor for object_slot(), which returns the first slot to search
    Layout layout;

    /// Returns a view of the rows. It is valid as long as the rows exist.
    DictionaryTables tables() const;
};

/// Whether entries with the same range share a row of limits, or each entry has its own row.
enum class Limits { shared, one_an_entry };
DictionaryRows make_rows(const Part& part, Limits limits = Limits::shared);

/// Returns the firmware's data type for a CiA type such as `UNSIGNED16`. Throws std::out_of_range for a type that the
/// firmware does not support.
DataType data_type(const std::string& cia_type);

}  // namespace canproof::host
