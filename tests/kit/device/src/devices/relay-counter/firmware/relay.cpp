// SPDX-License-Identifier: Apache-2.0
#include "devices/relay-counter/firmware/relay.hpp"

#include "firmware/base/requirement.hpp"
#include "firmware/base/table_row.hpp"
#include "generated/relay_counter/requirements.hpp"
#include "generated/relay_counter/tables.hpp"

namespace canproof::relay_counter {

static_assert(implements<req::RC_T_RELAY>);
bool contact_is_closed(const std::uint8_t command, const bool operational) noexcept {
    namespace table = generated::relay_counter::relay_contact;
    return cell_or(table::find(command, operational), &table::Row::closed, false);
}

}  // namespace canproof::relay_counter
