// Values of a dictionary as an electronic data sheet spells them (CiA 306, CiA 311).
#pragma once

#include <optional>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// CiA 301 index of a data type: 7 for UNSIGNED32.
unsigned data_type_number(const std::string& type);
/// CiA 301 object code: VAR 7, ARRAY 8, RECORD 9; a VAR of type DOMAIN is 2.
unsigned object_code(const Object& object);
/// The object as a data sheet shows it. A data sheet gives the values that an entry may have, where the register gives
/// those that may be written: 1003h sub-index 0 (number of errors) takes a write of 0 only and counts up to its
/// entries.
Object as_in_sheet(const Object& object);
/// How a data sheet spells REAL32 and REAL64.
enum class Reals {
    decimal,         ///< defaults and limits as decimal numbers
    without_limits,  ///< defaults as decimal numbers, no limits: tools that take reals as bits refuse decimal limits
    bits             ///< defaults and limits as the bits of IEEE 754, `0x…`, as the tools of Lely read them
};
/// Decimal, `0x…` for unsigned 32-bit values, `$NODEID+0x…`, a text as it is, octets in hexadecimal. Empty: no default.
std::string eds_default(const Entry& entry, Reals reals = Reals::decimal);
/// Lowest and highest value by numbers; nothing where the type or another object limits.
std::optional<std::string> eds_low_limit(const Entry& entry, Reals reals);
std::optional<std::string> eds_high_limit(const Entry& entry, Reals reals);
/// ro, wo, rw, const; rwr and rww for what only a TPDO or only an RPDO may carry.
std::string eds_access(const Entry& entry);
/// How many objects lie in [first, last].
std::size_t count_objects(const Part& device, unsigned first, unsigned last);
/// Bits of the smallest object that a PDO can carry; 0 when mapping cannot be changed.
std::size_t granularity(const Part& device);
/// Default of an entry that holds a whole number; 0 where there is none.
std::int64_t whole_default(const Part& device, unsigned index, unsigned subindex);
/// The manual's date, year, month and day; all zero where it is not of the form 2014-11-24.
struct Date {
    int year{0};
    int month{0};
    int day{0};
};
Date manual_date(const Register& content, const Part& device);

}  // namespace canproof::host
