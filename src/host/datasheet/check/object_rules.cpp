// SPDX-License-Identifier: Apache-2.0
// Checks objects and their sub-objects: ObjectType, SubNumber, sub-index 0, CompactSubObj.
#include "host/datasheet/check/object_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/cia301.hpp"
#include "host/datasheet/check/known_names.hpp"
#include "host/datasheet/eds_numbers.hpp"

namespace canproof::host {

namespace {

constexpr auto error = EdsSeverity::error;
constexpr auto warning = EdsSeverity::warning;
constexpr const char* source = "CiA 306, object sections";
constexpr const char* compact_source = "CiA 306, CompactSubObj";
constexpr const char* types_source = "CiA 306, ObjectType; CiA 301, object codes";

constexpr std::size_t longest_name = 241;  // greatest length of a ParameterName in characters (CiA 306)

class ObjectCheck {
  public:
    ObjectCheck(const EdsSheet& sheet, EdsFindings& findings) : sheet_{sheet}, findings_{findings} {}

    void run() {
        for (const unsigned index : {cia301::device_type, cia301::error_register, cia301::identity}) {
            if (sheet_.object(index) == nullptr) {
                findings_.add("object-mandatory", 1, fmt::format("there is no object {}", eds_index_text(index)));
            }
        }
        for (const auto& [index, object] : sheet_.objects()) {
            if (object.section == nullptr) {
                findings_.add("sub-alone", object.line(),
                              fmt::format("[{}] exists, but its object has no section [{:04X}]",
                                          object.subs.begin()->second->name, index));
                continue;
            }
            check_object(object);
            if (object.is_several()) {
                check_sub_number(object);
                check_sub_zero(object);
                check_subs(object);
            }
        }
        check_sections();
        check_compact_lists();
    }

  private:
    void check_object(const EdsSheetObject& object) {
        const IniSection& section = *object.section;
        const IniValue* type = section.filled("ObjectType");
        const IniValue* flags = section.filled("ObjFlags");
        if (type == nullptr) {
            findings_.add("object-type-missing", section.line, fmt::format("[{}] has no ObjectType", section.name),
                          object.subs.empty() && section.filled("DataType") != nullptr
                              ? insert_after_line(section.line, "ObjectType=0x7")
                              : std::vector<EdsEdit>{});
        }
        const std::uint64_t code = object.code.value_or(UINT64_MAX);
        if (code != 2 && (code < 5 || code > 9)) {
            findings_.add("object-type-unknown", type == nullptr ? section.line : type->line,
                          fmt::format("ObjectType {} is unknown", type == nullptr ? "" : type->text));
        }
        if ((code == 5 || code == 6) && object.index >= cia301::first_object) {
            findings_.add("object-type-place", type->line,
                          fmt::format("{} is described as a data type", object.title()));
        } else if (object.index < cia301::first_object && code != 5 && code != 6) {
            findings_.add("object-data-type", section.line,
                          fmt::format("[{}] is at the index of a data type, but describes none", section.name));
        }
        if (object.is_single() && !object.subs.empty()) {
            findings_.add("object-single-subs", section.line,
                          fmt::format("{} is a single value, but has sub-objects", object.title()));
        }
        if (object.index >= cia301::first_reserved_index) {
            findings_.add("object-reserved", section.line, fmt::format("{} is reserved", object.title()));
        }
        if (flags != nullptr && eds_unsigned(flags->text).value_or(4) > 3) {
            findings_.add("object-flags", flags->line,
                          fmt::format("ObjFlags {} is not a number from 0 to 3", flags->text));
        }
        const IniValue* subs = section.filled("SubNumber");
        if (object.is_single() && subs != nullptr && eds_unsigned(subs->text) != std::uint64_t{0}) {
            findings_.add("object-single-number", subs->line,
                          fmt::format("{} is a single value with SubNumber {}", object.title(), subs->text),
                          object.subs.empty() ? erase_line(subs->line) : std::vector<EdsEdit>{});
        }
        check_compact(object);
        check_own_values(object);
    }

    void check_compact(const EdsSheetObject& object) {
        const IniValue* compact = object.section->filled("CompactSubObj");
        if (compact == nullptr) {
            return;
        }
        const auto count = eds_unsigned(compact->text);
        if (!count || *count > 254) {
            findings_.add("compact-count", compact->line,
                          fmt::format("CompactSubObj {} is not a number from 0 to 254", compact->text));
        } else if (*count != 0 && !object.is_several()) {
            findings_.add("compact-single", compact->line,
                          fmt::format("{} is a single value with CompactSubObj", object.title()));
        } else if (*count != 0 && !object.subs.empty()) {
            findings_.add("compact-subs", compact->line,
                          fmt::format("{} has both CompactSubObj and the section [{}]", object.title(),
                                      object.subs.begin()->second->name));
        }
    }

    /// Reports DefaultValue, limits, PDOMapping and AccessType in the section of an ARRAY or RECORD with sub-objects,
    /// where these keys have a meaning only with CompactSubObj.
    void check_own_values(const EdsSheetObject& object) {
        if (!object.is_several() || object.compact != 0 || object.subs.empty()) {
            return;
        }
        for (const char* key : {"DefaultValue", "LowLimit", "HighLimit", "PDOMapping", "AccessType"}) {
            const IniValue* value = object.section->filled(key);
            if (value != nullptr) {
                findings_.add("object-own-value", value->line,
                              fmt::format("{} in [{}] has no meaning, because sub-objects describe the entries", key,
                                          object.section->name));
            }
        }
    }

    void check_sub_number(const EdsSheetObject& object) {
        if (object.compact != 0) {
            return;
        }
        if (object.subs.empty()) {
            findings_.add("object-no-subs", object.section->line, fmt::format("{} has no sub-objects", object.title()));
            return;
        }
        const std::string right = fmt::format("SubNumber={}", object.subs.size());
        const IniValue* said = object.section->filled("SubNumber");
        if (said == nullptr) {
            const IniValue* empty = object.section->find("SubNumber");
            findings_.add(
                "subnumber-missing", object.section->line, fmt::format("[{}] has no SubNumber", object.section->name),
                empty == nullptr ? insert_after_line(object.section->line, right) : replace_line(empty->line, right));
        } else if (eds_unsigned(said->text) != object.subs.size()) {
            findings_.add(
                "subnumber", said->line,
                fmt::format("SubNumber is {}, but {} sub-object(s) are described", said->text, object.subs.size()),
                replace_line(said->line, right));
        }
    }

    void check_sub_zero(const EdsSheetObject& object) {
        if (object.compact != 0 || object.subs.empty()) {
            return;
        }
        const EdsSheetEntry* zero = object.entry(0);
        if (zero == nullptr) {
            findings_.add("sub0-missing", object.section->line, fmt::format("{} has no sub-index 0", object.title()));
            return;
        }
        if (zero->type != nullptr && zero->type->number != 5) {
            findings_.add("sub0-type", zero->line_of("DataType"),
                          fmt::format("{} is {} instead of UNSIGNED8", zero->title(), zero->type->name));
        }
        const bool counts = cia301::is_pdo_mapping(object.index) || object.index == cia301::error_list;
        const bool communication = object.index < cia301::first_manufacturer_object;
        if (zero->access == "wo" || (communication && !counts && zero->access != "ro" && zero->access != "const" &&
                                     object.index != cia301::consumer_heartbeat_time && !zero->access.empty())) {
            findings_.add("sub0-access", zero->line_of("AccessType"),
                          fmt::format("{} has the access {}, which sub-index 0 of this object must not have",
                                      zero->title(), zero->access));
        }
        const auto value = zero->number();
        if (zero->value == nullptr) {
            findings_.add("sub0-default-missing", zero->section->line, fmt::format("{} has no default", zero->title()));
            return;
        }
        const unsigned highest = object.entries.back().sub;
        const bool fixed = zero->access == "ro" || zero->access == "const";
        const bool multiplexed = cia301::is_pdo_mapping(object.index) && value && value->bits >= 254;
        if (value && !counts && !multiplexed && (fixed ? value->bits != highest : value->bits > highest)) {
            findings_.add(
                "sub0-value", zero->value->line,
                fmt::format("{} is {}, but the highest sub-index is {}", zero->title(), value->bits, highest));
        }
    }

    void check_subs(const EdsSheetObject& object) {
        if (object.code != std::uint64_t{8}) {
            return;
        }
        const EdsSheetEntry* first = nullptr;
        unsigned due = 0;
        for (const EdsSheetEntry& entry : object.entries) {
            if (entry.sub == 0) {
                continue;
            }
            if (entry.sub != ++due) {
                findings_.add("array-gap", entry.section->line,
                              fmt::format("there is no sub-index {:02X} before {}", due, entry.title()));
                due = entry.sub;
            }
            first = first == nullptr ? &entry : first;
            if (entry.type != nullptr && first->type != nullptr && entry.type != first->type) {
                findings_.add("array-types", entry.line_of("DataType"),
                              fmt::format("{} is {}, but {} is {}", entry.title(), entry.type->name, first->title(),
                                          first->type->name));
            }
        }
    }

    /// Checks ParameterName, ObjectType and the keys of every section that describes an object or a sub-object.
    void check_sections() {
        for (const auto& [name, section] : sheet_.ini().sections()) {
            const auto object = eds_object_name(name);
            if (!object) {
                continue;
            }
            const bool is_list =
                object->kind == EdsObjectName::Kind::name || object->kind == EdsObjectName::Kind::value;
            for (const auto& [key, value] : section.values) {
                if (known_key(name, key).empty()) {
                    findings_.add("object-key-unknown", value.line,
                                  fmt::format("{} is no key of [{}]", sheet_.line(value.line).name, section.name));
                }
            }
            const IniValue* title = is_list ? nullptr : section.filled("ParameterName");
            if (!is_list && title == nullptr) {
                findings_.add("object-name-missing", section.line,
                              fmt::format("[{}] has no ParameterName", section.name));
            } else if (title != nullptr && title->text.size() > longest_name) {
                findings_.add(
                    "object-name-long", title->line,
                    fmt::format("ParameterName has {} characters; {} are allowed", title->text.size(), longest_name));
            }
            const IniValue* type = section.filled("ObjectType");
            if (object->kind == EdsObjectName::Kind::sub && type != nullptr) {
                const std::uint64_t code = eds_unsigned(type->text).value_or(UINT64_MAX);
                if (code != 7 && code != 2) {
                    findings_.add("sub-object-type", type->line,
                                  fmt::format("[{}] has ObjectType {}", section.name, type->text));
                }
            }
        }
    }

    /// Checks all sections such as [1018Name] and [1018Value].
    void check_compact_lists() {
        for (const auto& [name, section] : sheet_.ini().sections()) {
            const auto found = eds_object_name(name);
            if (!found || (found->kind != EdsObjectName::Kind::name && found->kind != EdsObjectName::Kind::value)) {
                continue;
            }
            const EdsSheetObject* object = sheet_.object(found->index);
            if (object == nullptr || object->compact == 0) {
                findings_.add("compact-alone", section.line,
                              fmt::format("[{}] exists, but its object has no CompactSubObj", section.name));
                continue;
            }
            std::size_t count = 0;
            for (const auto& [key, value] : section.values) {
                if (key == "nrofentries") {
                    continue;
                }
                ++count;
                const auto sub = eds_unsigned(key);
                if (sub && (*sub == 0 || *sub > object->compact)) {
                    findings_.add("compact-beyond", value.line,
                                  fmt::format("[{}] has an entry {}, but CompactSubObj is {}", section.name, *sub,
                                              object->compact));
                }
            }
            const IniValue* said = section.find("NrOfEntries");
            const std::string right = fmt::format("NrOfEntries={}", count);
            if (said == nullptr || eds_unsigned(said->text) != count) {
                findings_.add(
                    "compact-entries", said == nullptr ? section.line : said->line,
                    fmt::format("NrOfEntries of [{}] is not {}", section.name, count),
                    said == nullptr ? insert_after_line(section.line, right) : replace_line(said->line, right));
            }
        }
    }

    const EdsSheet& sheet_;
    EdsFindings& findings_;
};

}  // namespace

const std::vector<EdsRule>& object_rules() {
    static const std::vector<EdsRule> rules{
        {"object-mandatory", error, "a mandatory object is missing",
         "describe 1000h (device type), 1001h (error register) and 1018h (identity)", "CiA 301, mandatory objects"},
        {"object-name-missing", error, "a section of an object lacks ParameterName", "add the name", source},
        {"object-name-long", warning, "ParameterName is longer than 241 characters", "shorten the name", source},
        {"object-key-unknown", warning, "an object has a key that CiA 306 does not define", "correct or remove the key",
         source},
        {"object-type-missing", warning, "ObjectType is missing",
         "add ObjectType: 0x7 for a single value, 0x8 for an ARRAY, 0x9 for a RECORD", types_source},
        {"object-type-unknown", error, "ObjectType is unknown", "write 0x2, 0x5, 0x6, 0x7, 0x8 or 0x9", types_source},
        {"object-type-place", error, "an object is described as a data type",
         "move the data type below 1000h, or write the ObjectType of an object", types_source},
        {"object-data-type", error, "the section of an index below 1000h describes no data type",
         "write ObjectType 0x5 (DEFTYPE) or 0x6 (DEFSTRUCT), or move the object to 1000h or above", types_source},
        {"object-reserved", warning, "an object has a reserved index", "move the object to another index",
         "CiA 301, object dictionary areas"},
        {"object-flags", error, "ObjFlags is not a number from 0 to 3", "write 0 to 3", source},
        {"object-single-subs", error, "a single value has sub-objects",
         "write ObjectType 0x8 (ARRAY) or 0x9 (RECORD), or remove the sub-objects", types_source},
        {"object-single-number", warning, "a single value has SubNumber", "remove SubNumber", source},
        {"object-no-subs", error, "an ARRAY or RECORD has no sub-objects",
         "describe the sub-objects, or use CompactSubObj", source},
        {"object-own-value", warning,
         "an ARRAY or RECORD with sub-objects has a default, limit, mapping or access of its own",
         "move the key to the sections of the sub-objects", source},
        {"sub-alone", error, "a sub-object is described, but not its object", "describe the object", source},
        {"sub-object-type", error, "the ObjectType of a sub-object is not that of a single value",
         "write ObjectType 0x7, or 0x2 for a DOMAIN", types_source},
        {"subnumber-missing", error, "an ARRAY or RECORD lacks SubNumber", "add the number of sub-objects", source},
        {"subnumber", error, "SubNumber differs from the number of sub-objects that are described",
         "write the number of sub-objects, sub-index 0 included", source},
        {"sub0-missing", error, "an ARRAY or RECORD lacks sub-index 0",
         "describe sub-index 0, whose value is the highest sub-index", "CiA 301, sub-index 0"},
        {"sub0-type", error, "sub-index 0 is not UNSIGNED8", "write DataType 0x0005", "CiA 301, sub-index 0"},
        {"sub0-access", warning, "sub-index 0 is write-only, or can be written although CiA 301 makes it read-only",
         "write ro or const; rw is allowed in 1003h, 1016h, PDO mappings and objects from 2000h on",
         "CiA 301, sub-index 0"},
        {"sub0-default-missing", warning, "sub-index 0 has no default",
         "write the highest sub-index (in 1003h the number of errors, in a PDO mapping the number of mapped objects)",
         "CiA 301, sub-index 0"},
        {"sub0-value", error, "the default of sub-index 0 is not the highest sub-index", "write the highest sub-index",
         "CiA 301, sub-index 0"},
        {"array-gap", error, "the sub-indices of an ARRAY have a gap",
         "describe every sub-index, or write ObjectType 0x9 (RECORD)", "CiA 301, ARRAY"},
        {"array-types", error, "the entries of an ARRAY have several data types",
         "write the same type in all entries, or ObjectType 0x9 (RECORD)", "CiA 301, ARRAY"},
        {"compact-count", error, "CompactSubObj is not a number from 0 to 254", "write the number of entries",
         compact_source},
        {"compact-single", error, "a single value has CompactSubObj",
         "write ObjectType 0x8 (ARRAY) or 0x9 (RECORD), or remove CompactSubObj", compact_source},
        {"compact-subs", warning, "an object has CompactSubObj and sections of sub-objects",
         "describe the entries either by CompactSubObj or by sections", compact_source},
        {"compact-alone", error, "there is a section of names or values, but its object has no CompactSubObj",
         "add CompactSubObj to the object", compact_source},
        {"compact-beyond", error, "the number of a name or value is not from 1 to CompactSubObj", "correct the number",
         compact_source},
        {"compact-entries", error, "NrOfEntries is missing, or differs from the number of entries in its section",
         "write the number of entries", compact_source}};
    return rules;
}

void check_object(const EdsSheet& sheet, EdsFindings& findings) {
    ObjectCheck{sheet, findings}.run();
}

}  // namespace canproof::host
