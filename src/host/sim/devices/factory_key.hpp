// SPDX-License-Identifier: Apache-2.0
// One key of `--factory KEY=VALUE`: name, type and range of a value that a unit gets in the factory.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace canproof::host {

struct FactoryKey {
    std::string name;  ///< serial_number
    std::string type;  ///< CiA type; VISIBLE_STRING for a choice of `words`
    std::string unit;
    double minimum{0.0};
    double maximum{0.0};
    std::size_t length{0};           ///< greatest number of characters of a text
    std::vector<std::string> words;  ///< the allowed words; none: any text
    std::string text;

    std::string range() const;
};

}  // namespace canproof::host
