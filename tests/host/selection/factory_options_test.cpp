// SPDX-License-Identifier: Apache-2.0
// Tests the option --factory, which sets factory data of one unit. Each key of the register sets its entry in the
// dictionary of the device.
#include "host/selection/factory_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "host/base/input_error.hpp"
#include "host/selection/built_in.hpp"
#include "host/selection/chosen_devices.hpp"
#include "tests/support/every_device.hpp"

namespace canproof::host::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;

ChosenDevice device_with(const std::string& name, const std::vector<std::string>& given) {
    FactoryOptions options{given};
    ChosenDevice chosen = choose_device(name, options);
    options.check_used();
    chosen.device->power_on(Instant{});
    return chosen;
}

std::uint32_t entry_of(const ChosenDevice& chosen, std::uint16_t index, std::uint8_t subindex) {
    return chosen.device->objects()->read(index, subindex);
}

std::string refusal(const std::string& name, const std::vector<std::string>& given) {
    try {
        device_with(name, given);
    } catch (const InputError& error) {
        return error.what();
    }
    return "taken";
}

}  // namespace

/// 1018h:3 (revision number) and 1018h:4 (serial number) of every device (CBX-AO412 7.9.18, AX130751 3.2.11, AX188001
/// 3.2.11, AX060805 4.2.11).
TEST(FactoryData, OptionsSetSerialAndRevisionNumberOfEveryDevice) {
    for (const std::string& name : canproof::test::every_device()) {
        const ChosenDevice chosen = device_with(name, {"serial_number=0xC1C20106", "revision_number=131077"});
        EXPECT_EQ(entry_of(chosen, 0x1018, 4), 0xC1C20106U) << name;
        EXPECT_EQ(entry_of(chosen, 0x1018, 3), 0x00020005U) << name;  // 131077 = 2 * 65536 + 5
    }
}

/// CiA 301 reserves the serial number 0; the manuals print no default; the manual of the CAN-CBX-AO412 prints an
/// example (7.9.18).
TEST(FactoryData, SerialAndRevisionNumberHaveTheirDefaultsWithoutOptions) {
    EXPECT_EQ(entry_of(device_with("cbx-ao412", {}), 0x1018, 4), 0xC1C20105U);
    for (const char* name : {"ax130751", "ax188001", "ax060805"}) {
        EXPECT_EQ(entry_of(device_with(name, {}), 0x1018, 4), 1U) << name;
    }
    EXPECT_EQ(entry_of(device_with("ax060805", {}), 0x1018, 3), 0x00010101U);
}

/// 1020h (verify configuration): day, month, year and hour, minute of the software (AX130751 3.2.12, AX060805 4.2.12).
TEST(FactoryData, OptionsSetDateAndTimeOfVerifyConfiguration1020h) {
    const ChosenDevice outputs =
        device_with("ax130751", {"configuration_date=0x01022024", "configuration_time=0x1234"});
    EXPECT_EQ(entry_of(outputs, 0x1020, 1), 0x01022024U);
    EXPECT_EQ(entry_of(outputs, 0x1020, 2), 0x1234U);
    const ChosenDevice tilt =
        device_with("ax060805", {"verify_configuration_1=0x01022024", "verify_configuration_2=0x1234"});
    EXPECT_EQ(entry_of(tilt, 0x1020, 1), 0x01022024U);
    EXPECT_EQ(entry_of(tilt, 0x1020, 2), 0x1234U);
}

/// 2404h (calibration offset), 2405h (calibration gain), 1F52h (verify application software), 1009h (hardware version)
/// and 100Ah (software version) (CBX-AO412 7.11.2, 7.11.3, 7.12.2, 7.9.8, 7.9.9).
TEST(FactoryData, OptionsSetOffsetGainDateAndHardwareVersionOfTheCbx) {
    const ChosenDevice chosen =
        device_with("cbx-ao412", {"calibration_offset_value_1=-32768", "calibration_offset_value_4=32767",
                                  "calibration_gain_value_2=-1", "application_software_date=11286",
                                  "application_software_time=86400000", "manufacturer_hardware_version=1.10",
                                  "manufacturer_software_version=2.06 bet"});
    EXPECT_EQ(entry_of(chosen, 0x2404, 1) & 0xFFFFU, 0x8000U);
    EXPECT_EQ(entry_of(chosen, 0x2404, 2), 0U);
    EXPECT_EQ(entry_of(chosen, 0x2404, 4), 0x7FFFU);
    EXPECT_EQ(entry_of(chosen, 0x2405, 2) & 0xFFFFU, 0xFFFFU);
    EXPECT_EQ(entry_of(chosen, 0x1F52, 1), 11286U);
    EXPECT_EQ(entry_of(chosen, 0x1F52, 2), 0x05265C00U);  // 7.12.2: the largest time of day, 86,400,000 ms
    EXPECT_EQ(entry_of(chosen, 0x1009, 0), 0x30312E31U);  // "1.10", least significant byte first
}

/// No key occurs twice, and each numeric key sets the entry that the register names.
TEST(FactoryData, EveryNumericKeySetsItsEntry) {
    for (const std::string& name : canproof::test::every_device()) {
        std::set<std::string> names;
        for (const FactoryKey& key : factory_keys(device_named(name))) {
            EXPECT_TRUE(names.insert(key.name).second) << name << " " << key.name;
            const bool has_no_object = key.name.rfind("sensor_", 0) == 0;
            if (has_no_object || !key.words.empty() || is_string_type(key.type)) {
                continue;
            }
            const ChosenDevice before = device_with(name, {});
            const ChosenDevice after = device_with(name, {key.name + "=17"});
            const auto index = static_cast<std::uint16_t>(std::stoul(key.text.substr(0, 4), nullptr, 16));
            const auto colon = key.text.find(':');
            const auto subindex =
                static_cast<std::uint8_t>(colon == std::string::npos ? 0 : std::stoul(key.text.substr(colon + 1)));
            const std::uint32_t seventeen = key.type == "REAL32" ? 0x41880000U : 17U;  // 1.0001 (binary) * 2^4
            EXPECT_NE(entry_of(before, index, subindex), seventeen) << name << " " << key.name;
            EXPECT_EQ(entry_of(after, index, subindex), seventeen) << name << " " << key.name;
        }
    }
}

/// AX060805 manual, 3.5, Table 8. 4030h shows the pitch, by default with one count per degree (4.3.7).
TEST(FactoryData, OptionSetsTheAngleRangeOfTheInclinometer) {
    const auto pitch_at_minus_10 = [](const std::vector<std::string>& given) {
        FactoryOptions options{given};
        const ChosenDevice chosen = choose_device("ax060805", options);
        options.check_used();
        chosen.device->set_input("pitch", -10.0, Instant{});
        chosen.device->power_on(Instant{});
        return static_cast<std::int16_t>(chosen.device->objects()->read(0x4030, 0));
    };
    EXPECT_EQ(pitch_at_minus_10({}), -10);
    EXPECT_EQ(pitch_at_minus_10({"angle_range=180"}), -10);
    EXPECT_EQ(pitch_at_minus_10({"angle_range=360"}), 350);
    EXPECT_EQ(pitch_at_minus_10({"angle_range=90"}), 10);  // this range shows only the distance from level
    EXPECT_THAT(refusal("ax060805", {"angle_range=270"}), HasSubstr("180, 360, 90"));
}

TEST(FactoryData, InclinometerCalibrationOutOfRangeIsRefused) {
    const ChosenDevice chosen = device_with("ax060805", {"calibrated_pitch_angle_data=-90"});
    EXPECT_EQ(entry_of(chosen, 0x2400, 0), 0xC2B40000U);  // -90 = -1.01101 (binary) * 2^6
    EXPECT_THAT(refusal("ax060805", {"calibrated_pitch_angle_data=90.5"}), HasSubstr("-90 … 90"));   // range in 4.3.17
    EXPECT_THAT(refusal("ax060805", {"calibrated_roll_angle_data=-181"}), HasSubstr("-180 … 180"));  // range in 4.3.18
}

TEST(FactoryData, RefusalOfAnInvalidValueNamesTheAllowedRange) {
    EXPECT_THAT(refusal("cbx-ao412", {"calibration_offset_value_1=32768"}), HasSubstr("-32768 … 32767"));
    EXPECT_THAT(refusal("cbx-ao412", {"application_software_time=86400001"}), HasSubstr("0 … 86400000"));
    EXPECT_THAT(refusal("cbx-ao412", {"manufacturer_hardware_version=123456789"}), HasSubstr("1 … 8 characters"));
    for (const char* value :
         {"4294967296", "-1", "1.5", "nan", "inf", "", "x", "0x", "1e3", " 1", "1 ", "0x100000000"}) {
        EXPECT_THAT(refusal("ax188001", {std::string{"serial_number="} + value}), HasSubstr("0 … 4294967295")) << value;
    }
    for (const char* value : {"nan", "inf", "1e999", "0x1p3", "--1", ""}) {
        EXPECT_THAT(refusal("ax060805", {std::string{"calibrated_pitch_angle_data="} + value}), HasSubstr("-90 … 90"))
            << value;
    }
}

TEST(FactoryData, UnknownKeysUnknownDevicesAndMalformedOptionsAreRefused) {
    EXPECT_THAT(refusal("ax188001", {"serial=1"}), AllOf(HasSubstr("no serial"), HasSubstr("serial_number")));
    EXPECT_THAT(refusal("ax188001", {"ax130751.serial_number=1"}), HasSubstr("no device"));
    for (const char* given : {"serial_number", "=1", ""}) {
        EXPECT_THAT(refusal("ax188001", {given}), HasSubstr("write KEY=VALUE")) << given;
    }
}

TEST(FactoryData, OptionMayNameOneOfSeveralDevices) {
    FactoryOptions options{{"ax188001@5.serial_number=7", "ax130751.serial_number=8", "revision_number=9"}};
    const auto started = [&](const char* name) {
        ChosenDevice chosen = choose_device(name, options);
        chosen.device->power_on(Instant{});
        return chosen;
    };
    const ChosenDevice five = started("ax188001@5");
    const ChosenDevice six = started("ax188001@6");
    const ChosenDevice outputs = started("ax130751@7");
    options.check_used();
    EXPECT_EQ(entry_of(five, 0x1018, 4), 7U);
    EXPECT_EQ(entry_of(six, 0x1018, 4), 1U);
    EXPECT_EQ(entry_of(outputs, 0x1018, 4), 8U);
    for (const ChosenDevice* one : {&five, &six, &outputs}) {
        EXPECT_EQ(entry_of(*one, 0x1018, 3), 9U);
    }
}

}  // namespace canproof::host::test
