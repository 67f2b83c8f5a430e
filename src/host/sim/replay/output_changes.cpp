// SPDX-License-Identifier: Apache-2.0
#include "host/sim/replay/output_changes.hpp"

#include <fmt/format.h>

#include "firmware/base/time.hpp"
#include "host/base/time_text.hpp"

namespace canproof::host {

void OutputChanges::write(std::ostream& out, Instant at, const SimulatedDevice& device) {
    const std::vector<double> values = device.outputs();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (last_.empty() || last_[i] != values[i]) {
            out << fmt::format("{},{}{},{:.6g}\n", format_seconds(at), prefix_, device.output_names()[i], values[i]);
        }
    }
    last_ = values;
}

}  // namespace canproof::host
