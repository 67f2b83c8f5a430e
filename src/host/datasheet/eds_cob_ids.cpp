// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/eds_cob_ids.hpp"

#include <fmt/format.h>

#include <optional>

#include "host/base/cia301.hpp"

namespace canproof::host {

namespace {

constexpr std::int64_t does_not_exist = 0x80000000;
constexpr std::int64_t identifier = 0x1FFFFFFF;

struct CobId {
    std::int64_t base;
    bool node_id;
};

/// Returns the COB-ID that the pre-defined connection set gives a PDO; `first` is the index of the direction's first
/// PDO. The set contains four PDOs of each direction. For a later PDO, returns a COB-ID that switches the PDO off.
CobId of_pdo(unsigned index, unsigned first, std::int64_t base) {
    constexpr unsigned predefined = 4;
    const unsigned number = index - first;
    return number < predefined ? CobId{base + std::int64_t{0x100} * number, true} : CobId{does_not_exist, false};
}

/// Returns the COB-ID that CiA 301 gives an entry by default (7.3.5 and 7.5.2). Returns nothing for an entry without
/// such a COB-ID.
std::optional<CobId> usual(unsigned index, unsigned subindex) {
    if (index == cia301::sync_cob_id && subindex == 0) {
        return CobId{0x80, false};
    }
    if (index == cia301::guarding_identifier && subindex == 0) {
        return CobId{0x700, true};
    }
    if (index == cia301::emcy_cob_id && subindex == 0) {
        return CobId{0x80, true};
    }
    if (index >= cia301::rpdo_communication && index <= cia301::last_rpdo_communication && subindex == 1) {
        return of_pdo(index, cia301::rpdo_communication, 0x200);
    }
    if (index >= cia301::tpdo_communication && index <= cia301::last_tpdo_communication && subindex == 1) {
        return of_pdo(index, cia301::tpdo_communication, 0x180);
    }
    return std::nullopt;
}

}  // namespace

void mend_cob_ids(Part& part, const EdsTelling& tell) {
    for (Object& object : part.objects) {
        for (Entry& entry : object.entries) {
            const auto right = usual(object.index, entry.subindex);
            const auto* value = std::get_if<std::int64_t>(&entry.value);
            const bool is_zero = entry.type == "UNSIGNED32" && value != nullptr && !entry.node_id &&
                                 (*value & (identifier | does_not_exist)) == 0;
            if (!right || !is_zero) {
                continue;
            }
            entry.value = right->base;
            entry.node_id = right->node_id;
            tell.note(entry.default_place.line,
                      fmt::format("COB-ID of {:04X}h:{} is 0, which is the COB-ID of NMT commands", object.index,
                                  entry.subindex),
                      fmt::format("{}0x{:X} is assumed", right->node_id ? "$NODEID+" : "", right->base));
        }
    }
}

}  // namespace canproof::host
