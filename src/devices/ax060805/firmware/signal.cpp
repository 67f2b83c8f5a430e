// SPDX-License-Identifier: Apache-2.0
#include "devices/ax060805/firmware/signal.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/ax060805/requirements.hpp"

namespace canproof::ax060805 {

namespace {

constexpr float beyond_discrete = 4294967296.0F;  // 2^32

}  // namespace

static_assert(implements<req::INC_SIG_003> && implements<req::INC_SIG_008>);
float as_continuous(const Signal& signal) noexcept {
    switch (signal.kind) {
        case SignalKind::discrete:
            return static_cast<float>(signal.discrete);
        case SignalKind::continuous:
            return signal.continuous;
        case SignalKind::undefined:
        default:
            return 0.0F;
    }
}

static_assert(implements<req::INC_SIG_004> && implements<req::INC_SIG_009> && implements<req::INC_SIG_010>);
std::uint32_t to_discrete(const float value) noexcept {
    if (value >= beyond_discrete) {
        return UINT32_MAX;
    }
    // The condition is not `value < 0`: every comparison with NaN is false, and NaN must become 0.
    return (value > 0.0F) ? static_cast<std::uint32_t>(value) : 0U;
}

}  // namespace canproof::ax060805
