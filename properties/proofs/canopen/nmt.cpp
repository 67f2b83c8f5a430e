// SPDX-License-Identifier: Apache-2.0
// Theorems on NMT and COB-IDs for any frame, any node-ID and any value.
#include "firmware/canopen/nmt.hpp"

#include "firmware/canopen/cob_id.hpp"
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

/// Returns any frame that a CAN controller can deliver, with at most eight bytes.
Frame any_frame() {
    const Frame frame = any<Frame>();
    assume(frame.length <= max_frame_length);
    return frame;
}

/// Returns whether a command specifier is one of CiA 301, 7.2.8.3.1: 1, 2, 128, 129 or 130.
bool is_command(const std::uint8_t specifier) {
    return (specifier == 1U) || (specifier == 2U) || ((specifier >= 128U) && (specifier <= 130U));
}

}  // namespace

void nmt_takes_exactly_its_commands() {
    shows(
        "a frame is an NMT command exactly when it is a base data frame 000h of 2 bytes, with a known command, to all "
        "or to this node");
    proves<req::CO_NMT_003, req::CO_NMT_009, req::CO_NMT_004>();
    const Frame frame = any_frame();
    const auto node_id = any<std::uint8_t>();
    const std::optional<NmtCommand> command = nmt_command(frame, node_id);
    const bool expected = (frame.id == 0U) && !frame.extended && !frame.remote && (frame.length == 2U) &&
                          is_command(frame.data[0]) && ((frame.data[1] == 0U) || (frame.data[1] == node_id));
    claim(command.has_value() == expected);
    if (command.has_value()) {
        claim(static_cast<std::uint8_t>(*command) == frame.data[0]);
    }
}

void each_state_allows_what_cia_301_says() {
    shows(
        "initialising and stopped allow no PDO, SDO, SYNC or EMCY; pre-operational all of them but PDOs; operational "
        "all");
    proves<req::CO_T_SERVICES>();
    const auto state = any<NmtState>();
    const AllowedServices services{state};
    const bool operational = state == NmtState::operational;
    const bool runs = operational || (state == NmtState::pre_operational);
    claim(services.has(NmtService::pdo) == operational);
    claim(services.has(NmtService::sdo) == runs);
    claim(services.has(NmtService::sync) == runs);
    claim(services.has(NmtService::emcy) == runs);
}

void restricted_identifiers_are_those_of_cia_301() {
    shows("an identifier is restricted exactly when Table 40 of CiA 301 lists it, or it has more than 11 bits");
    proves<req::CO_T_RESTRICTED_COB_ID>();
    const auto id = any<std::uint16_t>();
    const bool listed = (id <= 0x07FU) || ((id >= 0x101U) && (id <= 0x180U)) || ((id >= 0x581U) && (id <= 0x5FFU)) ||
                        ((id >= 0x601U) && (id <= 0x67FU)) || ((id >= 0x6E0U) && (id <= 0x6FFU)) || (id >= 0x701U);
    claim(cob_id::is_restricted(id) == listed);
}

void an_identifier_in_use_does_not_change() {
    shows(
        "a COB-ID entry takes only its flags beside an unrestricted identifier, and another identifier only while it "
        "is not in use");
    const auto current = any<std::uint32_t>();
    const auto wanted = any<std::uint32_t>();
    const bool has_valid_bit = any<bool>();
    const std::uint32_t flags = (has_valid_bit ? cob_id::not_valid : 0U) | (any<bool>() ? 0x40000000U : 0U);
    const bool in_use = any<bool>();
    const AbortCode answer = cob_id::check_change(current, wanted, flags, in_use);
    const std::uint32_t id = cob_id::identifier(wanted);
    const bool well_formed = ((wanted & ~(flags | 0x7FFU)) == 0U) && !cob_id::is_restricted(id);
    const bool switches_off = has_valid_bit && !cob_id::is_valid(wanted);
    const bool may = !in_use || switches_off || (id == cob_id::identifier(current));
    claim((answer == AbortCode::value_range) == !well_formed);
    claim((answer == AbortCode::device_state) == (well_formed && !may));
    claim((answer == AbortCode::none) == (well_formed && may));
}

}  // namespace canproof::proofs
