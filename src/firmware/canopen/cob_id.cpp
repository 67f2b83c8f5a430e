// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/cob_id.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/canopen/requirements.hpp"
#include "generated/canopen/tables.hpp"

namespace canproof::cob_id {

static_assert(implements<req::CO_T_RESTRICTED_COB_ID>);
bool is_restricted(const std::uint32_t identifier) noexcept {
    namespace table = generated::canopen::restricted_cob_id;
    return cell_or(table::find(static_cast<std::uint16_t>(identifier)), &table::Row::restricted, true);
}

AbortCode check_change(const std::uint32_t current, const std::uint32_t wanted, const std::uint32_t flags,
                       const bool in_use) noexcept {
    const std::uint32_t id = identifier(wanted);
    if (((wanted & ~(flags | identifier_mask)) != 0U) || is_restricted(id)) {
        return AbortCode::value_range;
    }
    const bool stays_in_use = in_use && ((flags & not_valid & wanted) == 0U);
    return (stays_in_use && (id != identifier(current))) ? AbortCode::device_state : AbortCode::none;
}

}  // namespace canproof::cob_id
