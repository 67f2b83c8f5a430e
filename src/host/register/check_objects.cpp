// SPDX-License-Identifier: Apache-2.0
#include "host/register/check_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/cia301.hpp"
#include "host/register/check_limits.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

// A PDO has at most 64 bits, each of which can be mapped alone (CiA 301, 7.5.2.36).
constexpr std::size_t most_mapping_entries = 64;
constexpr std::size_t image_limit = 0xFFFF;  // in bytes; EntryRow::offset has 16 bits

std::string name(const Object& object, const Entry& entry) {
    return fmt::format("{:04X}h:{}", object.index, entry.subindex);
}

bool can_write(const Entry& entry) {
    return entry.access == "rw" || entry.access == "wo";
}

void check_subindices(const Object& object, Faults& faults) {
    for (std::size_t i = 1; i < object.entries.size(); ++i) {
        if (object.entries[i].subindex == object.entries[i - 1].subindex) {
            faults.push_back({object.entries[i].place, fmt::format("{} occurs twice", name(object, object.entries[i])),
                              "give each entry its own sub-index"});
        }
    }
    const bool mapping = cia301::is_pdo_mapping(object.index);
    if (mapping && object.entries.size() > most_mapping_entries + 1) {
        faults.push_back({object.place,
                          fmt::format("{:04X}h has {} mapping entries", object.index, object.entries.size() - 1),
                          "remove entries: a PDO maps at most 64"});
    }
}

/// A range of object indices in CiA 301, 7.5.2, and the object code that CiA 301 gives to these objects.
struct FixedKind {
    unsigned first;
    unsigned last;
    Object::Kind kind;
};
constexpr std::array<FixedKind, 11> fixed_kinds{
    {{cia301::error_list, cia301::error_list, Object::Kind::array},
     {cia301::store_parameters, cia301::restore_parameters, Object::Kind::array},
     {cia301::consumer_heartbeat_time, cia301::consumer_heartbeat_time, Object::Kind::array},
     {cia301::identity, cia301::identity, Object::Kind::record},
     {cia301::verify_configuration, cia301::verify_configuration, Object::Kind::array},
     {cia301::emcy_consumers, cia301::error_behaviour, Object::Kind::array},
     {cia301::sdo_server_parameter, cia301::last_sdo_client_parameter, Object::Kind::record},
     {cia301::rpdo_communication, cia301::last_rpdo_communication, Object::Kind::record},
     {cia301::rpdo_mapping, cia301::last_rpdo_mapping, Object::Kind::record},
     {cia301::tpdo_communication, cia301::last_tpdo_communication, Object::Kind::record},
     {cia301::tpdo_mapping, cia301::last_tpdo_mapping, Object::Kind::record}}};

void check_kind(const Object& object, Faults& faults) {
    for (const FixedKind& row : fixed_kinds) {
        if (object.index >= row.first && object.index <= row.last && object.kind != row.kind) {
            const bool array = row.kind == Object::Kind::array;
            faults.push_back({object.place,
                              fmt::format("{:04X}h is {} in CiA 301", object.index, array ? "an ARRAY" : "a RECORD"),
                              fmt::format("add kind = \"{}\"", array ? "array" : "record")});
        }
    }
}

void check_use(const Object& object, const Entry& entry, Faults& faults) {
    const auto fault = [&](const std::string& what, const std::string& fix) {
        faults.push_back({entry.place, fmt::format("{} {}", name(object, entry), what), fix});
    };
    const bool sized = type_size(entry.type) > 0;
    if (entry.type == "REAL64") {
        fault("is a REAL64, which no service of the firmware supports", "use REAL32");
    }
    if (entry.length > 0 && !is_string_type(entry.type)) {
        fault(fmt::format("has a length, but the length of the type {} is fixed", entry.type), "remove length");
    }
    if (entry.mapping != "none" && !sized) {
        fault(fmt::format("has the type {} and cannot be mapped", entry.type), "set mapping = \"none\"");
    }
    if ((entry.mapping == "rpdo" || entry.mapping == "both") && !can_write(entry)) {
        fault(fmt::format("is {} and cannot be mapped into an RPDO", entry.access),
              "set mapping = \"tpdo\" or access = \"rw\"");
    }
    if ((entry.mapping == "tpdo" || entry.mapping == "both") && entry.access == "wo") {
        fault("is wo and cannot be mapped into a TPDO", "set mapping = \"rpdo\" or access = \"rw\"");
    }
    if (entry.stored && !can_write(entry)) {
        fault(fmt::format("is {} and cannot be stored", entry.access), "remove stored");
    }
    if (entry.live && entry.access == "const") {
        fault("is const, so it cannot be live (changed by the device)", "set access = \"ro\", or remove live");
    }
}

void check_string(const std::string& where, const Entry& entry, Faults& faults) {
    const auto* text = std::get_if<std::string>(&entry.value);
    if (text == nullptr) {
        faults.push_back(
            {entry.default_place, fmt::format("{} has no text as default", where), "give default = \"…\""});
    } else if (text->size() > entry.length) {
        faults.push_back({entry.default_place,
                          fmt::format("{} default has {} bytes, its length is {}", where, text->size(), entry.length),
                          "shorten the default or raise `length`"});
    }
}

void check_default(const Object& object, const Entry& entry, Faults& faults) {
    const std::string where = name(object, entry);
    const bool given = !std::holds_alternative<std::monostate>(entry.value);
    if (entry.type == "DOMAIN") {
        if (given) {
            faults.push_back(
                {entry.default_place, fmt::format("{} is a DOMAIN with a default", where), "remove default"});
        }
    } else if (is_string_type(entry.type)) {
        check_string(where, entry, faults);
    } else if (!given) {
        faults.push_back({entry.default_place, fmt::format("{} has no default", where),
                          fmt::format("write `default`: {}", type_words(entry.type))});
    } else if (!fits_type(entry.value, entry.type)) {
        faults.push_back({entry.default_place,
                          fmt::format("{} default {} is no {}", where, to_text(entry.value), entry.type),
                          fmt::format("use {}", type_words(entry.type))});
    }
}

void check_image_size(const Part& part, Faults& faults) {
    std::size_t bytes = 0;
    for (const Object& object : part.objects) {
        for (const Entry& entry : object.entries) {
            bytes += std::max(type_size(entry.type), entry.length);
        }
        if (bytes > image_limit) {
            faults.push_back(
                {object.place,
                 fmt::format("the objects of {} up to {:04X}h have {} bytes", part.name, object.index, bytes),
                 "shorten arrays or strings: a dictionary has at most 65535 bytes"});
            return;
        }
    }
}

}  // namespace

void check_objects(const Part& part, Faults& faults) {
    for (const Object& object : part.objects) {
        check_subindices(object, faults);
        check_kind(object, faults);
        for (const Entry& entry : object.entries) {
            if (is_known_type(entry.type)) {
                check_use(object, entry, faults);
                check_default(object, entry, faults);
            }
        }
    }
    check_image_size(part, faults);
    check_limits(part, faults);
}

}  // namespace canproof::host
