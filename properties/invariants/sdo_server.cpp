// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/sdo_server.hpp"

namespace canproof {

bool SdoServer::is_consistent() const noexcept {
    const bool is_ending = state_ == State::block_download_ending;
    const bool blocks_up = (state_ == State::block_upload_starting) || (state_ == State::block_uploading);
    return (static_cast<std::uint32_t>(state_) <= static_cast<std::uint32_t>(State::block_upload_ending)) &&
           ((toggle_ == 0U) || (toggle_ == 0x10U)) && ((state_ != State::downloading) || (done_ <= place_.size())) &&
           (has_transfer() || (idle_until_ == never)) && ((object_.bits & 0xFFU) == 0U) &&
           (!(is_ending || (state_ == State::block_downloading)) || received_.is_consistent(place_, is_ending)) &&
           (!blocks_up || sent_.is_consistent(value_));
}

bool SdoServer::has_transfer() const noexcept {
    return state_ != State::idle;
}

}  // namespace canproof
