// SPDX-License-Identifier: Apache-2.0
#include "devices/ax188001/firmware/gain_ranging.hpp"

#include <cmath>

#include "firmware/base/requirement.hpp"
#include "generated/ax188001/requirements.hpp"

namespace canproof::ax188001 {

void GainRanging::convert(const double input_uv, const ConverterCircuit& circuit) noexcept {
    static_assert(implements<req::TCS_IN_022>);
    if (settling_left_ > 1U) {  // only the last of the settling conversions is valid
        --settling_left_;
        return;
    }
    const double size = std::fabs(input_uv);
    const double full_scale = circuit.gains[step_].full_scale_uv;
    static_assert(implements<req::TCS_IN_003>);
    if (!(size < full_scale)) {  // NaN counts as overdriven
        const bool lowest = (step_ + 1U) == ConverterCircuit::gain_count;
        open_ = lowest;
        if (!lowest) {
            choose(step_ + 1U, circuit);
        }
        return;
    }
    static_assert(implements<req::TCS_IN_002> && implements<req::TCS_IN_021>);
    const double lsb = full_scale / circuit.codes;
    microvolts_ = std::round(input_uv / lsb) * lsb;
    open_ = false;
    static_assert(implements<req::TCS_IN_004>);
    for (std::size_t finer = 0U; finer < step_; ++finer) {
        if (size <= (circuit.gains[finer].full_scale_uv * circuit.raise_fraction)) {
            choose(finer, circuit);  // ends the search, because step_ is `finer` now
        }
    }
}

static_assert(implements<req::TCS_IN_016>);
void GainRanging::choose(const std::size_t step, const ConverterCircuit& circuit) noexcept {
    step_ = step;
    unsettle(circuit);
}

}  // namespace canproof::ax188001
