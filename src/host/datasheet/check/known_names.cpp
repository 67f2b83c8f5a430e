// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/check/known_names.hpp"

#include <initializer_list>
#include <map>
#include <vector>

#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

namespace {

/// Maps words in lower case to the spelling of CiA 306.
struct Words {
    Words(std::initializer_list<const char*> all) {
        for (const char* word : all) {
            spelled.emplace(lower_case(word), word);
        }
    }
    std::map<std::string, std::string> spelled;
};

struct Section {
    const char* name;
    Words keys;
};

const Words dcf_keys{"ParameterValue", "Denotation", "UploadFile", "DownloadFile", "ParamRefd"};

/// Returns the sections with fixed names. A # at the end of a key stands for any number.
const std::map<std::string, Section>& sections() {
    static const std::vector<Section> listed{
        {"FileInfo",
         {"FileName", "FileVersion", "FileRevision", "EDSVersion", "Description", "CreationTime", "CreationDate",
          "CreatedBy", "ModificationTime", "ModificationDate", "ModifiedBy", "LastEDS"}},
        {"DeviceInfo", {"VendorName",           "VendorNumber",   "ProductName",
                        "ProductNumber",        "RevisionNumber", "OrderCode",
                        "BaudRate_10",          "BaudRate_20",    "BaudRate_50",
                        "BaudRate_125",         "BaudRate_250",   "BaudRate_500",
                        "BaudRate_800",         "BaudRate_1000",  "SimpleBootUpMaster",
                        "SimpleBootUpSlave",    "Granularity",    "DynamicChannelsSupported",
                        "GroupMessaging",       "NrOfRXPDO",      "NrOfTXPDO",
                        "LSS_Supported",        "CompactPDO",     "ExtendedBootUpMaster",
                        "ExtendedBootUpSlave",  "NG_Slave",       "NG_Master",
                        "NrOfNG_MonitoredNodes"}},
        {"DummyUsage", {"Dummy#"}},
        {"Comments", {"Lines", "Line#"}},
        {"MandatoryObjects", {"SupportedObjects", "#"}},
        {"OptionalObjects", {"SupportedObjects", "#"}},
        {"ManufacturerObjects", {"SupportedObjects", "#"}},
        {"DeviceComissioning",
         {"NodeID", "NodeName", "Baudrate", "NetNumber", "NetworkName", "CANopenManager", "LSS_SerialNumber",
          "NodeRefd", "NetRefd"}},
        {"DynamicChannels", {"NrOfSeg", "Type#", "Dir#", "Range#", "PPOffset#"}},
        {"SupportedModules", {"NrOfEntries"}},
        {"ConnectedModules", {"NrOfEntries", "#"}},
        {"StandardDataTypes", {"0x#"}},
        {"Tools", {"Items"}},
    };
    static const std::map<std::string, Section> all = [] {
        std::map<std::string, Section> by_name;
        for (const Section& section : listed) {
            by_name.emplace(lower_case(section.name), section);
        }
        return by_name;
    }();
    return all;
}

const Words object_keys{"ParameterName", "ObjectType",    "DataType",     "AccessType",
                        "DefaultValue",  "LowLimit",      "HighLimit",    "PDOMapping",
                        "SubNumber",     "CompactSubObj", "ObjFlags",     "ParameterValue",
                        "Denotation",    "UploadFile",    "DownloadFile", "ParamRefd"};
const Words compact_keys{"NrOfEntries", "#"};

std::string in_words(const Words& words, std::string_view key) {
    const std::string lower = lower_case(key);
    const auto found = words.spelled.find(lower);
    if (found != words.spelled.end()) {
        return found->second;
    }
    for (const auto& [word, spelled] : words.spelled) {
        const std::size_t stem = word.size() - 1;
        const bool numbered = word.back() == '#' && lower.size() > stem && lower.compare(0, stem, word, 0, stem) == 0 &&
                              lower.find_first_not_of("0123456789abcdef", stem) == std::string::npos;
        if (numbered) {
            return spelled.substr(0, stem).append(key.substr(stem));
        }
    }
    return "";
}

/// Returns whether the section belongs to a modular device or a tool: [M1ModuleInfo], [Tool1], [1018ObjectLinks].
bool is_of_modules(const std::string& lower) {
    const bool module = lower.size() > 2 && lower[0] == 'm' && lower[1] >= '0' && lower[1] <= '9';
    const bool tool = lower.size() > 4 && lower.rfind("tool", 0) == 0 &&
                      lower.find_first_not_of("0123456789", 4) == std::string::npos;
    const std::string links = "objectlinks";
    return module || tool || (lower.size() > links.size() && lower.find(links) != std::string::npos);
}

}  // namespace

std::string known_section(const std::string& name) {
    const std::string lower = lower_case(name);
    const auto found = sections().find(lower);
    if (found != sections().end()) {
        return found->second.name;
    }
    if (lower == "devicecommissioning") {
        return name;  // CiA 306 writes one m, but files often contain the correct spelling, so it is accepted
    }
    if (const auto object = eds_object_name(name)) {
        const std::string digits = name.substr(0, 4);
        switch (object->kind) {
            case EdsObjectName::Kind::object:
                return digits;
            case EdsObjectName::Kind::sub:
                return digits + "sub" + name.substr(7);
            case EdsObjectName::Kind::name:
                return digits + "Name";
            case EdsObjectName::Kind::value:
                return digits + "Value";
        }
    }
    return is_of_modules(lower) ? name : "";
}

std::string known_key(const std::string& section, std::string_view key) {
    const auto found = sections().find(lower_case(section));
    if (found != sections().end()) {
        return in_words(found->second.keys, key);
    }
    const auto object = eds_object_name(section);
    if (!object) {
        return std::string{key};  // the section is unknown, which another rule reports
    }
    const bool compact = object->kind == EdsObjectName::Kind::name || object->kind == EdsObjectName::Kind::value;
    return in_words(compact ? compact_keys : object_keys, key);
}

bool is_dcf_key(std::string_view key) {
    return !in_words(dcf_keys, key).empty();
}

}  // namespace canproof::host
