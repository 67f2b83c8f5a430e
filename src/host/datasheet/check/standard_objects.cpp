// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/check/standard_objects.hpp"

namespace canproof::host {

const std::vector<StandardObject301>& standard_objects_301() {
    using Access = StandardObject301::Access;
    constexpr unsigned u8 = 5;
    constexpr unsigned u16 = 6;
    constexpr unsigned u32 = 7;
    constexpr unsigned text = 9;
    static const std::vector<StandardObject301> all{
        {0x1000, 7, u32, Access::read},  {0x1001, 7, u8, Access::read},   {0x1002, 7, u32, Access::read},
        {0x1003, 8, u32, Access::read},  {0x1005, 7, u32, Access::any},   {0x1006, 7, u32, Access::any},
        {0x1007, 7, u32, Access::any},   {0x1008, 7, text, Access::read}, {0x1009, 7, text, Access::read},
        {0x100A, 7, text, Access::read}, {0x100C, 7, u16, Access::any},   {0x100D, 7, u8, Access::any},
        {0x1010, 8, u32, Access::write}, {0x1011, 8, u32, Access::write}, {0x1012, 7, u32, Access::any},
        {0x1014, 7, u32, Access::any},   {0x1015, 7, u16, Access::any},   {0x1016, 8, u32, Access::any},
        {0x1017, 7, u16, Access::any},   {0x1018, 9, u32, Access::read},  {0x1019, 7, u8, Access::any},
        {0x1029, 8, u8, Access::any}};
    return all;
}

}  // namespace canproof::host
