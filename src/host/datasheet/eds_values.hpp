// SPDX-License-Identifier: Apache-2.0
// Writes values of a dictionary in the spelling of an electronic data sheet (CiA 306, CiA 311).
#pragma once

#include <optional>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the CiA 301 index of a data type: 7 for UNSIGNED32; 0 for a type that this program does not write.
unsigned data_type_number(const std::string& type);
/// Returns the CiA 301 object code: VAR 7, ARRAY 8, RECORD 9, and 2 for a VAR of type DOMAIN.
unsigned object_code(const Object& object);
/// Returns the object as a data sheet describes it. A data sheet gives the values that an entry can have; the
/// requirements register gives the values that can be written. They differ for 1003h pre-defined error field, sub-index
/// 0: only 0 can be written, but the entry counts the errors.
Object as_in_sheet(const Object& object);
/// The spelling of REAL32 and REAL64 in a data sheet.
enum class Reals {
    decimal,  ///< defaults and limits as decimal numbers
    /// defaults as decimal numbers, no limits: for tools that expect the bits of reals and refuse decimal limits
    without_limits,
    bits  ///< defaults and limits as the bits of IEEE 754, `0x…`, for the tools of Lely
};
/// Returns the default as text: a decimal number, `0x…` for UNSIGNED32, UNSIGNED64 and the bits of a real,
/// `$NODEID+0x…`, an unchanged text, or bytes in hexadecimal. Returns an empty text when there is no default.
std::string eds_default(const Entry& entry, Reals reals = Reals::decimal);
/// Returns the lowest value as text. Returns nothing when only the type or another object limits the entry, and for a
/// real with Reals::without_limits. eds_high_limit() does the same for the highest value.
std::optional<std::string> eds_low_limit(const Entry& entry, Reals reals);
std::optional<std::string> eds_high_limit(const Entry& entry, Reals reals);
/// Returns the access type: ro, wo, rw or const, or rwr or rww for a writable entry that only TPDOs or only RPDOs may
/// contain.
std::string eds_access(const Entry& entry);
/// Returns the number of objects with an index in [first, last].
std::size_t count_objects(const Part& device, unsigned first, unsigned last);
/// Returns the value of the key Granularity: 8 bits, or 0 when no mapping of the device can be changed.
std::size_t granularity(const Part& device);
/// Returns the default of an entry if it is a whole number; 0 otherwise.
std::int64_t whole_default(const Part& device, unsigned index, unsigned subindex);
/// The date of the manual: year, month and day. All three are zero when the text of the date does not have the form
/// 2014-11-24.
struct Date {
    int year{0};
    int month{0};
    int day{0};
};
Date manual_date(const Register& content, const Part& device);

}  // namespace canproof::host
