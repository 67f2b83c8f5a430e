// SPDX-License-Identifier: Apache-2.0
#include "target/zynqmp/bit_timing.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::zynqmp {

static_assert(implements<req::CO_ZCAN_001> && implements<req::CO_ZCAN_002> && implements<req::CO_ZCAN_010>);
Result<BitTiming, BitTimingError> bit_timing(const std::uint32_t clock_hz, const std::uint32_t bit_rate) noexcept {
    using Found = Result<BitTiming, BitTimingError>;
    const Found found = stm32f405::bit_timing(clock_hz, bit_rate);
    return (found.value().prescaler <= most_prescaler) ? found : Found::failure(BitTimingError::no_such_rate);
}

}  // namespace canproof::zynqmp
