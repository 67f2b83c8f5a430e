// SPDX-License-Identifier: Apache-2.0
#include "host/sim/devices/served_pdos.hpp"

#include <fmt/format.h>

#include "firmware/canopen/dictionary_check.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

/// Returns `RPDO 9 (1408h)` for an object of a PDO that the firmware does not support; an empty text for any other
/// object.
std::string unserved(const Object& object) {
    const bool receives = is_unserved_pdo(PdoDirection::receive, object.index);
    if (!receives && !is_unserved_pdo(PdoDirection::transmit, object.index)) {
        return "";
    }
    const unsigned first = communication_object(receives ? PdoDirection::receive : PdoDirection::transmit, 0U);
    return fmt::format("{} {} ({:04X}h)", receives ? "RPDO" : "TPDO", object.index - first + 1U, object.index);
}

}  // namespace

void check_served_pdos(const Part& part) {
    std::string all;
    for (const Object& object : part.objects) {
        const std::string name = unserved(object);
        if (!name.empty()) {
            all += fmt::format("{}:{}: {} is beyond the {} PDOs of each direction that a simulated node supports\n",
                               object.place.file, object.place.line, name, max_pdos);
        }
    }
    if (!all.empty()) {
        throw InputError{all + "remove these objects from a copy of the data sheet, and use the copy"};
    }
}

}  // namespace canproof::host
