// SPDX-License-Identifier: Apache-2.0
// Checks DataType, AccessType and PDOMapping of each entry, and their combination.
#include "host/datasheet/check/entry_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/cia301.hpp"
#include "host/datasheet/eds_numbers.hpp"

namespace canproof::host {

namespace {

constexpr auto error = EdsSeverity::error;
constexpr auto warning = EdsSeverity::warning;
constexpr const char* type_source = "CiA 306, DataType; CiA 301, data types";
constexpr const char* access_source = "CiA 306, AccessType";
constexpr const char* mapping_source = "CiA 306, PDOMapping";

using Kind = EdsDataType::Kind;

class EntryCheck {
  public:
    EntryCheck(const EdsSheet& sheet, const EdsSheetEntry& entry, EdsFindings& findings)
        : sheet_{sheet}, entry_{entry}, findings_{findings} {}

    void run() {
        check_type();
        check_access();
        check_flag();
        if (entry_.type != nullptr) {
            check_domain();
            check_mappable();
        }
        if (entry_.access == "const" && entry_.value == nullptr && !is_domain()) {
            findings_.add("const-default", entry_.section->line,
                          entry_.title() + " has the access const, but no default");
        }
    }

  private:
    const IniValue* text(const char* key) const { return entry_.section->filled(key); }
    bool is_domain() const {
        const IniValue* code = text("ObjectType");
        return (code != nullptr && eds_unsigned(code->text) == std::uint64_t{2}) ||
               (entry_.type != nullptr && entry_.type->kind == Kind::domain);
    }

    void check_type() {
        const IniValue* given = text("DataType");
        if (given == nullptr) {
            if (!is_domain()) {
                findings_.add("data-type-missing", entry_.line_of("DataType"), entry_.title() + " has no DataType");
            }
            return;
        }
        const auto number = eds_unsigned(given->text);
        const auto described = number && *number <= 0xFFFF ? sheet_.object(static_cast<unsigned>(*number)) : nullptr;
        if (entry_.type == nullptr && described == nullptr) {
            findings_.add("data-type-unknown", given->line,
                          fmt::format("DataType {} of {} is unknown", given->text, entry_.title()));
        } else if (entry_.type != nullptr && entry_.type->kind == Kind::record) {
            findings_.add("data-type-record", given->line,
                          fmt::format("{} is a single value, but its data type {} is a RECORD", entry_.title(),
                                      entry_.type->name));
        }
    }

    void check_access() {
        const IniValue* given = text("AccessType");
        if (given == nullptr) {
            if (!is_domain()) {
                findings_.add("access-missing", entry_.line_of("AccessType"), entry_.title() + " has no AccessType");
            }
            return;
        }
        constexpr std::array<const char*, 6> known{"ro", "wo", "rw", "rwr", "rww", "const"};
        if (std::find(known.begin(), known.end(), entry_.access) == known.end()) {
            findings_.add("access-unknown", given->line,
                          fmt::format("AccessType {} of {} is unknown", given->text, entry_.title()));
        } else if (entry_.access != given->text) {
            findings_.add("access-case", given->line,
                          fmt::format("AccessType {} must be written {}", given->text, entry_.access),
                          replace_line(given->line, "AccessType=" + entry_.access));
        }
    }

    void check_flag() {
        const IniValue* given = text("PDOMapping");
        if (given != nullptr && eds_unsigned(given->text).value_or(2) > 1) {
            findings_.add("mapping-flag", given->line,
                          fmt::format("PDOMapping {} of {} is neither 0 nor 1", given->text, entry_.title()));
        }
    }

    void check_domain() {
        const IniValue* code = text("ObjectType");
        const bool is_object = code != nullptr && eds_unsigned(code->text) == std::uint64_t{2};
        const bool is_type = entry_.type->kind == Kind::domain;
        if (is_object && !is_type) {
            findings_.add(
                "domain-type", entry_.line_of("DataType"),
                fmt::format("{} has ObjectType 0x2 (DOMAIN), but the data type {}", entry_.title(), entry_.type->name));
        } else if (is_type && !is_object && !entry_.compact) {
            findings_.add(
                "domain-object", entry_.line_of("DataType"),
                fmt::format("{} has the data type DOMAIN, but its ObjectType is not 0x2 (DOMAIN)", entry_.title()));
        }
        if (is_type && entry_.value != nullptr) {
            findings_.add("domain-default", entry_.value->line, entry_.title() + " is a DOMAIN with a default");
        }
    }

    void check_mappable() {
        if (!entry_.mappable) {
            if (entry_.access == "rwr" || entry_.access == "rww") {
                findings_.add("mapping-direction-unused", entry_.line_of("AccessType"),
                              fmt::format("{} has the access {}, but no PDOMapping=1", entry_.title(), entry_.access));
            }
            return;
        }
        const bool is_text =
            entry_.type->kind == Kind::text || entry_.type->kind == Kind::octets || entry_.type->kind == Kind::unicode;
        if (is_text) {
            findings_.add(
                "mapping-text", entry_.line_of("PDOMapping"),
                fmt::format("{} can be mapped, but the length of a {} varies", entry_.title(), entry_.type->name));
        } else if (!entry_.type->fits_pdo()) {
            findings_.add(
                "mapping-type", entry_.line_of("PDOMapping"),
                fmt::format("{} can be mapped, but the type {} fits no PDO", entry_.title(), entry_.type->name));
        }
        if (entry_.access == "const") {
            findings_.add("mapping-const", entry_.line_of("PDOMapping"),
                          fmt::format("{} can be mapped, but has the access const", entry_.title()));
        }
        if (entry_.access == "rw") {
            findings_.add(
                "mapping-no-direction", entry_.line_of("AccessType"),
                fmt::format("{} can be mapped, but its access rw names no direction of the PDO", entry_.title()));
        }
        const bool parameters =
            entry_.index >= cia301::sdo_server_parameter && entry_.index <= cia301::last_communication_object;
        if (parameters) {
            findings_.add("mapping-parameter", entry_.line_of("PDOMapping"),
                          fmt::format("{} is a communication parameter, but can be mapped", entry_.title()));
        }
    }

    const EdsSheet& sheet_;
    const EdsSheetEntry& entry_;
    EdsFindings& findings_;
};

}  // namespace

const std::vector<EdsRule>& entry_rules() {
    static const std::vector<EdsRule> rules{
        {"data-type-missing", error, "an entry lacks DataType", "add the number of the data type", type_source},
        {"data-type-unknown", error, "a DataType is unknown",
         "write the number of a type of CiA 301, or describe the type in a section of its own", type_source},
        {"data-type-record", error, "a single value has the type of a RECORD",
         "write the data type of the single value", type_source},
        {"access-missing", error, "an entry lacks AccessType", "add ro, wo, rw, rwr, rww or const", access_source},
        {"access-unknown", error, "an AccessType is unknown", "write ro, wo, rw, rwr, rww or const", access_source},
        {"access-case", warning, "an AccessType has capital letters", "write small letters", access_source},
        {"const-default", error, "an entry with the access const has no default", "add its value as DefaultValue",
         access_source},
        {"domain-type", error, "an entry with ObjectType 0x2 (DOMAIN) has another data type than DOMAIN",
         "write DataType 0x000F", type_source},
        {"domain-object", warning, "an entry with the data type DOMAIN has another ObjectType than 0x2 (DOMAIN)",
         "write ObjectType 0x2", type_source},
        {"domain-default", warning, "a DOMAIN has a default", "remove the default", "CiA 306, DefaultValue"},
        {"mapping-flag", error, "PDOMapping is neither 0 nor 1", "write 0 or 1", mapping_source},
        {"mapping-type", error, "an entry can be mapped, but its data type fits no PDO", "write PDOMapping=0",
         mapping_source},
        {"mapping-text", warning, "an entry can be mapped, but its text or octets have no fixed length",
         "write PDOMapping=0, unless the value never has more than 8 octets", mapping_source},
        {"mapping-const", warning, "an entry with the access const can be mapped",
         "write PDOMapping=0, or AccessType=ro", mapping_source},
        {"mapping-no-direction", warning, "an entry can be mapped, but its access names no direction of the PDO",
         "write rwr for a transmit PDO, rww for a receive PDO", access_source},
        {"mapping-direction-unused", warning, "an entry cannot be mapped, but its access names a direction of the PDO",
         "write AccessType=rw, or PDOMapping=1", access_source},
        {"mapping-parameter", warning, "a communication parameter can be mapped", "write PDOMapping=0",
         mapping_source}};
    return rules;
}

void check_entry(const EdsSheet& sheet, EdsFindings& findings) {
    for (const auto& [index, object] : sheet.objects()) {
        const bool is_type = object.code == std::uint64_t{5} || object.code == std::uint64_t{6};
        const EdsSheetEntry* described = nullptr;  // all entries of CompactSubObj share one section: check it once
        for (const EdsSheetEntry& entry : object.entries) {
            const bool again = entry.compact && described != nullptr && described->compact;
            if (!is_type && !again) {
                EntryCheck{sheet, entry, findings}.run();
            }
            described = &entry;
        }
    }
}

}  // namespace canproof::host
