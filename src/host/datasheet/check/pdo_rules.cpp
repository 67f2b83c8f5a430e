// SPDX-License-Identifier: Apache-2.0
// Checks the PDO communication parameters: 1400h to 15FFh, 1800h to 19FFh.
#include "host/datasheet/check/pdo_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "host/base/cia301.hpp"
#include "host/datasheet/check/cob_ids.hpp"

namespace canproof::host {

namespace {

constexpr auto error = EdsSeverity::error;
constexpr auto warning = EdsSeverity::warning;
constexpr const char* source = "CiA 301, PDO communication parameter (1400h and 1800h)";
constexpr const char* mapping_source = "CiA 301, PDO parameters (1400h to 1BFFh)";

class PdoCheck {
  public:
    PdoCheck(const EdsSheet& sheet, const EdsSheetObject& object, EdsFindings& findings)
        : sheet_{sheet}, object_{object}, findings_{findings}, is_rpdo_{object.index < cia301::tpdo_communication} {}

    void run() {
        if (object_.code != std::uint64_t{9} && object_.section != nullptr) {
            findings_.add("pdo-record", object_.line(), fmt::format("{} is no RECORD", object_.title()));
        }
        for (const unsigned sub : {1U, 2U}) {
            if (object_.entry(sub) == nullptr) {
                findings_.add("pdo-entry-missing", object_.line(),
                              fmt::format("{} has no sub-index {}, {}", object_.title(), sub,
                                          sub == 1 ? "the COB-ID" : "the transmission type"));
            }
        }
        check_types();
        check_cob_id();
        check_transmission();
        check_times();
    }

  private:
    void check_types() {
        constexpr std::array<unsigned, 7> types{5, 7, 5, 6, 5, 6, 5};
        for (const EdsSheetEntry& entry : object_.entries) {
            if (entry.sub >= types.size()) {
                findings_.add("pdo-sub-unknown", entry.section->line,
                              fmt::format("{} is beyond sub-index 6", entry.title()));
            } else if (entry.type != nullptr && entry.type->number != types.at(entry.sub) && entry.sub != 0) {
                findings_.add("pdo-sub-type", entry.line_of("DataType"),
                              fmt::format("{} is {}, not {}", entry.title(), entry.type->name,
                                          eds_data_type(types.at(entry.sub))->name));
            }
            if (entry.sub == 4) {
                findings_.add("pdo-sub-reserved", entry.section->line, fmt::format("{} is reserved", entry.title()));
            }
        }
    }

    void check_cob_id() {
        const EdsSheetEntry* entry = object_.entry(1);
        const auto value = entry == nullptr ? std::nullopt : entry->number();
        if (!value || is_off(value->bits)) {
            return;
        }
        if (is_extended(value->bits)) {
            findings_.add("pdo-cob-id-extended", entry->value_line(),
                          fmt::format("{} is a COB-ID with an identifier of 29 bits", entry->title()));
            return;
        }
        for (unsigned node = 1; node <= 127; ++node) {
            const unsigned id = identifier(*value, node);
            if (is_reserved(id)) {
                findings_.add("pdo-cob-id-reserved", entry->value_line(),
                              fmt::format("{} is {:03X}h at node-ID {}, an identifier of another service",
                                          entry->title(), id, node));
                return;
            }
        }
        const unsigned number = object_.index & 0x1FFU;
        const unsigned usual = (is_rpdo_ ? 0x200U : 0x180U) + 0x100U * number;
        if (number < 4 && (!value->node_id || (value->bits & 0x7FFU) != usual)) {
            findings_.add("pdo-cob-id-default", entry->value_line(),
                          fmt::format("{} is {}, not $NODEID+0x{:X}", entry->title(), entry->value->text, usual));
        }
    }

    void check_transmission() {
        const EdsSheetEntry* entry = object_.entry(2);
        const auto value = entry == nullptr ? std::nullopt : entry->number();
        if (!value) {
            return;
        }
        const bool remote = value->bits == 252 || value->bits == 253;
        if ((value->bits >= 241 && value->bits <= 251) || (is_rpdo_ && remote)) {
            findings_.add("pdo-transmission-reserved", entry->value_line(),
                          fmt::format("{} is {}, a reserved transmission type", entry->title(), value->bits));
        }
        const EdsSheetEntry* cob_id = object_.entry(1);
        const std::optional<EdsNumber> written = cob_id == nullptr ? std::nullopt : cob_id->number();
        const bool has_id = written.has_value();
        const std::uint64_t id = written.value_or(EdsNumber{}).bits;
        constexpr std::uint64_t no_remote = 0x40000000;
        if (!is_rpdo_ && remote && has_id && (id & no_remote) != 0) {
            findings_.add("pdo-transmission-remote", entry->value_line(),
                          fmt::format("{} is {}: the PDO is sent on request, but its COB-ID allows no remote frame",
                                      entry->title(), value->bits));
        }
        const bool synchronous = value->bits <= 240 || value->bits == 252;
        if (synchronous && has_id && !is_off(id) && sheet_.object(cia301::sync_cob_id) == nullptr) {
            findings_.add("pdo-without-sync", entry->value_line(),
                          fmt::format("{} is {}: the PDO waits for SYNC, but there is no 1005h (COB-ID SYNC)",
                                      entry->title(), value->bits));
        }
    }

    void check_times() {
        if (is_rpdo_) {
            const EdsSheetEntry* useless = object_.entry(3);
            const auto time = useless == nullptr ? std::nullopt : useless->number();
            if (time && time->bits != 0) {
                findings_.add(
                    "pdo-rpdo-inhibit", useless->value_line(),
                    fmt::format("{} is {}, but a receive PDO has no inhibit time", useless->title(), time->bits));
            }
            if (object_.entry(6) != nullptr) {
                findings_.add("pdo-rpdo-sync-start", object_.entry(6)->section->line,
                              fmt::format("{} is the SYNC start value, which only transmit PDOs have",
                                          object_.entry(6)->title()));
            }
            return;
        }
        const EdsSheetEntry* start = object_.entry(6);
        const auto counter = start == nullptr ? std::nullopt : start->number();
        if (counter && counter->bits > 240) {
            findings_.add(
                "pdo-sync-start", start->value_line(),
                fmt::format("{} is {}, but the SYNC counter counts to 240 at most", start->title(), counter->bits));
        }
        const EdsSheetEntry* inhibit = object_.entry(3);
        const EdsSheetEntry* event = object_.entry(5);
        const auto gap = inhibit == nullptr ? std::nullopt : inhibit->number();  // inhibit time in units of 100 us
        const auto period = event == nullptr ? std::nullopt : event->number();   // event timer in ms
        if (gap && period && period->bits != 0 && period->bits * 10 < gap->bits) {
            findings_.add(
                "pdo-inhibit-event", event->value_line(),
                fmt::format("event timer {} ms is shorter than inhibit time {} x 100 us", period->bits, gap->bits));
        }
    }

    const EdsSheet& sheet_;
    const EdsSheetObject& object_;
    EdsFindings& findings_;
    bool is_rpdo_;
};

void check_same(const EdsSheet& sheet, EdsFindings& findings) {
    std::map<std::pair<std::uint64_t, bool>, std::string> used;
    for (const auto& [index, object] : sheet.objects()) {
        const EdsSheetEntry* entry = cia301::is_pdo_communication(index) ? object.entry(1) : nullptr;
        const auto value = entry == nullptr ? std::nullopt : entry->number();
        if (!value || is_off(value->bits)) {
            continue;
        }
        const auto [first, is_new] = used.emplace(std::pair{value->bits & 0x1FFFFFFFU, value->node_id}, object.title());
        if (!is_new) {
            findings.add("pdo-cob-id-same", entry->value_line(),
                         fmt::format("{} has the same COB-ID as {}", entry->title(), first->second));
        }
    }
}

}  // namespace

const std::vector<EdsRule>& pdo_rules() {
    static const std::vector<EdsRule> rules{
        {"pdo-no-mapping", error, "a PDO has communication parameters, but no mapping",
         "describe the mapping, whose index is 200h higher", mapping_source},
        {"pdo-no-communication", error, "a PDO has a mapping, but no communication parameters",
         "describe the communication parameters, whose index is 200h lower", mapping_source},
        {"pdo-record", error, "the communication parameters of a PDO are no RECORD", "write ObjectType 0x9", source},
        {"pdo-entry-missing", error, "the communication parameters of a PDO lack COB-ID or transmission type",
         "describe the missing entry", source},
        {"pdo-sub-type", error, "a communication parameter of a PDO has another data type than in CiA 301",
         "write the data type of CiA 301", source},
        {"pdo-sub-unknown", error, "the communication parameters of a PDO have an entry beyond sub-index 6",
         "remove the entry", source},
        {"pdo-sub-reserved", warning, "the communication parameters of a PDO have sub-index 4, which is reserved",
         "remove the entry", source},
        {"pdo-cob-id-extended", warning, "a PDO has an identifier of 29 bits by default",
         "write an identifier of 11 bits", source},
        {"pdo-cob-id-reserved", error, "the COB-ID of a PDO belongs to another service", "write another identifier",
         "CiA 301, restricted identifiers"},
        {"pdo-cob-id-default", warning, "one of the first four PDOs has another COB-ID than the pre-defined one",
         "write $NODEID and the pre-defined base, or set bit 31", "CiA 301, pre-defined connection set"},
        {"pdo-cob-id-same", error, "two PDOs have the same COB-ID",
         "give each PDO its own COB-ID, or set bit 31 of one COB-ID", source},
        {"pdo-transmission-reserved", error, "a PDO has a reserved transmission type",
         "write 0 to 240, 254 or 255; a transmit PDO may also have 252 or 253", source},
        {"pdo-transmission-remote", warning, "a PDO that is sent on request allows no remote frame",
         "clear bit 30 of the COB-ID", source},
        {"pdo-without-sync", warning, "a PDO is synchronous, but the device has no SYNC",
         "describe 1005h (COB-ID SYNC), or write transmission type 254 or 255", source},
        {"pdo-rpdo-inhibit", warning, "a receive PDO has an inhibit time", "write the inhibit time 0", source},
        {"pdo-rpdo-sync-start", warning, "a receive PDO has a SYNC start value", "remove the entry", source},
        {"pdo-sync-start", error, "the SYNC start value is above 240", "write 0 to 240", source},
        {"pdo-inhibit-event", warning, "the event timer is shorter than the inhibit time",
         "write a longer event timer: the inhibit time is in 100 us, the event timer in ms", source}};
    return rules;
}

void check_pdo(const EdsSheet& sheet, EdsFindings& findings) {
    for (const auto& [index, object] : sheet.objects()) {
        if (cia301::is_pdo_communication(index)) {
            PdoCheck{sheet, object, findings}.run();
            if (sheet.object(index + 0x200U) == nullptr) {
                findings.add("pdo-no-mapping", object.line(),
                             fmt::format("there is {}, but no {}", object.title(), eds_index_text(index + 0x200U)));
            }
        } else if (cia301::is_pdo_mapping(index) && sheet.object(index - 0x200U) == nullptr) {
            findings.add("pdo-no-communication", object.line(),
                         fmt::format("there is {}, but no {}", object.title(), eds_index_text(index - 0x200U)));
        }
    }
    check_same(sheet, findings);
}

}  // namespace canproof::host
