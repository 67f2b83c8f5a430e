// SPDX-License-Identifier: Apache-2.0
// Reads one entry of an EDS: data type, access, default, limits.
#pragma once

#include "host/datasheet/ini.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Reads one entry from the keys of `section` and stores it in `entry`, which must be new. For a missing or invalid
/// key, assumes a value and adds a note. `is_counter` must be true for sub-index 0 of an ARRAY or RECORD. Does not set
/// `entry.service`.
void read_eds_entry(Entry& entry, const IniSection& section, std::uint8_t subindex, bool is_counter,
                    const EdsTelling& tell);

/// Stores `value` as the default of an entry whose type is known. For a value that does not fit the type, adds a note
/// and keeps the default that the entry already has. Does not change the length of a string entry.
void set_eds_value(Entry& entry, const IniValue& value, const EdsTelling& tell);

}  // namespace canproof::host
