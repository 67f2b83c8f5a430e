// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/xdd_parameters.hpp"

#include <iterator>

namespace canproof::host {

namespace {

/// Returns the number that CiA 301, Table 44, gives an IEC 61131-3 type; nullptr when the type has none.
const char* type_number(const std::string& word) {
    static const std::map<std::string, const char*> numbers{
        {"BOOL", "0x0001"},  {"SINT", "0x0002"}, {"INT", "0x0003"},    {"DINT", "0x0004"},      {"USINT", "0x0005"},
        {"BYTE", "0x0005"},  {"CHAR", "0x0005"}, {"UINT", "0x0006"},   {"WORD", "0x0006"},      {"UDINT", "0x0007"},
        {"DWORD", "0x0007"}, {"REAL", "0x0008"}, {"STRING", "0x0009"}, {"BITSTRING", "0x000A"}, {"WSTRING", "0x000B"},
        {"LREAL", "0x0011"}, {"LINT", "0x0015"}, {"ULINT", "0x001B"},  {"LWORD", "0x001B"}};
    const auto found = numbers.find(word);
    return found == numbers.end() ? nullptr : found->second;
}

/// Returns the access type in the words of CiA 306. CiA 311 names the direction as seen from the process: a TPDO
/// contains an input.
std::string access_word(const std::string& word) {
    static const std::map<std::string, const char*> words{{"const", "const"},        {"read", "ro"},
                                                          {"write", "wo"},           {"readWrite", "rw"},
                                                          {"readWriteInput", "rwr"}, {"readWriteOutput", "rww"}};
    const auto found = words.find(word);
    return found == words.end() ? word : found->second;
}

std::string value_of(const pugi::xml_node& parameter, const pugi::xml_node& pattern, const char* name) {
    const pugi::xml_node own = child_named(parameter, name);
    return (own ? own : child_named(pattern, name)).attribute("value").value();
}

}  // namespace

std::string local_name(const pugi::xml_node& node) {
    const std::string name = node.name();
    const auto colon = name.find(':');
    return colon == std::string::npos ? name : name.substr(colon + 1);
}

pugi::xml_node child_named(const pugi::xml_node& node, const char* name) {
    return node.find_child([&](const pugi::xml_node& child) { return local_name(child) == name; });
}

XddParameters::XddParameters(const pugi::xml_document& document) {
    document.find_node([this](const pugi::xml_node& node) {
        const char* const id = node.attribute("uniqueID").value();
        if (*id != '\0') {
            nodes_.emplace(id, node);
        }
        return false;
    });
}

pugi::xml_node XddParameters::node_of(const std::string& id) const {
    const auto found = nodes_.find(id);
    return found == nodes_.end() ? pugi::xml_node{} : found->second;
}

/// Returns the type of a parameter. The type is a child element of the parameter, or the parameter refers to an array,
/// an enumeration or a derived type.
std::string XddParameters::type_of(const pugi::xml_node& parameter) const {
    constexpr int most_references = 8;  // a type can refer to itself, so the number of references is limited
    pugi::xml_node node = parameter;
    for (int i = 0; node && i < most_references; ++i) {
        pugi::xml_node next;
        for (const pugi::xml_node& child : node.children()) {
            const std::string name = local_name(child);
            if (const char* number = type_number(name)) {
                return number;
            }
            if (name == "dataTypeIDRef") {
                next = node_of(child.attribute("uniqueIDRef").value());
            }
        }
        node = next;
    }
    return {};
}

XddParameter XddParameters::find(const std::string& id) const {
    XddParameter found;
    const pugi::xml_node parameter = node_of(id);
    if (!parameter || local_name(parameter) != "parameter") {
        return found;
    }
    const pugi::xml_node pattern = node_of(parameter.attribute("templateIDRef").value());
    const pugi::xml_attribute access = parameter.attribute("access");
    const pugi::xml_attribute usual = pattern.attribute("access");
    found.name = child_named(parameter, "label").text().get();
    found.access = access_word(access ? access.value() : usual ? usual.value() : "read");
    found.data_type = type_of(parameter);
    if (found.data_type.empty()) {
        found.data_type = type_of(pattern);
    }
    found.value = value_of(parameter, pattern, "defaultValue");
    found.configured_value = value_of(parameter, pattern, "actualValue");
    const pugi::xml_node own = child_named(parameter, "allowedValues");
    const pugi::xml_node allowed = own ? own : child_named(pattern, "allowedValues");
    const pugi::xml_node range = child_named(allowed, "range");
    const bool single = range && !child_named(allowed, "value") && std::distance(allowed.begin(), allowed.end()) == 1;
    if (single) {  // a data sheet can contain only one range, so several ranges are left out
        found.low_limit = child_named(range, "minValue").attribute("value").value();
        found.high_limit = child_named(range, "maxValue").attribute("value").value();
    }
    return found;
}

}  // namespace canproof::host
