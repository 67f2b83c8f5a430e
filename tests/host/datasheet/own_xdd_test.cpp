// SPDX-License-Identifier: Apache-2.0
// The XDD of each device has every object and entry, only attributes that CiA 311 allows, and elements in the order of
// its schema. The schema itself must not be redistributed; its rules for these files are written here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <pugixml.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "host/datasheet/write_xdd.hpp"
#include "host/selection/built_in.hpp"

namespace canproof::host::test {

namespace {

using Words = std::set<std::string>;
using List = std::vector<std::string>;

bool is_date(const std::string& text) {
    return std::regex_match(text, std::regex{"[0-9]{4}-(0[1-9]|1[0-2])-(0[1-9]|[12][0-9]|3[01])"});
}

List children_of(const pugi::xml_node& node) {
    List names;
    for (const auto& child : node.children()) {
        names.emplace_back(child.name());
    }
    return names;
}

/// Returns the names, each run of equal names as one name.
List without_repeats(List names) {
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

void check_attributes(const pugi::xml_node& node, const Words& required, const Words& optional) {
    Words there;
    for (const auto& attribute : node.attributes()) {
        there.insert(attribute.name());
        EXPECT_TRUE(required.count(attribute.name()) + optional.count(attribute.name()) == 1)
            << node.name() << " has " << attribute.name();
    }
    for (const auto& name : required) {
        EXPECT_EQ(there.count(name), 1U) << node.name() << " lacks " << name;
    }
}

/// Returns the number in a text: decimal, 0x…, or relative to the node-ID. Returns nothing for any other text.
std::optional<long double> number_in(std::string text, long double node_id) {
    const std::string variable = "$NODEID+";
    long double base = 0;
    if (text.rfind(variable, 0) == 0) {
        base = node_id;
        text.erase(0, variable.size());
    }
    char* end = nullptr;
    const long double value = std::strtold(text.c_str(), &end);
    return text.empty() || *end != '\0' ? std::nullopt : std::optional{base + value};
}

/// Checks that the limits of an element are numbers and that its default lies between them.
void check_limits(const pugi::xml_node& node, const std::string& where) {
    const auto low = node.attribute("lowLimit");
    const auto high = node.attribute("highLimit");
    const auto value = number_in(node.attribute("defaultValue").value(), 1);
    if (low) {
        ASSERT_TRUE(number_in(low.value(), 1)) << where << " " << low.value();
        EXPECT_TRUE(value && *number_in(low.value(), 1) <= *value) << where;
    }
    if (high) {
        ASSERT_TRUE(number_in(high.value(), 1)) << where << " " << high.value();
        EXPECT_TRUE(value && *value <= *number_in(high.value(), 1)) << where;
    }
}

void check_profile(const pugi::xml_node& profile, const std::string& type, const List& body) {
    EXPECT_EQ(children_of(profile), (List{"ProfileHeader", "ProfileBody"}));
    EXPECT_EQ(children_of(profile.child("ProfileHeader")),
              (List{"ProfileIdentification", "ProfileRevision", "ProfileName", "ProfileSource", "ProfileClassID",
                    "ISO15745Reference"}));
    EXPECT_EQ(children_of(profile.child("ProfileHeader").child("ISO15745Reference")),
              (List{"ISO15745Part", "ISO15745Edition", "ProfileTechnology"}));
    const auto node = profile.child("ProfileBody");
    EXPECT_EQ(node.attribute("xsi:type").value(), "ProfileBody_" + type + "_CANopen");
    EXPECT_TRUE(is_date(node.attribute("fileCreationDate").value()));
    check_attributes(node, {"xmlns:xsi", "xsi:type", "fileName", "fileCreator", "fileCreationDate", "fileVersion"}, {});
    EXPECT_EQ(children_of(node), body);
}

bool is_of(const pugi::xml_node& node, const char* attribute, const Words& words) {
    return words.count(node.attribute(attribute).value()) == 1;
}

bool is_like(const pugi::xml_node& node, const char* attribute, const char* pattern) {
    return std::regex_match(node.attribute(attribute).value(), std::regex{pattern});
}

/// Checks the attributes of an XML element that describes a value.
void check_value(const pugi::xml_node& node, const std::string& where) {
    EXPECT_TRUE(is_like(node, "dataType", "00[0-9A-F]{2}")) << where;
    EXPECT_TRUE(is_of(node, "accessType", {"const", "ro", "wo", "rw"})) << where;
    EXPECT_TRUE(is_of(node, "PDOmapping", {"no", "default", "optional", "TPDO", "RPDO"})) << where;
    EXPECT_STRNE(node.attribute("name").value(), "") << where;
    check_limits(node, where);
}

std::size_t check_object(const pugi::xml_node& object, const std::string& where) {
    EXPECT_TRUE(is_like(object, "index", "[0-9A-F]{4}")) << where;
    EXPECT_TRUE(is_of(object, "objectType", {"2", "7", "8", "9"})) << where;
    std::size_t entries = 0;
    for (const auto& sub : object.children("CANopenSubObject")) {
        ++entries;
        EXPECT_TRUE(is_like(sub, "subIndex", "[0-9A-F]{2}")) << where;
        EXPECT_TRUE(is_of(sub, "objectType", {"2", "7"})) << where;
        check_value(sub, where + ":" + sub.attribute("subIndex").value());
    }
    if (entries == 0) {
        check_value(object, where);
        return 1;
    }
    EXPECT_EQ(object.attribute("subNumber").as_uint(), entries) << where;
    return entries;
}

}  // namespace

TEST(OwnXdd, ElementsHaveTheOrderAndAttributesOfTheSchema) {
    for (const Part& part : built_in_register().parts) {
        if (!part.is_device()) {
            continue;
        }
        SCOPED_TRACE(part.name);
        pugi::xml_document document;
        ASSERT_TRUE(document.load_string(write_xdd(built_in_register(), part).c_str()));
        const auto root = document.child("ISO15745ProfileContainer");
        EXPECT_STREQ(root.attribute("xmlns").value(), "http://www.canopen.org/xml/1.0");
        ASSERT_EQ(children_of(root), (List{"ISO15745Profile", "ISO15745Profile"}));
        check_profile(root.first_child(), "Device", {"DeviceIdentity", "DeviceFunction"});
        check_profile(root.last_child(), "CommunicationNetwork",
                      {"ApplicationLayers", "TransportLayers", "NetworkManagement"});
        const auto device = root.first_child().child("ProfileBody");
        EXPECT_EQ(without_repeats(children_of(device.child("DeviceIdentity"))),
                  (List{"vendorName", "vendorID", "productName", "productID", "orderNumber"}));
        const auto network = root.last_child().child("ProfileBody");
        const auto list = network.child("ApplicationLayers").child("CANopenObjectList");
        check_attributes(list, {"mandatoryObjects", "optionalObjects"}, {"manufacturerObjects"});
        EXPECT_EQ(list.attribute("mandatoryObjects").as_uint() + list.attribute("optionalObjects").as_uint() +
                      list.attribute("manufacturerObjects").as_uint(),
                  part.objects.size());
        const auto rates = network.child("TransportLayers").child("PhysicalLayer").child("baudRate");
        check_attributes(rates, {"defaultValue"}, {});
        check_attributes(network.child("NetworkManagement").child("CANopenGeneralFeatures"), {"granularity"},
                         {"nrOfRxPDO", "nrOfTxPDO", "layerSettingServiceSlave", "bootUpSlave"});
        const Words of_values{"dataType", "accessType", "defaultValue", "lowLimit", "highLimit", "PDOmapping"};
        for (const auto& object : list.children("CANopenObject")) {
            Words optional = of_values;
            optional.insert("subNumber");
            check_attributes(object, {"index", "name", "objectType"}, optional);
            for (const auto& sub : object.children()) {
                EXPECT_STREQ(sub.name(), "CANopenSubObject");
                check_attributes(sub, {"subIndex", "name", "objectType"}, of_values);
            }
        }
    }
}

TEST(OwnXdd, EveryEntryOfEveryDeviceIsWrittenAsInCia311) {
    int devices = 0;
    for (const Part& part : built_in_register().parts) {
        if (!part.is_device()) {
            continue;
        }
        ++devices;
        pugi::xml_document document;
        ASSERT_TRUE(document.load_string(write_xdd(built_in_register(), part).c_str())) << part.name;
        const auto objects = document.select_nodes("//CANopenObjectList/CANopenObject");
        ASSERT_EQ(objects.size(), part.objects.size()) << part.name;
        for (std::size_t i = 0; i < part.objects.size(); ++i) {
            const auto node = objects[i].node();
            const std::string where = part.name + " " + node.attribute("index").value();
            EXPECT_EQ(std::stoul(node.attribute("index").value(), nullptr, 16), part.objects[i].index);
            EXPECT_EQ(check_object(node, where), part.objects[i].entries.size()) << where;
        }
        for (const auto& rate : document.select_nodes("//supportedBaudRate")) {
            EXPECT_TRUE(is_of(rate.node(), "value",
                              {"10 Kbps", "20 Kbps", "50 Kbps", "100 Kbps", "125 Kbps", "250 Kbps", "500 Kbps",
                               "800 Kbps", "1000 Kbps"}))
                << part.name;
        }
    }
    EXPECT_EQ(devices, 4);
}

}  // namespace canproof::host::test
