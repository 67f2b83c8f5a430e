// SPDX-License-Identifier: Apache-2.0
// Checks the features in [DeviceInfo] against the objects of the device.
#include "host/datasheet/check/device_info_rules.hpp"

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
constexpr const char* source = "CiA 306, [DeviceInfo]";
constexpr const char* identity = "CiA 306, [DeviceInfo]; CiA 301, object 1018h";

constexpr std::array<const char*, 8> rates{"BaudRate_10",  "BaudRate_20",  "BaudRate_50",  "BaudRate_125",
                                           "BaudRate_250", "BaudRate_500", "BaudRate_800", "BaudRate_1000"};

class DeviceInfoCheck {
  public:
    DeviceInfoCheck(const EdsSheet& sheet, const IniSection& section, EdsFindings& findings)
        : sheet_{sheet}, section_{section}, findings_{findings} {}

    void run() {
        check_keys();
        check_flags();
        check_number("VendorNumber", "deviceinfo-vendor-differs", 1);
        check_number("ProductNumber", "deviceinfo-product-differs", 2);
        check_number("RevisionNumber", "deviceinfo-revision-differs", 3);
        check_rates();
        check_boot_up();
        check_count("NrOfRXPDO", "deviceinfo-rpdo-count", cia301::rpdo_communication);
        check_count("NrOfTXPDO", "deviceinfo-tpdo-count", cia301::tpdo_communication);
        check_granularity();
        check_lss();
        check_features();
    }

  private:
    std::optional<std::uint64_t> number(const char* key) const {
        const IniValue* value = section_.filled(key);
        return value == nullptr ? std::nullopt : eds_unsigned(value->text);
    }
    unsigned line_of(const char* key) const {
        const IniValue* value = section_.find(key);
        return value == nullptr ? section_.line : value->line;
    }

    void check_keys() {
        for (const char* key :
             {"VendorName", "VendorNumber", "ProductName", "ProductNumber", "RevisionNumber", "SimpleBootUpMaster",
              "SimpleBootUpSlave", "Granularity", "NrOfRXPDO", "NrOfTXPDO", "LSS_Supported"}) {
            if (section_.filled(key) == nullptr) {
                findings_.add("deviceinfo-key-missing", line_of(key),
                              fmt::format("[DeviceInfo] has no value for {}", key));
            }
        }
        for (const auto& [key, value] : section_.values) {
            if (known_key("DeviceInfo", key).empty()) {
                findings_.add("deviceinfo-key-unknown", value.line,
                              fmt::format("{} is no key of [DeviceInfo]", sheet_.line(value.line).name));
            }
        }
    }

    void check_flags() {
        std::vector<const char*> flags{rates.begin(), rates.end()};
        flags.insert(flags.end(), {"SimpleBootUpMaster", "SimpleBootUpSlave", "DynamicChannelsSupported",
                                   "GroupMessaging", "LSS_Supported"});
        for (const char* key : flags) {
            const IniValue* value = section_.filled(key);
            if (value != nullptr && eds_unsigned(value->text).value_or(2) > 1) {
                findings_.add("deviceinfo-flag", value->line,
                              fmt::format("{} {} is neither 0 nor 1", key, value->text));
            }
        }
    }

    void check_number(const char* key, const char* rule, unsigned sub) {
        const IniValue* value = section_.filled(key);
        if (value == nullptr) {
            return;
        }
        const auto found = eds_unsigned(value->text);
        if (!found || *found > UINT32_MAX) {
            findings_.add("deviceinfo-number", value->line, fmt::format("{} {} is no UNSIGNED32", key, value->text));
            return;
        }
        const EdsSheetEntry* entry = sheet_.entry(cia301::identity, sub);
        const auto in_object = entry == nullptr ? std::nullopt : entry->number();
        if (in_object && in_object->bits != *found) {
            findings_.add(rule, value->line,
                          fmt::format("{} is 0x{:X}, but 1018h:{:02X} (identity) has the default 0x{:X}", key, *found,
                                      sub, in_object->bits));
        }
    }

    void check_rates() {
        if (std::none_of(rates.begin(), rates.end(), [&](const char* key) { return number(key).value_or(0) == 1; })) {
            findings_.add("deviceinfo-no-bit-rate", section_.line, "no BaudRate_… is 1");
        }
    }

    void check_boot_up() {
        if (number("SimpleBootUpMaster") == std::uint64_t{0} && number("SimpleBootUpSlave") == std::uint64_t{0}) {
            findings_.add("deviceinfo-boot-up", line_of("SimpleBootUpSlave"),
                          "SimpleBootUpMaster and SimpleBootUpSlave are both 0");
        }
    }

    void check_count(const char* key, const char* rule, unsigned first) {
        const IniValue* said = section_.filled(key);
        if (said == nullptr || number("CompactPDO").value_or(0) != 0) {
            return;
        }
        const auto& objects = sheet_.objects();
        const auto count = std::distance(objects.lower_bound(static_cast<std::uint16_t>(first)),
                                         objects.upper_bound(static_cast<std::uint16_t>(first + 0x1FF)));
        if (eds_unsigned(said->text) != static_cast<std::uint64_t>(count)) {
            findings_.add(rule, said->line,
                          fmt::format("{} is {}, but {} PDO(s) are described", key, said->text, count),
                          replace_line(said->line, fmt::format("{}={}", key, count)));
        }
    }

    bool has_writable_mapping() const {
        const auto& objects = sheet_.objects();
        return std::any_of(objects.begin(), objects.end(), [](const auto& one) {
            const bool is_mapping = cia301::is_pdo_mapping(one.first);
            const auto& entries = one.second.entries;
            return is_mapping && std::any_of(entries.begin(), entries.end(), [](const EdsSheetEntry& entry) {
                       return entry.access.rfind("rw", 0) == 0 || entry.access == "wo";
                   });
        });
    }

    void check_granularity() {
        const IniValue* value = section_.filled("Granularity");
        if (value == nullptr) {
            return;
        }
        const auto bits = eds_unsigned(value->text);
        if (!bits || *bits > 64) {
            findings_.add("deviceinfo-granularity", value->line,
                          fmt::format("Granularity {} is not a number from 0 to 64", value->text));
        } else if ((*bits == 0) == has_writable_mapping()) {
            findings_.add(
                "deviceinfo-granularity-mapping", value->line,
                fmt::format("Granularity is {}, but {} PDO mapping can be changed", *bits, *bits == 0 ? "a" : "no"));
        }
    }

    /// Checks that a device with LSS has its whole LSS address (CiA 305): vendor-ID, product code, revision number and
    /// serial number.
    void check_lss() {
        if (number("LSS_Supported").value_or(0) != 1) {
            return;
        }
        for (unsigned sub = 1; sub <= 4; ++sub) {
            if (sheet_.entry(cia301::identity, sub) == nullptr) {
                findings_.add(
                    "deviceinfo-lss-identity", line_of("LSS_Supported"),
                    fmt::format("LSS_Supported is 1, but there is no 1018h:{:02X}, a part of the LSS address", sub));
            }
        }
    }

    void check_features() {
        const bool dynamic = number("DynamicChannelsSupported").value_or(0) == 1;
        if (dynamic != (sheet_.section("DynamicChannels") != nullptr)) {
            findings_.add("deviceinfo-dynamic-channels", line_of("DynamicChannelsSupported"),
                          dynamic ? "DynamicChannelsSupported is 1, but there is no [DynamicChannels]"
                                  : "there is [DynamicChannels], but DynamicChannelsSupported is not 1");
        }
        for (const auto& [index, object] : sheet_.objects()) {
            const bool mapping = cia301::is_pdo_mapping(index);
            const EdsSheetEntry* count = mapping ? object.entry(0) : nullptr;
            const auto value = count == nullptr ? std::nullopt : count->number();
            if (value && (value->bits == 254 || value->bits == 255) && number("GroupMessaging").value_or(0) != 1) {
                findings_.add(
                    "deviceinfo-group-messaging", count->value_line(),
                    fmt::format("{} makes the PDO a multiplexed PDO, but GroupMessaging is not 1", count->title()));
            }
        }
    }

    const EdsSheet& sheet_;
    const IniSection& section_;
    EdsFindings& findings_;
};

}  // namespace

const std::vector<EdsRule>& device_info_rules() {
    static const std::vector<EdsRule> rules{
        {"deviceinfo-missing", error, "there is no [DeviceInfo]", "add the section", source},
        {"deviceinfo-key-missing", warning, "[DeviceInfo] lacks a key or its value", "add the key with its value",
         source},
        {"deviceinfo-key-unknown", warning, "[DeviceInfo] has a key that CiA 306 does not define",
         "correct or remove the key", source},
        {"deviceinfo-flag", error, "a flag of [DeviceInfo] is neither 0 nor 1", "write 0 or 1", source},
        {"deviceinfo-number", error, "VendorNumber, ProductNumber or RevisionNumber is no UNSIGNED32",
         "write a number from 0 to 0xFFFFFFFF", source},
        {"deviceinfo-vendor-differs", error, "VendorNumber differs from 1018h:01 (vendor-ID)",
         "write the same number in both places", identity},
        {"deviceinfo-product-differs", error, "ProductNumber differs from 1018h:02 (product code)",
         "write the same number in both places", identity},
        {"deviceinfo-revision-differs", warning, "RevisionNumber differs from 1018h:03 (revision number)",
         "write the same number in both places", identity},
        {"deviceinfo-no-bit-rate", error, "the device supports no bit rate",
         "set BaudRate_… to 1 for each supported bit rate", source},
        {"deviceinfo-boot-up", warning, "the device boots neither as a master nor as a slave",
         "set SimpleBootUpSlave or SimpleBootUpMaster to 1", source},
        {"deviceinfo-rpdo-count", error, "NrOfRXPDO differs from the number of objects from 1400h to 15FFh",
         "write the number of receive PDOs", source},
        {"deviceinfo-tpdo-count", error, "NrOfTXPDO differs from the number of objects from 1800h to 19FFh",
         "write the number of transmit PDOs", source},
        {"deviceinfo-granularity", error, "Granularity is not a number from 0 to 64",
         "write the length in bits of the smallest object that can be mapped, or 0 if no mapping can be changed",
         source},
        {"deviceinfo-granularity-mapping", warning, "Granularity contradicts the AccessType of the PDO mappings",
         "write 0 if no mapping can be changed, otherwise a number from 1 to 64", source},
        {"deviceinfo-lss-identity", error, "a device with LSS lacks a part of its LSS address",
         "describe 1018h:01 to 1018h:04, or set LSS_Supported to 0", "CiA 305, LSS address; CiA 301, object 1018h"},
        {"deviceinfo-dynamic-channels", warning,
         "DynamicChannelsSupported and the section [DynamicChannels] contradict each other",
         "set DynamicChannelsSupported to 1 if the section exists, otherwise to 0", source},
        {"deviceinfo-group-messaging", warning, "there is a multiplexed PDO, but GroupMessaging is not 1",
         "set GroupMessaging to 1, or correct sub-index 0 of the mapping: 254 and 255 mean a multiplexed PDO", source}};
    return rules;
}

void check_device_info(const EdsSheet& sheet, EdsFindings& findings) {
    const IniSection* section = sheet.section("DeviceInfo");
    if (section == nullptr) {
        findings.add("deviceinfo-missing", 1, "there is no section [DeviceInfo]");
        return;
    }
    DeviceInfoCheck{sheet, *section, findings}.run();
}

}  // namespace canproof::host
