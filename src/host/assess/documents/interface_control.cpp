// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/interface_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "host/assess/documents/applicability.hpp"
#include "host/assess/documents/error_tables.hpp"
#include "host/assess/documents/words.hpp"
#include "host/base/cia301.hpp"
#include "host/datasheet/eds_values.hpp"
#include "host/datasheet/entry_index.hpp"
#include "host/datasheet/entry_words.hpp"

namespace canproof::host {

namespace {

constexpr unsigned pdos = 512;
constexpr unsigned to_mapping = 0x200;
constexpr unsigned most_mapped = 64;
constexpr unsigned first_id = 1;
constexpr unsigned last_id = 127;

unsigned node_of(const Part& part) {
    const bool fits = part.info.node_id >= static_cast<int>(first_id) && part.info.node_id <= static_cast<int>(last_id);
    return fits ? static_cast<unsigned>(part.info.node_id) : first_id;
}

std::string identifier(const std::uint32_t cob_id) {
    const bool extended = (cob_id & cob_id_extended) != 0;
    const std::string text =
        extended ? fmt::format("{:08X}h (29 bit)", cob_id & 0x1FFFFFFFU) : fmt::format("{:03X}h", cob_id & 0x7FFU);
    return (cob_id & cob_id_switched_off) != 0 ? text + ", not valid as shipped" : text;
}

/// Returns the rows of boot-up, heartbeat and guarding: those that the device sends, and those that it receives.
std::vector<std::vector<std::string>> error_control_rows(const EntryIndex& entries, const unsigned node) {
    constexpr unsigned first_identifier = 0x700;
    const bool moved = entries.named(cia301::guarding_identifier, 0) != nullptr;
    const std::string own =
        identifier(entries.number(cia301::guarding_identifier, 0, node).value_or(first_identifier + node));
    const auto name_of = [&entries](const unsigned index) {
        return entries.named(index, 0) == nullptr ? std::string{} : fmt::format("{:04X}h", index);
    };
    std::vector<std::vector<std::string>> rows{
        {"Boot-up, heartbeat, answer to node guarding", "sent", own, "1", name_of(cia301::producer_heartbeat_time)},
        {"Guarding request", "received", own, "remote frame",
         moved ? name_of(cia301::guarding_identifier) : name_of(cia301::guard_time)}};
    if (entries.named(cia301::consumer_heartbeat_time, 0) != nullptr) {
        rows.push_back({"Heartbeat of another node", "received", "700h + node-ID in 1016h", "1", "1016h"});
    }
    return rows;
}

/// Returns the table of all messages except the PDOs.
DocumentTable message_table(const Part& part, const EntryIndex& entries, const Analysis& analysis) {
    const unsigned node = node_of(part);
    DocumentTable table{
        fmt::format("COB-IDs at node-ID {}", node), {"Message", "Direction", "COB-ID", "Bytes", "Object"}, {}};
    const auto fixed = [&](const char* name, const char* direction, const unsigned id, const char* bytes) {
        table.rows.push_back({name, direction, fmt::format("{:03X}h", id), bytes, ""});
    };
    fixed("NMT", "received", 0x000, "2");
    if (const auto sync = entries.number(cia301::sync_cob_id, 0, node)) {
        const bool counts = entries.number(cia301::sync_counter_overflow, 0, node).value_or(0) > 1;
        table.rows.push_back(
            {"SYNC", (*sync & 0x40000000U) != 0 ? "sent" : "received", identifier(*sync), counts ? "1" : "0", "1005h"});
    }
    const auto emcy = entries.number(cia301::emcy_cob_id, 0, node);
    table.rows.push_back({"EMCY", "sent", identifier(emcy.value_or(0x80 + node)), "8", emcy ? "1014h" : ""});
    fixed("SDO request", "received", 0x600 + node, "8");
    fixed("SDO response", "sent", 0x580 + node, "8");
    for (auto& row : error_control_rows(entries, node)) {
        table.rows.push_back(std::move(row));
    }
    if (part.info.lss) {
        fixed("LSS request", "received", 0x7E5, "8");
        fixed("LSS response", "sent", 0x7E4, "8");
    }
    for (const auto& one : analysis.messages) {
        if (one.device == part.name) {
            table.rows.push_back({fmt::format("{} ({})", one.message, joined_or(one.by)), one.direction, one.cob_id,
                                  one.bytes, one.object});
        }
    }
    return table;
}

std::string type_words(const std::optional<std::uint32_t>& type) {
    if (!type) {
        return "";
    }
    const std::string words = *type == 0     ? "synchronous, acyclic"
                              : *type <= 240 ? fmt::format("every {} SYNC", *type)
                              : *type == 252 ? "remote, synchronous"
                              : *type == 253 ? "remote, event"
                              : *type >= 254 ? "event"
                                             : "reserved";
    return fmt::format("{} ({})", *type, words);
}

/// Returns one text for each object that the PDO maps, such as `bit 0: 6411h:01 Voltage (16 bit)`. The first number is
/// the position of the object's first bit in the PDO.
std::vector<std::string> mapped_objects(const EntryIndex& entries, const unsigned index, const unsigned node) {
    std::vector<std::string> all;
    const unsigned count = std::min(entries.number(index + to_mapping, 0, node).value_or(0), most_mapped);
    unsigned at = 0;
    for (unsigned sub = 1; sub <= count; ++sub) {
        const std::uint32_t mapped = entries.number(index + to_mapping, sub, node).value_or(0);
        const unsigned bits = mapped & 0xFFU;
        const NamedEntry* target = entries.named(mapped >> 16U, (mapped >> 8U) & 0xFFU);
        all.push_back(target == nullptr
                          ? fmt::format("bit {}: gap of {} bit", at, bits)
                          : fmt::format("bit {}: {} {} ({} bit)", at, place_words(*target->object, *target->entry),
                                        full_name(*target), bits));
        at += bits;
    }
    return all;
}

DocumentTable pdo_table(const Part& part, const EntryIndex& entries, const bool received) {
    const unsigned node = node_of(part);
    DocumentTable table{received ? "RPDOs as shipped" : "TPDOs as shipped",
                        {"PDO", "COB-ID", "Transmission type", "Inhibit time", "Event timer", "Mapped objects"},
                        {}};
    const auto time = [&](const unsigned index, const unsigned sub, const double milliseconds) {
        const auto value = entries.number(index, sub, node);
        return !value ? "" : *value == 0 ? "off" : fmt::format("{:g} ms", *value * milliseconds);
    };
    const unsigned first = received ? cia301::rpdo_communication : cia301::tpdo_communication;
    for (unsigned index = first; index < first + pdos; ++index) {
        if (const auto cob_id = entries.number(index, 1, node)) {
            table.rows.push_back({fmt::format("{}PDO{}, {:04X}h", received ? "R" : "T", index - first + 1, index),
                                  identifier(*cob_id), type_words(entries.number(index, 2, node)), time(index, 3, 0.1),
                                  time(index, 5, 1.0), joined_or(mapped_objects(entries, index, node), "none")});
        }
    }
    return table;
}

DocumentTable service_table(const Part& part) {
    const auto yes = [](const bool value) { return std::string{value ? "yes" : "no"}; };
    const auto has = [&](const unsigned index) { return yes(count_objects(part, index, index) != 0); };
    std::vector<std::string> rates;
    for (const auto rate : bit_rates_of(part)) {
        rates.push_back(std::to_string(rate));
    }
    return {"Services",
            {"Service", "This device"},
            {{"Bit rates (bit/s)", joined_or(rates)},
             {"Bit rate as shipped", fmt::format("{} bit/s", part.info.bit_rate)},
             {"SDO, expedited and segmented", "yes"},
             {"SDO, block", yes(part.info.block_sdo)},
             {"LSS", yes(part.info.lss)},
             {"SYNC, 1005h", has(cia301::sync_cob_id)},
             {"Heartbeat producer, 1017h", has(cia301::producer_heartbeat_time)},
             {"Heartbeat consumer, 1016h", has(cia301::consumer_heartbeat_time)},
             {"Life guarding, 100Ch", has(cia301::guard_time)},
             {"Store parameters, 1010h", has(cia301::store_parameters)},
             {"Restore defaults, 1011h", has(cia301::restore_parameters)},
             {"TIME, 1012h", has(cia301::time_cob_id)},
             {"Abort code for limits", part.info.limit_abort == "range" ? "06090030h" : "06090031h and 06090032h"},
             {"1003h (error field) lists", part.info.error_list == "active" ? "active errors" : "past errors as well"},
             {"Event of TPDOs of type 254 and 255",
              count_objects(part, cia301::tpdo_communication, cia301::last_tpdo_communication) == 0 ? "none: no TPDO"
              : part.info.tpdo_trigger == "event_timer"                                             ? "the event timer"
                                                        : "a change of a mapped value"}}};
}

DocumentTable object_table(const Part& part) {
    DocumentTable table{
        "Object dictionary", {"Index", "Name", "Type", "Access", "Default", "Range", "PDO", "Stored", "Unit"}, {}};
    for (const auto& object : part.objects) {
        const Object sheet = as_in_sheet(object);
        for (const auto& entry : sheet.entries) {
            const bool counts = object.kind != Object::Kind::var && entry.subindex == 0;
            table.rows.push_back({place_words(object, entry), full_name({&object, &entry}), entry.type, entry.access,
                                  eds_default(entry), range_words(entry), entry.mapping == "none" ? "" : entry.mapping,
                                  entry.stored ? "yes" : "", counts ? "" : object.unit});
        }
    }
    return table;
}

DocumentTable emergency_table(const Register& content, const Part& part) {
    DocumentTable table{"Emergency codes", {"Error", "Code", "Table"}, {}};
    for (const auto& one : errors_of(content, part)) {
        table.rows.push_back({one.error, one.code, one.table});
    }
    return table;
}

}  // namespace

Document interface_control(const Register& content, const Part& part, const Analysis& analysis) {
    const EntryIndex entries{part};
    DocumentTable timing{"Timing of this device", {"Requirement", "Text", "Source"}, requirement_rows(part, "timing")};
    Chapter times{"Timing",
                  {"The requirements of kind timing define time-outs, delays and periods. Of the shared requirements, "
                   "the second table lists those that concern the services and objects of this device."},
                  {timing}};
    times.tables.push_back({"Timing of shared firmware in this device",
                            {"Requirement", "Text", "Source"},
                            requirement_rows(shared_rules_of(content, analysis.shared, part), "timing")});
    return {"interface-control",
            fmt::format("Interface control document of the {}", part.info.title),
            fmt::format("The device on the bus as shipped: COB-IDs, PDOs, services, timing, emergency codes, "
                        "objects. Manual: {}.",
                        manual_words(content, part)),
            {Chapter{"Messages",
                     {"COB-IDs that depend on the node-ID are given for the node-ID as shipped."},
                     {message_table(part, entries, analysis), pdo_table(part, entries, true),
                      pdo_table(part, entries, false)}},
             Chapter{"Services", {}, {service_table(part)}}, times,
             Chapter{"Emergency messages",
                     {"Bytes 0 and 1 contain the code, byte 2 contains 1001h (error register). The error matrix has "
                      "the details."},
                     {emergency_table(content, part)}},
             Chapter{"Objects", {}, {object_table(part)}}}};
}

}  // namespace canproof::host
