// One entry of an EDS: data type, access, default, limits.
#pragma once

#include "host/datasheet/ini.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// What the keys of `section` say of one entry; what they do not say, or say wrongly, is assumed and noted. A counter
/// is the sub-index 0 of an ARRAY or RECORD. Services are the caller's.
Entry read_eds_entry(const IniSection& section, std::uint8_t subindex, bool is_counter, const EdsTelling& tell);

/// Puts a value (DefaultValue, ParameterValue) into an entry whose type is known.
void set_eds_value(Entry& entry, const IniValue& value, const EdsTelling& tell);

}  // namespace canproof::host
