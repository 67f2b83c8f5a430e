// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/check/eds_types.hpp"

#include <algorithm>
#include <array>

namespace canproof::host {

namespace {

using Kind = EdsDataType::Kind;

constexpr std::array<EdsDataType, 29> types{
    {{0x01, "BOOLEAN", 1, Kind::boolean},        {0x02, "INTEGER8", 8, Kind::integer},
     {0x03, "INTEGER16", 16, Kind::integer},     {0x04, "INTEGER32", 32, Kind::integer},
     {0x05, "UNSIGNED8", 8, Kind::natural},      {0x06, "UNSIGNED16", 16, Kind::natural},
     {0x07, "UNSIGNED32", 32, Kind::natural},    {0x08, "REAL32", 32, Kind::real},
     {0x09, "VISIBLE_STRING", 0, Kind::text},    {0x0A, "OCTET_STRING", 0, Kind::octets},
     {0x0B, "UNICODE_STRING", 0, Kind::unicode}, {0x0C, "TIME_OF_DAY", 48, Kind::time},
     {0x0D, "TIME_DIFFERENCE", 48, Kind::time},  {0x0F, "DOMAIN", 0, Kind::domain},
     {0x10, "INTEGER24", 24, Kind::integer},     {0x11, "REAL64", 64, Kind::real},
     {0x12, "INTEGER40", 40, Kind::integer},     {0x13, "INTEGER48", 48, Kind::integer},
     {0x14, "INTEGER56", 56, Kind::integer},     {0x15, "INTEGER64", 64, Kind::integer},
     {0x16, "UNSIGNED24", 24, Kind::natural},    {0x18, "UNSIGNED40", 40, Kind::natural},
     {0x19, "UNSIGNED48", 48, Kind::natural},    {0x1A, "UNSIGNED56", 56, Kind::natural},
     {0x1B, "UNSIGNED64", 64, Kind::natural},    {0x20, "PDO_COMMUNICATION_PARAMETER", 0, Kind::record},
     {0x21, "PDO_MAPPING", 0, Kind::record},     {0x22, "SDO_PARAMETER", 0, Kind::record},
     {0x23, "IDENTITY", 0, Kind::record}}};

}  // namespace

const EdsDataType* eds_data_type(std::uint64_t number) {
    const auto found =
        std::find_if(types.begin(), types.end(), [number](const EdsDataType& type) { return type.number == number; });
    return found == types.end() ? nullptr : &*found;
}

}  // namespace canproof::host
