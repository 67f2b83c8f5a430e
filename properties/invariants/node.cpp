// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/node.hpp"

namespace canproof {

bool Node::is_consistent() const noexcept {
    const AllowedServices allowed{state_};
    return (allowed_.has(NmtService::pdo) == allowed.has(NmtService::pdo)) &&
           (allowed_.has(NmtService::sdo) == allowed.has(NmtService::sdo)) &&
           (allowed_.has(NmtService::sync) == allowed.has(NmtService::sync)) &&
           (allowed_.has(NmtService::emcy) == allowed.has(NmtService::emcy)) &&
           ((state_ == NmtState::initialising) || error_control_.shows(state_)) &&
           (allowed.has(NmtService::sdo) || !sdo_.has_transfer());
}

const char* Node::inconsistent_service() const noexcept {
    if (!queue_.is_consistent()) {
        return "transmit queue";
    }
    if (!sdo_.is_consistent()) {
        return "SDO server";
    }
    if (!emcy_.is_consistent()) {
        return "EMCY";
    }
    if (!heartbeats_.is_consistent()) {
        return "heartbeat consumer";
    }
    if (!lss_.is_consistent()) {
        return "LSS";
    }
    // The node's first boot-up begins these services; without a node-ID there is none.
    if (state_ != NmtState::initialising) {
        if (!error_control_.is_consistent()) {
            return "error control";
        }
        if (!sync_.is_consistent()) {
            return "SYNC";
        }
        if (!rpdos_.is_consistent()) {
            return "PDO reception";
        }
    }
    return is_consistent() ? nullptr : "node";
}

}  // namespace canproof
