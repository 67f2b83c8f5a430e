// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/eds_services.hpp"

#include <array>
#include <string_view>

namespace canproof::host {

namespace {

struct Area {
    std::uint16_t first;
    std::uint16_t last;
    const char* service;
};

// The communication objects of CiA 301, 7.5.2, and the service to which each belongs.
constexpr std::array<Area, 15> areas{{{0x1001, 0x1001, "emcy"},
                                      {0x1003, 0x1003, "emcy"},
                                      {0x1005, 0x1007, "sync"},
                                      {0x100C, 0x100E, "guarding"},
                                      {0x1010, 0x1011, "store"},
                                      {0x1014, 0x1015, "emcy"},
                                      {0x1016, 0x1017, "heartbeat"},
                                      {0x1019, 0x1019, "sync"},
                                      {0x1029, 0x1029, "error_behaviour"},
                                      {0x1400, 0x15FF, "pdo"},
                                      {0x1600, 0x17FF, "pdo"},
                                      {0x1800, 0x19FF, "pdo"},
                                      {0x1A00, 0x1BFF, "pdo"},
                                      {0x1F80, 0x1F80, "nmt"},
                                      {0x1F91, 0x1F91, "nmt"}}};

const char* service_of(std::uint16_t index) {
    for (const Area& area : areas) {
        if (index >= area.first && index <= area.last) {
            return area.service;
        }
    }
    return "none";
}

bool is_live(std::uint16_t index) {
    return index == 0x1001 || index == 0x1002 || index == 0x1003;
}

}  // namespace

void assign_services(Part& part) {
    for (Object& object : part.objects) {
        const std::string service = service_of(object.index);
        for (Entry& entry : object.entries) {
            const bool is_command = object.index == 0x1003 || std::string_view{service} == "store";
            entry.service = service;
            entry.live = is_live(object.index);
            entry.stored =
                std::string_view{entry.access} == "rw" && !is_command && std::string_view{entry.type} != "DOMAIN";
            if (object.index == 0x1003 && object.kind != Object::Kind::var && entry.subindex == 0) {
                // A write of 0 empties the list (CiA 301, 7.5.2.4). The limits in a data sheet apply to the counts that
                // can be read, not to the value that can be written.
                entry.range = Range{};
                entry.range.values = {std::int64_t{0}};
            }
        }
    }
}

}  // namespace canproof::host
