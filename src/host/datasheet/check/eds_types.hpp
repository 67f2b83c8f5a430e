// Data types of CiA 301 by their number, as [DataType] names them.
#pragma once

#include <cstdint>
#include <string>

namespace canproof::host {

struct EdsDataType {
    enum class Kind { boolean, integer, natural, real, text, octets, unicode, time, domain, record };

    unsigned number;   ///< index of the type
    const char* name;  ///< as CiA 301 calls it
    unsigned bits;     ///< 0: any length
    Kind kind;

    bool is_whole() const { return kind == Kind::integer || kind == Kind::natural; }
    bool is_number() const { return is_whole() || kind == Kind::real; }
    /// A value of it has a fixed length that fits a PDO.
    bool fits_pdo() const { return bits != 0 && bits <= 64; }
};

/// nullptr when CiA 301 has no such type.
const EdsDataType* eds_data_type(std::uint64_t number);

}  // namespace canproof::host
