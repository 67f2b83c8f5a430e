// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/read_xdd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "host/base/one_line.hpp"
#include "host/datasheet/eds_numbers.hpp"
#include "host/datasheet/xdd_parameters.hpp"

namespace canproof::host {

namespace {

const std::string byte_order_mark = "\xEF\xBB\xBF";

/// Returns the text on one line and without blanks at its ends, like a value in an EDS.
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U; }, ' ');
    const auto first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Parses an index in hexadecimal digits. CiA 311 writes it without 0x, but some files contain 0x.
std::optional<std::uint64_t> hexadecimal(const std::string& text) {
    return eds_unsigned(lower_case(text).rfind("0x", 0) == 0 ? text : "0x" + text);
}

class XddReader {
  public:
    XddReader(const std::string& text, const EdsTelling& tell) : tell_{tell} {
        const bool marked = text.rfind(byte_order_mark, 0) == 0;
        const std::string plain = marked ? text.substr(byte_order_mark.size()) : text;
        for (std::size_t at = plain.find('\n'); at != std::string::npos; at = plain.find('\n', at + 1)) {
            line_ends_.push_back(at);
        }
        const auto outcome = document_.load_buffer(plain.data(), plain.size());
        if (!outcome) {
            tell_.fault(line_at(outcome.offset), fmt::format("the file is no valid XML: {}", outcome.description()),
                        "correct the XML, or name an EDS, DCF or XDD file");
        }
        sound_ = static_cast<bool>(outcome);
    }

    IniFile read() {
        const pugi::xml_node list = sound_ ? found("CANopenObjectList") : pugi::xml_node{};
        if (sound_ && !list) {
            tell_.fault(1, "the XML contains no CANopenObjectList of CiA 311", "name an EDS, DCF or XDD file");
        }
        if (!list) {
            return {};
        }
        const XddParameters parameters{document_};
        device_info();
        IniSection& listed = section("OptionalObjects", list);
        for (const pugi::xml_node& object : list.children()) {
            if (local_name(object) == "CANopenObject") {
                add_object(object, listed, parameters);
            }
        }
        set(listed, "SupportedObjects", std::to_string(listed.values.size()), list);
        file_.sort_values();
        return std::move(file_);
    }

  private:
    unsigned line_at(std::ptrdiff_t offset) const {
        const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
        return static_cast<unsigned>(std::lower_bound(line_ends_.begin(), line_ends_.end(), at) - line_ends_.begin()) +
               1U;
    }
    unsigned line_of(const pugi::xml_node& node) const { return line_at(node.offset_debug()); }

    pugi::xml_node found(const char* name) const {
        return document_.find_node([&](const pugi::xml_node& node) { return local_name(node) == name; });
    }

    IniSection& section(const std::string& name, const pugi::xml_node& node) {
        return file_.sections().emplace(lower_case(name), IniSection{name, line_of(node), {}}).first->second;
    }
    /// Adds a value of a key, unless the text is empty. If a key has several values, sort_values() keeps the first.
    void set(IniSection& section, const std::string& key, const std::string& text, const pugi::xml_node& node) {
        const std::string value = one_line(text);
        if (!value.empty()) {
            section.values.emplace_back(file_.keep(lower_case(key)), IniValue{file_.keep(value), line_of(node)});
        }
    }

    void device_info() {
        const pugi::xml_node identity = found("DeviceIdentity");
        IniSection& info = section("DeviceInfo", identity);
        set(info, "VendorName", child_named(identity, "vendorName").text().get(), identity);
        set(info, "ProductName", child_named(identity, "productName").text().get(), identity);
        set(info, "OrderCode", child_named(identity, "orderNumber").text().get(), identity);
        const pugi::xml_node rates = found("baudRate");
        for (const pugi::xml_node& rate : rates.children()) {
            set(info, "BaudRate_" + kilobits(rate.attribute("value").value()), "1", rate);
        }
        const pugi::xml_node features = found("CANopenGeneralFeatures");
        set(info, "LSS_Supported", features.attribute("layerSettingServiceSlave").as_bool() ? "1" : "0", features);
        const pugi::xml_node configured = found("deviceCommissioning");
        IniSection& commissioning = section("DeviceComissioning", configured ? configured : rates);
        set(commissioning, "NodeID", configured.attribute("nodeID").value(), configured);
        const pugi::xml_attribute rate = configured.attribute("actualBaudRate");
        set(commissioning, "BaudRate", kilobits((rate ? rate : rates.attribute("defaultValue")).value()),
            rate ? configured : rates);
    }

    /// Returns the number of a bit rate: `250` for `250 Kbps`. Returns an empty text when the rate does not begin with
    /// a number, as for a rate that the device detects.
    static std::string kilobits(const std::string& text) {
        const std::string number = text.substr(0, text.find_first_not_of("0123456789"));
        return number;
    }

    void add_object(const pugi::xml_node& node, IniSection& listed, const XddParameters& parameters) {
        const std::string text = node.attribute("index").value();
        const auto index = hexadecimal(text);
        if (!index || *index > 0xFFFFU) {
            tell_.note(line_of(node), fmt::format("`{}` is no index", text.substr(0, 40)), "it is ignored");
            return;
        }
        const std::string name = fmt::format("{:04X}", *index);
        if (file_.find(name) != nullptr) {
            tell_.note(line_of(node), fmt::format("object {}h is already in line {}", name, file_.find(name)->line),
                       "the first counts");
            return;
        }
        set(listed, std::to_string(listed.values.size() + 1), "0x" + name, node);
        IniSection& object = section(name, node);
        add_values(object, node, parameters);
        set(object, "SubNumber", node.attribute("subNumber").value(), node);
        for (const pugi::xml_node& sub : node.children()) {
            if (local_name(sub) == "CANopenSubObject") {
                add_sub_object(name, sub, parameters);
            }
        }
    }

    void add_sub_object(const std::string& index, const pugi::xml_node& node, const XddParameters& parameters) {
        const std::string text = node.attribute("subIndex").value();
        const auto subindex = hexadecimal(text);
        const std::string name = fmt::format("{}sub{:X}", index, subindex.value_or(0));
        if (!subindex || *subindex > 0xFEU) {
            tell_.note(line_of(node), fmt::format("`{}` is no sub-index", text.substr(0, 40)), "it is ignored");
        } else if (file_.find(name) != nullptr) {
            tell_.note(line_of(node), fmt::format("[{}] is already in line {}", name, file_.find(name)->line),
                       "the first counts");
        } else {
            add_values(section(name, node), node, parameters);
        }
    }

    /// Adds the values of an element. The attributes of the element have priority over those of the parameter to which
    /// it refers.
    void add_values(IniSection& into, const pugi::xml_node& node, const XddParameters& parameters) {
        const XddParameter parameter = parameters.find(node.attribute("uniqueIDRef").value());
        const auto both = [&](const char* key, const char* attribute, const std::string& otherwise) {
            const std::string own = one_line(node.attribute(attribute).value());
            set(into, key, own.empty() ? otherwise : own, node);
        };
        both("ParameterName", "name", parameter.name);
        both("ObjectType", "objectType", "");
        const std::string type = node.attribute("dataType").value();
        const bool prefixed = lower_case(type).rfind("0x", 0) == 0;
        set(into, "DataType", type.empty() ? parameter.data_type : (prefixed ? "" : "0x") + type, node);
        both("DefaultValue", "defaultValue", parameter.value);
        both("ParameterValue", "actualValue", parameter.configured_value);
        both("LowLimit", "lowLimit", parameter.low_limit);
        both("HighLimit", "highLimit", parameter.high_limit);
        const std::string mapping = node.attribute("PDOmapping").value();
        const std::string given = node.attribute("accessType").value();
        const std::string access = given.empty() ? parameter.access : given;
        const bool way = lower_case(access) == "rw" && (mapping == "TPDO" || mapping == "RPDO");
        set(into, "AccessType", !way ? access : mapping == "TPDO" ? "rwr" : "rww", node);
        const bool mapped = mapping == "TPDO" || mapping == "RPDO" || mapping == "optional" || mapping == "default";
        set(into, "PDOMapping", mapped ? "1" : mapping == "no" ? "0" : mapping, node);
    }

    const EdsTelling& tell_;
    std::vector<std::size_t> line_ends_;
    pugi::xml_document document_;
    bool sound_{false};
    IniFile file_;
};

}  // namespace

bool is_xml(const std::string& text) {
    const std::size_t start = text.rfind(byte_order_mark, 0) == 0 ? byte_order_mark.size() : 0;
    const auto first = text.find_first_not_of(" \t\r\n", start);
    return first != std::string::npos && text[first] == '<';
}

IniFile read_xdd(const std::string& text, const EdsTelling& tell) {
    return XddReader{text, tell}.read();
}

}  // namespace canproof::host
