// SPDX-License-Identifier: Apache-2.0
// One key of `--factory KEY=VALUE`: name, type and range of a value that the factory sets in a unit.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace canproof::host {

struct FactoryKey {
    std::string name;  ///< name of the key, such as serial_number
    std::string type;  ///< data type of CiA 301; VISIBLE_STRING also for a choice of `words`
    std::string unit;
    double minimum{0.0};
    double maximum{0.0};
    std::size_t length{0};           ///< greatest number of characters of a text
    std::vector<std::string> words;  ///< allowed words; empty: any text
    std::string text;

    std::string range() const;
};

}  // namespace canproof::host
