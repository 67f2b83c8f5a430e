// SPDX-License-Identifier: Apache-2.0
// Objects of the communication area in CiA 301.
#pragma once

#include <vector>

namespace canproof::host {

struct StandardObject301 {
    enum class Access { any, read, write };

    unsigned index;
    unsigned code;  ///< object code: 7 VAR, 8 ARRAY, 9 RECORD
    unsigned type;  ///< data type of the value, or of each entry from sub-index 1 on; 0: several types
    Access access;  ///< access to the value, or to each entry from sub-index 1 on
};

const std::vector<StandardObject301>& standard_objects_301();

}  // namespace canproof::host
