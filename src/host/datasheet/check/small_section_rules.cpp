// SPDX-License-Identifier: Apache-2.0
// Checks [DummyUsage], [Comments], and the keys of device configuration files.
#include "host/datasheet/check/small_section_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "host/base/cia301.hpp"
#include "host/datasheet/check/known_names.hpp"
#include "host/datasheet/eds_numbers.hpp"

namespace canproof::host {

namespace {

constexpr auto error = EdsSeverity::error;
constexpr auto warning = EdsSeverity::warning;
constexpr const char* comments_source = "CiA 306, [Comments]";
constexpr const char* dummy_source = "CiA 306, [DummyUsage]; CiA 301, dummy mapping";
constexpr const char* dcf_source = "CiA 306, device configuration file";

/// Returns the number of at most four digits that follows `stem` in the key; nothing for any other key. Both texts are
/// in lower case.
std::optional<unsigned> number_behind(std::string_view key, std::string_view stem) {
    const bool fits = key.size() > stem.size() && key.size() <= stem.size() + 4 && key.rfind(stem, 0) == 0 &&
                      key.find_first_not_of("0123456789", stem.size()) == std::string::npos;
    return fits ? std::optional{static_cast<unsigned>(std::stoul(std::string{key.substr(stem.size())}))} : std::nullopt;
}

void check_comments(const EdsSheet& sheet, EdsFindings& findings) {
    const IniSection* section = sheet.section("Comments");
    if (section == nullptr) {
        return;
    }
    std::map<unsigned, const IniValue*> lines;
    for (const auto& [key, value] : section->values) {
        if (const auto number = number_behind(key, "line")) {
            lines.emplace(*number, &value);
        } else if (key != "lines") {
            findings.add("comments-key-unknown", value.line,
                         fmt::format("{} is no key of [Comments]", sheet.line(value.line).name));
        }
    }
    const std::string right = fmt::format("Lines={}", lines.size());
    const IniValue* said = section->find("Lines");
    if (said == nullptr) {
        findings.add("comments-lines-missing", section->line, "[Comments] has no key Lines",
                     insert_after_line(section->line, right));
    } else if (eds_unsigned(said->text) != lines.size()) {
        findings.add("comments-count", said->line,
                     fmt::format("Lines is {}, but there are {} comment lines", said->text, lines.size()),
                     replace_line(said->line, right));
    }
    unsigned due = 0;
    std::vector<EdsEdit> edits;
    unsigned first = 0;
    for (const auto& [number, value] : lines) {
        if (number != ++due) {
            first = first == 0 ? value->line : first;
            edits.push_back({EdsEdit::Kind::replace, value->line, fmt::format("Line{}={}", due, value->text)});
        }
    }
    if (first != 0) {
        findings.add("comments-gap", first, "the comment lines are not numbered 1, 2, 3 …", std::move(edits));
    }
}

void check_dummies(const EdsSheet& sheet, EdsFindings& findings) {
    const IniSection* section = sheet.section("DummyUsage");
    const auto& objects = sheet.objects();
    const auto rpdo = objects.lower_bound(cia301::rpdo_mapping);
    if (section == nullptr) {
        if (rpdo != objects.end() && rpdo->first <= cia301::last_rpdo_mapping) {
            findings.add("dummy-missing", rpdo->second.line(), "there are receive PDOs, but there is no [DummyUsage]");
        }
        return;
    }
    for (const auto& [key, value] : section->values) {
        const std::string digits{key.rfind("dummy", 0) == 0 ? key.substr(5) : ""};
        const auto number = digits.size() == 4 ? eds_unsigned("0x" + digits) : std::nullopt;
        const EdsDataType* type = number ? eds_data_type(*number) : nullptr;
        if (type == nullptr || !type->fits_pdo() || *number == 0) {
            findings.add(
                "dummy-key", value.line,
                fmt::format("{} names no data type that can fill a gap in a PDO", sheet.line(value.line).name));
        } else if (eds_unsigned(value.text).value_or(2) > 1) {
            findings.add("dummy-flag", value.line,
                         fmt::format("{} {} is neither 0 nor 1", sheet.line(value.line).name, value.text));
        }
    }
}

void check_dcf(const EdsSheet& sheet, EdsFindings& findings) {
    constexpr std::array<unsigned, 8> rates{10, 20, 50, 125, 250, 500, 800, 1000};
    const IniSection* misspelled = sheet.section("DeviceCommissioning");
    if (misspelled != nullptr) {
        findings.add("dcf-section-name", misspelled->line, "[DeviceCommissioning] is not the spelling of CiA 306");
    }
    const IniSection* section = sheet.section("DeviceComissioning");
    if (section == nullptr) {
        return;
    }
    if (!sheet.is_dcf()) {
        findings.add("dcf-section", section->line,
                     "[DeviceComissioning] is in an EDS, but belongs in a device configuration file");
    }
    const IniValue* node = section->filled("NodeID");
    const auto number = node == nullptr ? std::nullopt : eds_unsigned(node->text);
    if (!number || *number < 1 || *number > 127) {
        findings.add("dcf-node-id", node == nullptr ? section->line : node->line,
                     node == nullptr ? "[DeviceComissioning] has no NodeID"
                                     : fmt::format("NodeID {} is not a number from 1 to 127", node->text));
    }
    const IniValue* rate = section->filled("Baudrate");
    const auto bits = rate == nullptr ? std::nullopt : eds_unsigned(rate->text);
    if (!bits || std::find(rates.begin(), rates.end(), *bits) == rates.end()) {
        findings.add("dcf-bit-rate", rate == nullptr ? section->line : rate->line,
                     rate == nullptr ? "[DeviceComissioning] has no Baudrate"
                                     : fmt::format("Baudrate {} is no bit rate of CiA 301 in kbit/s", rate->text));
    }
}

/// Reports keys of objects in an EDS that only a device configuration file may have.
void check_dcf_keys(const EdsSheet& sheet, EdsFindings& findings) {
    if (sheet.is_dcf()) {
        return;
    }
    for (const auto& [name, section] : sheet.ini().sections()) {
        for (const auto& [key, value] : section.values) {
            if (eds_object_name(name) && is_dcf_key(key)) {
                findings.add("dcf-key", value.line,
                             fmt::format("key {} is in an EDS, but belongs in a device configuration file",
                                         sheet.line(value.line).name));
            }
        }
    }
}

}  // namespace

const std::vector<EdsRule>& small_section_rules() {
    static const std::vector<EdsRule> rules{
        {"comments-lines-missing", error, "[Comments] lacks the key Lines", "add the number of comment lines",
         comments_source},
        {"comments-count", error, "Lines differs from the number of comment lines", "write the number of comment lines",
         comments_source},
        {"comments-gap", warning, "the comment lines are not numbered from 1 without gap",
         "number the comment lines from 1", comments_source},
        {"comments-key-unknown", warning, "[Comments] has a key that is no comment line",
         "write comments as Line1, Line2 …", comments_source},
        {"dummy-missing", warning, "a device with receive PDOs lacks [DummyUsage]",
         "add the section, with the data types that can be mapped as gaps", dummy_source},
        {"dummy-key", warning, "a key of [DummyUsage] names no data type of fixed length",
         "write Dummy0001 to Dummy0007", dummy_source},
        {"dummy-flag", error, "a value of [DummyUsage] is neither 0 nor 1", "write 0 or 1", dummy_source},
        {"dcf-section", warning, "an EDS has [DeviceComissioning]",
         "remove the section, or save the file as a device configuration file (.dcf)", dcf_source},
        {"dcf-section-name", warning, "[DeviceComissioning] is spelled with two m",
         "write [DeviceComissioning], with one m, as CiA 306 does", dcf_source},
        {"dcf-node-id", error, "a device configuration file has no node-ID from 1 to 127", "write the node-ID",
         dcf_source},
        {"dcf-bit-rate", error, "a device configuration file has no bit rate of CiA 301",
         "write 10, 20, 50, 125, 250, 500, 800 or 1000 (kbit/s)", dcf_source},
        {"dcf-key", warning, "an EDS has a key of a device configuration file",
         "remove the key (write a ParameterValue as DefaultValue), or save the file as .dcf", dcf_source}};
    return rules;
}

void check_small_section(const EdsSheet& sheet, EdsFindings& findings) {
    check_comments(sheet, findings);
    check_dummies(sheet, findings);
    check_dcf(sheet, findings);
    check_dcf_keys(sheet, findings);
}

}  // namespace canproof::host
