// What the AX130751, the AX188001 and the AX060805 have in common on the bus: their manuals say it in the same words.
#pragma once

#include "firmware/canopen/node.hpp"

namespace canproof {

/// The profile of an Axiomatic node with these LSS bit rates, which must outlive it. The reasons stand in the decisions
/// of each device.
template <std::size_t N>
constexpr NodeProfile axiomatic_profile(const std::array<LssBitRate, N>& bit_rates) noexcept {
    NodeProfile profile{};
    profile.limit_abort = LimitAbort::high_low;
    profile.error_list = ErrorList::active;
    profile.emcy_content = EmcyContent::detail;
    profile.lss = LssProfile{bit_rates, true};
    profile.tpdo_trigger = TpdoTrigger::event_timer;
    return profile;
}

}  // namespace canproof
