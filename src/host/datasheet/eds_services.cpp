// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/eds_services.hpp"

#include <array>
#include <string_view>

#include "host/base/cia301.hpp"

namespace canproof::host {

namespace {

struct Area {
    std::uint16_t first;
    std::uint16_t last;
    const char* service;
};

// The communication objects of CiA 301, 7.5.2, and the service to which each belongs.
constexpr std::array<Area, 15> areas{{{cia301::error_register, cia301::error_register, "emcy"},
                                      {cia301::error_list, cia301::error_list, "emcy"},
                                      {cia301::sync_cob_id, cia301::sync_window, "sync"},
                                      {cia301::guard_time, cia301::guarding_identifier, "guarding"},
                                      {cia301::store_parameters, cia301::restore_parameters, "store"},
                                      {cia301::emcy_cob_id, cia301::emcy_inhibit_time, "emcy"},
                                      {cia301::consumer_heartbeat_time, cia301::producer_heartbeat_time, "heartbeat"},
                                      {cia301::sync_counter_overflow, cia301::sync_counter_overflow, "sync"},
                                      {cia301::error_behaviour, cia301::error_behaviour, "error_behaviour"},
                                      {cia301::rpdo_communication, cia301::last_rpdo_communication, "pdo"},
                                      {cia301::rpdo_mapping, cia301::last_rpdo_mapping, "pdo"},
                                      {cia301::tpdo_communication, cia301::last_tpdo_communication, "pdo"},
                                      {cia301::tpdo_mapping, cia301::last_tpdo_mapping, "pdo"},
                                      {cia301::nmt_startup, cia301::nmt_startup, "nmt"},
                                      {cia301::self_starting_nodes, cia301::self_starting_nodes, "nmt"}}};

const char* service_of(std::uint16_t index) {
    for (const Area& area : areas) {
        if (index >= area.first && index <= area.last) {
            return area.service;
        }
    }
    return "none";
}

bool is_live(std::uint16_t index) {
    return index == cia301::error_register || index == cia301::manufacturer_status || index == cia301::error_list;
}

}  // namespace

void assign_services(Part& part) {
    for (Object& object : part.objects) {
        const std::string service = service_of(object.index);
        for (Entry& entry : object.entries) {
            const bool is_command = object.index == cia301::error_list || std::string_view{service} == "store";
            entry.service = service;
            entry.live = is_live(object.index);
            entry.stored =
                std::string_view{entry.access} == "rw" && !is_command && std::string_view{entry.type} != "DOMAIN";
            if (object.index == cia301::error_list && object.kind != Object::Kind::var && entry.subindex == 0) {
                // A write of 0 empties the list (CiA 301, 7.5.2.4). The limits in a data sheet apply to the counts that
                // can be read, not to the value that can be written.
                entry.range = Range{};
                entry.range.values = {std::int64_t{0}};
            }
        }
    }
}

}  // namespace canproof::host
