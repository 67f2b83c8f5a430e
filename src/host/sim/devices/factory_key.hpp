// One key of `--factory KEY=VALUE`: name, type and range of a value that left the factory with a unit.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace canproof::host {

struct FactoryKey {
    std::string name;  ///< serial_number
    std::string type;  ///< CiA word; VISIBLE_STRING for a choice of `words`
    std::string unit;
    double minimum{0.0};
    double maximum{0.0};
    std::size_t length{0};           ///< most characters of a text
    std::vector<std::string> words;  ///< the only ones; none: any
    std::string text;

    std::string range() const;
};

}  // namespace canproof::host
