#include "host/datasheet/check/known_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

namespace {

using Words = std::vector<const char*>;

const Words dcf_keys{"ParameterValue", "Denotation", "UploadFile", "DownloadFile", "ParamRefd"};

/// Sections with fixed names. A word that ends in # stands for itself with any number behind it.
const std::map<std::string, Words>& sections() {
    static const std::map<std::string, Words> all{
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
    return all;
}

const Words object_keys{"ParameterName", "ObjectType",    "DataType",     "AccessType",
                        "DefaultValue",  "LowLimit",      "HighLimit",    "PDOMapping",
                        "SubNumber",     "CompactSubObj", "ObjFlags",     "ParameterValue",
                        "Denotation",    "UploadFile",    "DownloadFile", "ParamRefd"};
const Words compact_keys{"NrOfEntries", "#"};

std::string in_words(const Words& words, const std::string& key) {
    const std::string lower = lower_case(key);
    for (const std::string word : words) {
        if (lower_case(word) == lower) {
            return word;
        }
        const std::string stem = lower_case(word.substr(0, word.size() - 1));
        const bool numbered = word.back() == '#' && lower.size() > stem.size() && lower.rfind(stem, 0) == 0 &&
                              lower.find_first_not_of("0123456789abcdef", stem.size()) == std::string::npos;
        if (numbered) {
            return word.substr(0, word.size() - 1) + key.substr(stem.size());
        }
    }
    return "";
}

/// Sections of a modular device and of tools: [M1ModuleInfo], [Tool1], [1018ObjectLinks].
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
    for (const auto& [known, keys] : sections()) {
        if (lower_case(known) == lower) {
            return known;
        }
    }
    if (lower == "devicecommissioning") {
        return name;  // a common spelling; CiA 306 has one m
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

std::string known_key(const std::string& section, const std::string& key) {
    const std::string lower = lower_case(section);
    for (const auto& [known, keys] : sections()) {
        if (lower_case(known) == lower) {
            return in_words(keys, key);
        }
    }
    const auto object = eds_object_name(section);
    if (!object) {
        return key;  // an unknown section is reported by itself
    }
    const bool compact = object->kind == EdsObjectName::Kind::name || object->kind == EdsObjectName::Kind::value;
    return in_words(compact ? compact_keys : object_keys, key);
}

bool is_dcf_key(const std::string& key) {
    return !in_words(dcf_keys, key).empty();
}

}  // namespace canproof::host
