// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/acceptance.hpp"

#include <algorithm>

#include "firmware/canopen/cob_id.hpp"
#include "firmware/canopen/frame.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/index.hpp"

namespace canproof::host {

namespace {

namespace index = generated::canopen::index;

constexpr std::uint32_t nmt_identifier = 0x000U;
constexpr std::uint32_t sdo_request_base = 0x600U;
constexpr std::uint32_t extended_bit = 0x20000000U;  // bit 29 of a COB-ID entry: the identifier has 29 bits

class FilterList {
  public:
    explicit FilterList(const ObjectDictionary& objects) : objects_{objects} {}

    void add(std::uint32_t id) { add(AcceptanceFilter{id, 0x7FFU, false}); }
    /// Adds a filter for the identifier in a COB-ID entry. Adds no filter if the entry is missing, or if one of the
    /// bits `not_in_use` is set in it, because the message then does not exist.
    void add_entry(std::uint16_t index, std::uint8_t subindex, std::uint32_t not_in_use) {
        if (!objects_.has(index, subindex)) {
            return;
        }
        const std::uint32_t entry = objects_.read(index, subindex);
        if ((entry & not_in_use) != 0U) {
            return;
        }
        const bool extended = (entry & extended_bit) != 0U;
        add(AcceptanceFilter{entry & (extended ? 0x1FFFFFFFU : 0x7FFU), extended ? 0x1FFFFFFFU : 0x7FFU, extended});
    }
    std::vector<AcceptanceFilter> take() { return std::move(filters_); }

  private:
    void add(const AcceptanceFilter& one) {
        if (std::find(filters_.begin(), filters_.end(), one) == filters_.end()) {
            filters_.push_back(one);
        }
    }

    const ObjectDictionary& objects_;
    std::vector<AcceptanceFilter> filters_;
};

}  // namespace

const std::vector<AcceptanceFilter>& accept_everything() {
    static const std::vector<AcceptanceFilter> all{{0U, 0U, false}, {0U, 0U, true}};
    return all;
}

std::vector<AcceptanceFilter> acceptance_filters(const ObjectDictionary& objects, std::uint8_t node_id) {
    FilterList list{objects};
    list.add(nmt_identifier);
    list.add(generated::canopen::lss_request_cob_id);
    if (node_id == 0U || node_id == generated::canopen::unconfigured_node_id) {
        return list.take();
    }
    list.add(generated::canopen::guarding_cob_id_base + node_id);
    list.add(sdo_request_base + node_id);
    list.add_entry(index::sync_cob_id, 0U, 0U);  // bit 30 concerns only the producer: a node always receives SYNC
    list.add_entry(index::guarding_identifier, 0U, 0U);
    list.add_entry(index::time_cob_id, 0U, 0U);
    const TableView<ObjectRow>& rows = objects.tables().objects;
    const auto from = [](const ObjectRow& row, std::uint32_t wanted) { return row.index < wanted; };
    const ObjectRow* const last = std::lower_bound(rows.begin(), rows.end(), index::tpdo_mapping, from);
    for (const ObjectRow* row = std::lower_bound(rows.begin(), rows.end(), index::sdo_server_parameter, from);
         row != last; ++row) {
        const bool server = row->index < index::sdo_client_parameter;
        const bool pdo =
            (row->index & 0xFE00U) == index::rpdo_communication || (row->index & 0xFE00U) == index::tpdo_communication;
        if (server || pdo) {
            list.add_entry(row->index, 1U, cob_id::not_valid);
        }
    }
    for (unsigned sub = 1; objects.has(index::consumer_heartbeat_time, static_cast<std::uint8_t>(sub)) && sub <= 127;
         ++sub) {
        const std::uint32_t watched =
            (objects.read(index::consumer_heartbeat_time, static_cast<std::uint8_t>(sub)) >> 16U) & 0x7FU;
        if (watched != 0U) {
            list.add(generated::canopen::guarding_cob_id_base + watched);
        }
    }
    return list.take();
}

}  // namespace canproof::host
