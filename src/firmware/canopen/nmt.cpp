// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/nmt.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/requirements.hpp"
#include "generated/canopen/tables.hpp"

namespace canproof {

namespace services = generated::canopen::nmt_services;

static_assert(implements<req::CO_T_SERVICES> && implements<req::CO_E_NMT_STATE>);
AllowedServices::AllowedServices(const NmtState state) noexcept {
    for (const services::Row& row : services::rows) {
        if ((row.state == state) && row.allowed) {
            bits_ |= std::uint32_t{1U} << static_cast<std::uint32_t>(row.service);
        }
    }
}

static_assert(implements<req::CO_E_NMT_COMMAND>);
std::optional<NmtCommand> nmt_command(const Frame& frame, const std::uint8_t node_id) noexcept {
    constexpr std::uint32_t command_length{2U};
    static_assert(implements<req::CO_NMT_004> && implements<req::CO_K_NMT_ID>);
    if (frame.extended || frame.remote || (frame.id != generated::canopen::nmt_command_cob_id) ||
        (frame.length != command_length)) {
        return std::nullopt;
    }
    static_assert(implements<req::CO_NMT_003> && implements<req::CO_NMT_009>);
    const std::uint32_t addressed = frame.data[1];
    if ((addressed != 0U) && (addressed != node_id)) {
        return std::nullopt;
    }
    switch (frame.data[0]) {
        case static_cast<std::uint8_t>(NmtCommand::start):
            return NmtCommand::start;
        case static_cast<std::uint8_t>(NmtCommand::stop):
            return NmtCommand::stop;
        case static_cast<std::uint8_t>(NmtCommand::enter_pre_operational):
            return NmtCommand::enter_pre_operational;
        case static_cast<std::uint8_t>(NmtCommand::reset_node):
            return NmtCommand::reset_node;
        case static_cast<std::uint8_t>(NmtCommand::reset_communication):
            return NmtCommand::reset_communication;
        default:
            return std::nullopt;
    }
}

}  // namespace canproof
