// SPDX-License-Identifier: Apache-2.0
// Values of a dictionary in the spelling of an electronic data sheet (CiA 306, CiA 311).
#pragma once

#include <optional>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the CiA 301 index of a data type: 7 for UNSIGNED32.
unsigned data_type_number(const std::string& type);
/// Returns the CiA 301 object code: VAR 7, ARRAY 8, RECORD 9, and 2 for a VAR of type DOMAIN.
unsigned object_code(const Object& object);
/// Returns the object in the form of a data sheet. A data sheet contains the values that an entry can have, the
/// register those that can be written: 1003h sub-index 0 (number of errors) accepts only a write of 0, but counts up to
/// the number of its entries.
Object as_in_sheet(const Object& object);
/// The spelling of REAL32 and REAL64 in a data sheet.
enum class Reals {
    decimal,         ///< defaults and limits as decimal numbers
    without_limits,  ///< defaults as decimal numbers, no limits: tools that expect the bits of reals refuse decimal
                     ///< limits
    bits             ///< defaults and limits as the bits of IEEE 754, `0x…`, as the tools of Lely expect them
};
/// Returns a decimal number, `0x…` for unsigned 32-bit values, `$NODEID+0x…`, an unchanged text, or octets in
/// hexadecimal. Empty when there is no default.
std::string eds_default(const Entry& entry, Reals reals = Reals::decimal);
/// Return the lowest and the highest value if they are numbers; nothing when only the type or another object limits the
/// value.
std::optional<std::string> eds_low_limit(const Entry& entry, Reals reals);
std::optional<std::string> eds_high_limit(const Entry& entry, Reals reals);
/// Returns ro, wo, rw or const; rwr and rww for an entry that only a TPDO or only an RPDO may carry.
std::string eds_access(const Entry& entry);
/// Returns the number of objects with an index in [first, last].
std::size_t count_objects(const Part& device, unsigned first, unsigned last);
/// Returns the bits of the smallest object that a PDO can carry; 0 when the mapping cannot be changed.
std::size_t granularity(const Part& device);
/// Returns the default of an entry that holds a whole number; 0 when there is none.
std::int64_t whole_default(const Part& device, unsigned index, unsigned subindex);
/// The manual's date: year, month and day; all zero when it does not have the form 2014-11-24.
struct Date {
    int year{0};
    int month{0};
    int day{0};
};
Date manual_date(const Register& content, const Part& device);

}  // namespace canproof::host
