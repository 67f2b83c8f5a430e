// SPDX-License-Identifier: Apache-2.0
// Data types of CiA 301. They are found by their number, which an EDS gives as DataType.
#pragma once

#include <cstdint>
#include <string>

namespace canproof::host {

struct EdsDataType {
    enum class Kind { boolean, integer, natural, real, text, octets, unicode, time, domain, record };

    unsigned number;   ///< number of the type in CiA 301
    const char* name;  ///< name in CiA 301
    unsigned bits;     ///< length in bits; 0: variable
    Kind kind;

    bool is_whole() const { return kind == Kind::integer || kind == Kind::natural; }
    bool is_number() const { return is_whole() || kind == Kind::real; }
    /// Returns whether the type has a fixed length of at most 64 bits, so that a PDO can contain it.
    bool fits_pdo() const { return bits != 0 && bits <= 64; }
};

/// Returns the type; nullptr when CiA 301 has no such type.
const EdsDataType* eds_data_type(std::uint64_t number);

}  // namespace canproof::host
