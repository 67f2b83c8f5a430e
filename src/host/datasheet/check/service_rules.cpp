// SPDX-License-Identifier: Apache-2.0
// Checks the objects of the communication services other than PDO: 1000h to 12FFh.
#include "host/datasheet/check/service_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "host/base/cia301.hpp"
#include "host/datasheet/check/cob_ids.hpp"
#include "host/datasheet/check/standard_objects.hpp"

namespace canproof::host {

namespace {

constexpr auto error = EdsSeverity::error;
constexpr auto warning = EdsSeverity::warning;
constexpr const char* standard_source = "CiA 301, objects of the communication area";

class ServiceCheck {
  public:
    ServiceCheck(const EdsSheet& sheet, EdsFindings& findings) : sheet_{sheet}, findings_{findings} {}

    void run() {
        check_standard();
        check_identity();
        check_errors();
        check_sync();
        check_error_control();
        check_consumers();
        check_storage();
        check_sdo_servers();
    }

  private:
    const EdsSheetEntry* entry(unsigned index, unsigned sub = 0) const { return sheet_.entry(index, sub); }
    std::optional<EdsNumber> number(unsigned index, unsigned sub = 0) const {
        const EdsSheetEntry* found = entry(index, sub);
        return found == nullptr ? std::nullopt : found->number();
    }
    std::uint64_t plain(unsigned index, unsigned sub = 0) const {
        const auto value = number(index, sub);
        return value ? value->bits : 0;
    }
    void add(const char* rule, unsigned index, unsigned sub, std::string what) {
        findings_.add(rule, entry(index, sub)->value_line(), std::move(what));
    }

    void check_standard() {
        for (const StandardObject301& standard : standard_objects_301()) {
            const EdsSheetObject* object = sheet_.object(standard.index);
            if (object == nullptr || object->section == nullptr) {
                continue;
            }
            if (object->code && *object->code != standard.code && object->code != std::uint64_t{2}) {
                findings_.add(
                    "standard-object-type", object->line(),
                    fmt::format("{} has ObjectType 0x{:X}, not 0x{:X}", object->title(), *object->code, standard.code));
                continue;
            }
            for (const EdsSheetEntry& one : object->entries) {
                if (one.sub == 0 && standard.code != 7) {
                    continue;  // the rules for sub-index 0 check this entry
                }
                if (standard.type != 0 && one.type != nullptr && one.type->number != standard.type) {
                    findings_.add("standard-type", one.line_of("DataType"),
                                  fmt::format("{} is {}, not {}", one.title(), one.type->name,
                                              eds_data_type(standard.type)->name));
                }
                const bool reads_only = one.access == "ro" || one.access == "const";
                if (standard.access == StandardObject301::Access::read && !reads_only && !one.access.empty()) {
                    findings_.add(
                        "standard-read-only", one.line_of("AccessType"),
                        fmt::format("{} has the access {}, but is read-only in CiA 301", one.title(), one.access));
                } else if (standard.access == StandardObject301::Access::write && reads_only) {
                    findings_.add(
                        "standard-writable", one.line_of("AccessType"),
                        fmt::format("{} has the access {}, but is writable in CiA 301", one.title(), one.access));
                }
            }
        }
    }

    void check_identity() {
        const EdsSheetObject* identity = sheet_.object(cia301::identity);
        if (identity == nullptr) {
            return;
        }
        if (identity->entry(1) == nullptr) {
            findings_.add("identity-vendor", identity->line(), "1018h (identity) has no sub-index 1, the vendor-ID");
        } else if (number(cia301::identity, 1) && plain(cia301::identity, 1) == 0) {
            add("identity-vendor-zero", cia301::identity, 1, "the vendor-ID, 1018h:01, is 0");
        }
        if (!identity->entries.empty() && identity->entries.back().sub > 4) {
            findings_.add("identity-sub", identity->entries.back().section->line,
                          fmt::format("{} is beyond sub-index 4, the serial number", identity->entries.back().title()));
        }
    }

    void check_errors() {
        if (number(cia301::error_list) && sheet_.object(cia301::error_list)->is_several() &&
            plain(cia301::error_list) != 0) {
            add("error-list-default", cia301::error_list, 0,
                fmt::format("1003h:00 (number of errors) is {} by default, not 0", plain(cia301::error_list)));
        }
        const EdsSheetEntry* count = entry(cia301::error_list);
        if (count != nullptr && !count->is_single && count->access != "rw" && !count->access.empty()) {
            findings_.add(
                "error-list-access", count->line_of("AccessType"),
                fmt::format("1003h:00 has the access {}, but a write of 0 must clear the error list", count->access));
        }
        const auto cob_id = number(cia301::emcy_cob_id);
        if (cob_id && !is_off(cob_id->bits) && (!cob_id->node_id || (cob_id->bits & 0x7FFU) != 0x80)) {
            add("emcy-cob-id", cia301::emcy_cob_id, 0,
                fmt::format("1014h (COB-ID EMCY) is {}, not $NODEID+0x80", entry(cia301::emcy_cob_id)->value->text));
        }
        if (entry(cia301::emcy_inhibit_time) != nullptr && entry(cia301::emcy_cob_id) == nullptr) {
            findings_.add("emcy-inhibit-alone", entry(cia301::emcy_inhibit_time)->section->line,
                          "there is 1015h (inhibit time EMCY), but no 1014h (COB-ID EMCY)");
        }
        const EdsSheetObject* behaviour = sheet_.object(cia301::error_behaviour);
        for (std::size_t i = 0; behaviour != nullptr && i < behaviour->entries.size(); ++i) {
            const EdsSheetEntry& one = behaviour->entries[i];
            const auto value = one.number();
            if (one.sub == 1 && value && value->bits > 2) {
                findings_.add("error-behaviour", one.value_line(),
                              fmt::format("{} is {}, not 0, 1 or 2", one.title(), value->bits));
            }
        }
    }

    void check_sync() {
        constexpr std::uint64_t producer = 0x40000000;
        const auto cob_id = number(cia301::sync_cob_id);
        if (cob_id && (cob_id->node_id || (cob_id->bits & 0x1FFFFFFFU) != 0x80)) {
            add("sync-cob-id", cia301::sync_cob_id, 0,
                fmt::format("1005h (COB-ID SYNC) is {}, not 0x80", entry(cia301::sync_cob_id)->value->text));
        }
        if (cob_id && (cob_id->bits & producer) != 0 && entry(cia301::sync_period) == nullptr) {
            add("sync-producer", cia301::sync_cob_id, 0,
                "bit 30 of 1005h makes the device a SYNC producer, but there is no 1006h (communication cycle period)");
        }
        for (const unsigned index : {cia301::sync_period, cia301::sync_window, cia301::sync_counter_overflow}) {
            if (entry(index) != nullptr && entry(cia301::sync_cob_id) == nullptr) {
                findings_.add("sync-alone", entry(index)->section->line,
                              fmt::format("there is {}, but no 1005h (COB-ID SYNC)", eds_index_text(index)));
            }
        }
        const std::uint64_t overflow = plain(cia301::sync_counter_overflow);
        if (overflow == 1 || overflow > 240) {
            add("sync-counter", cia301::sync_counter_overflow, 0,
                fmt::format("1019h (SYNC counter overflow) is {}, not 0 or 2 to 240", overflow));
        }
        const auto time = number(cia301::time_cob_id);
        if (time && (time->node_id || (time->bits & 0x1FFFFFFFU) != 0x100)) {
            add("time-cob-id", cia301::time_cob_id, 0,
                fmt::format("1012h (COB-ID TIME) is {}, not 0x100", entry(cia301::time_cob_id)->value->text));
        }
    }

    void check_error_control() {
        const bool guard = entry(cia301::guard_time) != nullptr;
        const bool factor = entry(cia301::life_time_factor) != nullptr;
        const bool heartbeat = entry(cia301::producer_heartbeat_time) != nullptr;
        if (guard != factor) {
            const unsigned there = guard ? cia301::guard_time : cia301::life_time_factor;
            findings_.add("guarding-half", entry(there)->section->line,
                          fmt::format("there is {}, but no {}", eds_index_text(there),
                                      eds_index_text(guard ? cia301::life_time_factor : cia301::guard_time)));
        }
        if (!heartbeat && !(guard && factor)) {
            findings_.add("error-control-missing", 1,
                          "there is neither 1017h (heartbeat) nor 100Ch with 100Dh (node guarding)");
        }
        if (plain(cia301::producer_heartbeat_time) != 0 && plain(cia301::guard_time) != 0 &&
            plain(cia301::life_time_factor) != 0) {
            add("heartbeat-guarding", cia301::producer_heartbeat_time, 0,
                fmt::format("1017h (heartbeat) is {} ms and 100Ch (guard time) is {} ms by default",
                            plain(cia301::producer_heartbeat_time), plain(cia301::guard_time)));
        }
    }

    void check_consumers() {
        const EdsSheetObject* object = sheet_.object(cia301::consumer_heartbeat_time);
        std::map<std::uint64_t, std::string> nodes;
        for (std::size_t i = 0; object != nullptr && i < object->entries.size(); ++i) {
            const EdsSheetEntry& one = object->entries[i];
            const auto value = one.number();
            if (one.sub == 0 || !value || value->bits == 0) {
                continue;
            }
            const std::uint64_t node = (value->bits >> 16U) & 0xFFU;
            const std::uint64_t time = value->bits & 0xFFFFU;
            if (value->bits > 0xFFFFFFU || node > 127 || (node == 0 && time != 0)) {
                findings_.add("heartbeat-consumer", one.value_line(),
                              fmt::format("{} is 0x{:08X}, but bits 24 to 31 must be 0 and bits 16 to 23 a node-ID",
                                          one.title(), value->bits));
            } else if (time != 0) {
                const auto [first, is_new] = nodes.emplace(node, one.title());
                if (!is_new) {
                    findings_.add("heartbeat-consumer-twice", one.value_line(),
                                  fmt::format("{} monitors node {}, which {} already monitors", one.title(), node,
                                              first->second));
                }
            }
        }
    }

    void check_storage() {
        for (const unsigned index : {cia301::store_parameters, cia301::restore_parameters}) {
            const EdsSheetObject* object = sheet_.object(index);
            for (std::size_t i = 0; object != nullptr && i < object->entries.size(); ++i) {
                const EdsSheetEntry& one = object->entries[i];
                const auto value = one.number();
                const std::uint64_t most = index == cia301::store_parameters ? 3 : 1;
                if (one.sub != 0 && value && value->bits > most) {
                    findings_.add(
                        "storage-default", one.value_line(),
                        fmt::format("{} is 0x{:X}, but a read returns what the device supports, a number from 0 to {}",
                                    one.title(), value->bits, most));
                }
            }
        }
    }

    void check_sdo_servers() {
        const auto& objects = sheet_.objects();
        const auto end = objects.upper_bound(cia301::last_sdo_server_parameter);
        for (auto at = objects.lower_bound(cia301::sdo_server_parameter); at != end; ++at) {
            const EdsSheetObject& object = at->second;
            if (object.code != std::uint64_t{9} && object.section != nullptr) {
                findings_.add("sdo-record", object.line(), fmt::format("{} is no RECORD", object.title()));
            }
            for (const unsigned sub : {1U, 2U}) {
                const EdsSheetEntry* one = object.entry(sub);
                const auto value = one == nullptr ? std::nullopt : one->number();
                const std::uint64_t base = sub == 1 ? 0x600 : 0x580;
                if (one == nullptr) {
                    findings_.add("sdo-entry-missing", object.line(),
                                  fmt::format("{} has no sub-index {}", object.title(), sub));
                } else if (at->first == cia301::sdo_server_parameter && value &&
                           (!value->node_id || value->bits != base)) {
                    findings_.add("sdo-default-cob-id", one->value_line(),
                                  fmt::format("{} is {}, not $NODEID+0x{:X}", one->title(), one->value->text, base));
                } else if (at->first != cia301::sdo_server_parameter && value && !is_off(value->bits) &&
                           !value->node_id && is_reserved(static_cast<unsigned>(value->bits & 0x7FFU))) {
                    findings_.add(
                        "sdo-further-cob-id", one->value_line(),
                        fmt::format("{} is {}, an identifier of another service", one->title(), one->value->text));
                }
                if (one != nullptr && at->first == cia301::sdo_server_parameter && one->access != "ro" &&
                    one->access != "const" && !one->access.empty()) {
                    findings_.add(
                        "sdo-default-access", one->line_of("AccessType"),
                        fmt::format("{} has the access {}, but must be read-only", one->title(), one->access));
                }
            }
        }
    }

    const EdsSheet& sheet_;
    EdsFindings& findings_;
};

}  // namespace

const std::vector<EdsRule>& service_rules() {
    static const std::vector<EdsRule> rules{
        {"standard-object-type", error, "an object of the communication area has another ObjectType than in CiA 301",
         "write the ObjectType of CiA 301", standard_source},
        {"standard-type", error, "an object of the communication area has another data type than in CiA 301",
         "write the data type of CiA 301", standard_source},
        {"standard-read-only", error, "an object that is read-only in CiA 301 can be written", "write ro or const",
         standard_source},
        {"standard-writable", error, "an object that is writable in CiA 301 cannot be written", "write rw",
         standard_source},
        {"identity-vendor", error, "1018h (identity) has no vendor-ID", "describe sub-index 1",
         "CiA 301, object 1018h"},
        {"identity-vendor-zero", warning, "the vendor-ID is 0", "write the number that CiA gave the manufacturer",
         "CiA 301, object 1018h"},
        {"identity-sub", error, "1018h (identity) has more than four values", "remove the entries beyond sub-index 4",
         "CiA 301, object 1018h"},
        {"error-list-default", warning, "1003h (error list) is not empty by default", "write 0",
         "CiA 301, object 1003h"},
        {"error-list-access", error, "1003h:00 (number of errors) cannot be cleared", "write rw",
         "CiA 301, object 1003h"},
        {"emcy-cob-id", warning, "1014h (COB-ID EMCY) differs from the pre-defined COB-ID", "write $NODEID+0x80",
         "CiA 301, object 1014h"},
        {"emcy-inhibit-alone", warning, "1015h (inhibit time EMCY) exists without 1014h (COB-ID EMCY)",
         "describe 1014h", "CiA 301, object 1015h"},
        {"error-behaviour", error, "1029h:01 (communication error) is above 2",
         "write 0 (pre-operational), 1 (no change) or 2 (stopped)", "CiA 301, object 1029h"},
        {"sync-cob-id", warning, "1005h (COB-ID SYNC) differs from the pre-defined COB-ID", "write 0x80",
         "CiA 301, object 1005h"},
        {"sync-producer", error, "a SYNC producer has no 1006h (communication cycle period)", "describe 1006h",
         "CiA 301, object 1006h"},
        {"sync-alone", error, "an object of SYNC exists without 1005h (COB-ID SYNC)", "describe 1005h",
         "CiA 301, object 1005h"},
        {"sync-counter", error, "1019h (SYNC counter overflow) is 1 or above 240", "write 0, or 2 to 240",
         "CiA 301, object 1019h"},
        {"time-cob-id", warning, "1012h (COB-ID TIME) differs from the pre-defined COB-ID",
         "write 0x100, and set bit 30 (producer) and bit 31 (consumer) as needed", "CiA 301, object 1012h"},
        {"guarding-half", error, "one of 100Ch (guard time) and 100Dh (life time factor) is missing",
         "describe both objects", "CiA 301, objects 100Ch and 100Dh"},
        {"error-control-missing", error, "the device has neither heartbeat nor node guarding",
         "describe 1017h (producer heartbeat time)", "CiA 301, error control services"},
        {"heartbeat-guarding", warning, "heartbeat and guarding are both on by default",
         "write 0 for one of the two: the heartbeat switches guarding off", "CiA 301, error control services"},
        {"heartbeat-consumer", error, "an entry of 1016h (consumer heartbeat time) has no node-ID from 1 to 127",
         "write node-ID and time in ms as 0x00NNTTTT", "CiA 301, object 1016h"},
        {"heartbeat-consumer-twice", error, "two entries of 1016h (consumer heartbeat time) monitor the same node",
         "write each node-ID once", "CiA 301, object 1016h"},
        {"storage-default", warning,
         "the default of 1010h (store) or 1011h (restore) is no value that a read can return",
         "write the value that a read returns: 1 means that the device stores or restores on command",
         "CiA 301, objects 1010h and 1011h"},
        {"sdo-record", error, "the parameters of an SDO server are no RECORD", "write ObjectType 0x9",
         "CiA 301, objects 1200h to 127Fh"},
        {"sdo-entry-missing", error, "an SDO server lacks a COB-ID", "describe sub-indices 1 and 2",
         "CiA 301, objects 1200h to 127Fh"},
        {"sdo-default-cob-id", error, "the COB-IDs of the first SDO server differ from the pre-defined COB-IDs",
         "write $NODEID+0x600 into sub-index 1 and $NODEID+0x580 into sub-index 2", "CiA 301, object 1200h"},
        {"sdo-default-access", warning, "the COB-IDs of the first SDO server can be written", "write ro or const",
         "CiA 301, object 1200h"},
        {"sdo-further-cob-id", error, "an SDO server after the first has an identifier of another service",
         "write another identifier, or set bit 31", "CiA 301, restricted identifiers"}};
    return rules;
}

void check_service(const EdsSheet& sheet, EdsFindings& findings) {
    ServiceCheck{sheet, findings}.run();
}

}  // namespace canproof::host
