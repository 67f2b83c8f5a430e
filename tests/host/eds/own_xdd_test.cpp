// The XDD of each device: every object and entry is there, and every attribute is of the set that CiA 311 allows.
#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <regex>
#include <set>

#include "host/cli/built_in.hpp"
#include "host/speccompiler/writers.hpp"

namespace canproof::host::test {

namespace {

using Words = std::set<std::string>;

bool is_of(const pugi::xml_node& node, const char* attribute, const Words& words) {
    return words.count(node.attribute(attribute).value()) == 1;
}

bool is_like(const pugi::xml_node& node, const char* attribute, const char* pattern) {
    return std::regex_match(node.attribute(attribute).value(), std::regex{pattern});
}

/// Attributes of what holds a value.
void check_value(const pugi::xml_node& node, const std::string& where) {
    EXPECT_TRUE(is_like(node, "dataType", "00[0-9A-F]{2}")) << where;
    EXPECT_TRUE(is_of(node, "accessType", {"const", "ro", "wo", "rw"})) << where;
    EXPECT_TRUE(is_of(node, "PDOmapping", {"no", "default", "optional", "TPDO", "RPDO"})) << where;
    EXPECT_STRNE(node.attribute("name").value(), "") << where;
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

TEST(OwnXdd, EveryEntryOfEveryDeviceStandsInItAsCia311Says) {
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
