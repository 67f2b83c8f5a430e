// SPDX-License-Identifier: Apache-2.0
// Tests data that are generated for the firmware from the register: indices, profile, names of tables, notation of
// numbers. Expected lines follow from spec/README.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/codegen/write_alterations.hpp"
#include "host/codegen/write_indices.hpp"
#include "host/codegen/write_literals.hpp"
#include "host/codegen/write_profile.hpp"
#include "host/codegen/write_tables.hpp"
#include "host/codegen/write_written.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;
using testing::Not;

std::string object(const std::string& index, const std::string& name) {
    return "[[object]]\nindex = " + index + "\nname = \"" + name +
           "\"\ntype = \"UNSIGNED8\"\naccess = \"rw\"\ndefault = 0\nsource = [\"M1:1\"]\n";
}

std::string table(const std::string& head, const std::string& rows) {
    return "[[table]]\n" + head + "source = [\"M1:Table 3\"]\ninputs = [\"error\"]\n" +
           "outputs = [ { name = \"code\", type = \"UNSIGNED16\" } ]\nrows = [" + rows + "]\n";
}

/// Returns the part of a valid register with these items.
Part box_with(const std::string& items) {
    const LoadResult loaded = load_register(with(items_file, items));
    EXPECT_EQ(all_faults(loaded), "");
    return *loaded.content.part("box");
}

TEST(GeneratedNames, EachObjectHasItsIndexAsAConstant) {
    const std::string text =
        write_indices(box_with(object("0x2000", "AO Control Source") + object("0x6411", "4 Values")));
    EXPECT_THAT(text, HasSubstr("namespace canproof::generated::box::index {\n\n"
                                "inline constexpr std::uint32_t ao_control_source = 0x2000U;\n"
                                "inline constexpr std::uint32_t n4_values = 0x6411U;\n"));
}

TEST(GeneratedNames, ObjectsWithTheSameNameAreDistinguishedByTheirIndex) {
    const std::string text = write_indices(box_with(object("0x2000", "Gain") + object("0x2A01", "gain")));
    EXPECT_THAT(text, HasSubstr(" gain_2000 = 0x2000U;\n"));
    EXPECT_THAT(text, HasSubstr(" gain_2a01 = 0x2A01U;\n"));
    EXPECT_THAT(text, Not(HasSubstr(" gain = ")));
}

TEST(GeneratedNames, SharedPartOfTheRegisterHasConstantsForStandardObjects) {
    const std::string listed = "[[standard_object]]\nindex = 0x1003\nname = \"Error list\"\n";
    const LoadResult loaded = load_register(with(shared_file, listed));
    EXPECT_EQ(all_faults(loaded), "");
    EXPECT_THAT(write_indices(*loaded.content.part("canopen")),
                HasSubstr("inline constexpr std::uint32_t error_list = 0x1003U;\n"));
    EXPECT_THAT(
        all_faults(load_register(with(items_file, listed))),
        HasSubstr("items.toml:1: standard object 1003h is in the files of a device; move the object to spec/canopen"));
    EXPECT_THAT(all_faults(load_register(with(shared_file, listed + listed))),
                HasSubstr("shared.toml:4: standard object 1003h or its name is listed twice"));
    EXPECT_THAT(all_faults(load_register(with(shared_file, "[[standard_object]]\nindex = 0x1003\nname = \"1\"\n"))),
                HasSubstr("the name \"1\" of a standard object gives no C++ name"));
}

TEST(GeneratedNames, GeneratedProfileMatchesDeviceToml) {
    SpecFiles files = with(items_file,
                           "[[table]]\nid = \"AO4-T1\"\ntitle = \"Rates\"\nsource = [\"M1:Table 3\"]\n"
                           "inputs = [ { name = \"index\", min = 0, max = 1 } ]\n"
                           "outputs = [ { name = \"bit_rate\", type = \"UNSIGNED32\" } ]\n"
                           "rows = [ [0, 1000000], [1, 500000] ]\n");
    files[device_file] +=
        "lss_bit_rates = \"AO4-T1\"\nlss_reset = true\nblock_sdo = true\nlimit_abort = \"range\"\n"
        "error_list = \"active\"\nemcy_content = \"detail\"\ntpdo_trigger = \"event_timer\"\n"
        "rpdos_answering_remote = [2, 4]\nsaves_in_pre_operational_only = true\n";
    const LoadResult loaded = load_register(files);
    ASSERT_EQ(all_faults(loaded), "");
    const std::string text = write_profile(*loaded.content.part("box"));
    EXPECT_THAT(text, HasSubstr("inline constexpr auto lss_rates = canproof::lss_bit_rates(rates::rows);\n"));
    EXPECT_THAT(text,
                HasSubstr("inline constexpr NodeProfile profile{\n    LimitAbort::range,\n    ErrorList::active,\n"
                          "    EmcyContent::detail,\n    0x0AU,\n    true,\n    true,\n"
                          "    LssProfile{lss_rates, true},\n    TpdoTrigger::event_timer};\n"));
    EXPECT_THAT(write_profile(*loaded.content.part("box"), Cells::changeable),
                HasSubstr("inline const NodeProfile profile{"));
}

TEST(GeneratedNames, ProfileHasTheDefaultsOfTheKeysThatDeviceTomlOmits) {
    SpecFiles files = small_register();
    std::string& device = files[device_file];
    device.replace(device.find("lss = true"), 10, "lss = false");
    EXPECT_THAT(
        write_profile(*load_register(files).content.part("box")),
        HasSubstr("LimitAbort::high_low,\n    ErrorList::history,\n    EmcyContent::listed_errors,\n    0x00U,\n"
                  "    false,\n    false,\n    LssProfile{},\n    TpdoTrigger::value_change};\n"));
    EXPECT_THAT(write_profile(*load_register(small_register()).content.part("box")),
                HasSubstr("canproof::lss_bit_rates(canopen::lss_bit_rates::rows);"));
}

TEST(GeneratedNames, ErrorTableHasTheRowsOfAllTablesOfErrors) {
    const std::string whole =
        "[[table]]\nid = \"AO4-T2\"\nname = \"faults\"\nerrors = \"fault\"\ntitle = \"Faults\"\nsource = [\"M1:Table "
        "3\"]\n"
        "inputs = [\"fault\"]\noutputs = [ { name = \"description\", type = \"UNSIGNED8\" }, { name = \"channel\", "
        "type = "
        "\"UNSIGNED8\" }, { name = \"code\", type = \"UNSIGNED16\" }, { name = \"register_bits\", type = \"UNSIGNED8\" "
        "}, "
        "\"sent\", \"listed\" ]\nrows = [ [\"hot\", 0x10, 2, 0x4200, 0x09, true, false] ]\n";
    const Part part = box_with(table("id = \"AO4-T1\"\nname = \"codes\"\nerrors = \"error\"\ntitle = \"Codes\"\n",
                                     "[\"can_overrun\", 0x8110]") +
                               whole);
    EXPECT_THAT(
        write_profile(part),
        HasSubstr(
            "constexpr ErrorTable make_error_table() noexcept {\n    ErrorTable table{};\n"
            "    for (const codes::Row& row : codes::rows) {\n"
            "        put_error(table, row.error, ErrorRow{row.code, 0x01U, true, true, 0U});\n    }\n"
            "    for (const faults::Row& row : faults::rows) {\n"
            "        put_error(table, row.fault, ErrorRow{row.code, row.register_bits, row.sent, row.listed, "
            "static_cast<std::uint16_t>((static_cast<std::uint32_t>(row.description) << 8U) | row.channel)});\n    }\n"
            "    return table;\n}\ninline constexpr ErrorTable error_table = make_error_table();\n"));
    EXPECT_THAT(write_profile(part, Cells::changeable),
                HasSubstr("inline const ErrorTable error_table = make_error_table();\n"));
}

TEST(GeneratedNames, ColumnOfAnErrorTableThatIsNoErrorPropertyIsAFault) {
    const auto faults_of = [](const std::string& outputs, const std::string& values) {
        return all_faults(
            load_register(with(items_file,
                               "[[table]]\nid = \"AO4-T1\"\nname = \"codes\"\nerrors = \"error\"\ntitle = \"Codes\"\n"
                               "source = [\"M1:Table 3\"]\ninputs = [\"error\"]\noutputs = [" +
                                   outputs + "]\nrows = [ [\"hot\", " + values + "] ]\n")));
    };
    EXPECT_THAT(faults_of("\"code\", \"colour\"", "1, 2"),
                HasSubstr("AO4-T1 column colour is no property of an error"));
    EXPECT_THAT(faults_of("\"listed\"", "true"),
                HasSubstr("AO4-T1 is a table of errors but has no output column `code`"));
    EXPECT_THAT(faults_of("\"code\", \"channel\"", "1, 2"),
                HasSubstr("AO4-T1 must define the upper half of an entry in 1003h"));
    EXPECT_THAT(faults_of("\"code\", \"detail\", \"description\", \"channel\"", "1, 2, 3, 4"),
                HasSubstr("AO4-T1 must define the upper half of an entry in 1003h"));
}

TEST(GeneratedNames, UnknownTableOrRpdoInDeviceTomlIsAFault) {
    SpecFiles files = small_register();
    files[device_file] += "lss_bit_rates = \"AO4-T9\"\nrpdos_answering_remote = [0, 9]\n";
    const std::string faults = all_faults(load_register(files));
    EXPECT_THAT(faults, HasSubstr("lss_bit_rates AO4-T9 is no table of the device"));
    EXPECT_THAT(faults, HasSubstr("rpdos_answering_remote names RPDO 0"));
    EXPECT_THAT(faults, HasSubstr("rpdos_answering_remote names RPDO 9"));
}

TEST(GeneratedNames, TableIsNamedByItsNameKeyOrElseByItsTitle) {
    const std::string rows = "[\"a\", 1]";
    const std::string one = table("id = \"AO4-T1\"\ntitle = \"Enable response: what an output does\"\n", rows);
    const std::string other =
        table("id = \"AO4-T2\"\nname = \"relay\"\ntitle = \"Enable response of a relay\"\n", rows);
    EXPECT_EQ(box_with(one + other).tables.at(0).name, "enable_response");
    EXPECT_EQ(box_with(one + other).tables.at(1).name, "relay");
    EXPECT_THAT(all_faults(load_register(with(items_file, one + one))),
                HasSubstr("AO4-T1 name enable_response is already used by AO4-T1"));
    EXPECT_THAT(all_faults(load_register(with(items_file, table("id = \"AO4-T1\"\ntitle = \"3 ways\"\n", rows)))),
                HasSubstr("AO4-T1 name 3_ways is no C++ name"));
    EXPECT_THAT(all_faults(load_register(with(items_file, table("id = \"AO4-T1\"\ntitle = \"Field\"\n", rows)))),
                HasSubstr("AO4-T1 name field is already used by the generated code"));
}

TEST(GeneratedNames, SharedErrorsKeepTheirNamesAndPrecedeDeviceErrors) {
    const std::string items = table("id = \"AO4-T1\"\nname = \"codes\"\nerrors = \"error\"\ntitle = \"Codes\"\n",
                                    "[\"can_overrun\", 0x8110], [\"hardware\", 0x5000], [\"hot\", 16896]");
    const LoadResult loaded = load_register(with(items_file, items));
    ASSERT_EQ(all_faults(loaded), "");
    const std::string text = write_tables(loaded.content, *loaded.content.part("box"));
    EXPECT_THAT(text, HasSubstr("#include \"firmware/canopen/error_table.hpp\"\n"));
    EXPECT_THAT(text, HasSubstr("inline constexpr ErrorId hardware = error_after(ErrorId::first_of_device, 0U);\n"
                                "inline constexpr ErrorId hot = error_after(ErrorId::first_of_device, 1U);\n"));
    EXPECT_THAT(text, HasSubstr("    {ErrorId::can_overrun, 0x8110U},  // AO4-T1\n"
                                "    {error::hardware, 0x5000U},  // AO4-T1\n    {error::hot, 16896U},  // AO4-T1\n"));
    EXPECT_THAT(text, Not(HasSubstr("enum class Error")));
    const std::string altered = write_alterations(loaded.content);
    EXPECT_THAT(altered, HasSubstr("static_cast<std::uint64_t>(box::error::hardware)"));
    EXPECT_THAT(altered, HasSubstr("static_cast<std::uint64_t>(canproof::ErrorId::can_overrun)"));
    EXPECT_THAT(all_faults(load_register(with(
                    items_file, table("id = \"AO4-T1\"\nerrors = \"fault\"\ntitle = \"Codes\"\n", "[\"hot\", 1]")))),
                HasSubstr("AO4-T1: `errors` names fault, which is no input column of words"));
}

TEST(GeneratedNames, RepeatedObjectsHaveOneNameInTheEnumerationOfReportedParameters) {
    const std::string heard = "service = \"device\"\n";
    const std::string family = object("0x3010", "Block {n} source") + heard +
                               "repeat = { first = 1, last = 3, step = 0x10 }\n" + object("0x3014", "Block {n} gain") +
                               heard + "repeat = { first = 1, last = 3, step = 0x10 }\n";
    const std::string lone = object("0x2000", "Gain") + heard;
    const std::string silent = object("0x2001", "Unheard");
    const std::string text = write_written(box_with(lone + silent + family));
    EXPECT_THAT(text, HasSubstr("enum class Parameter : std::uint16_t {\n    gain = 0x2000U,\n"
                                "    block_source = 0x3010U,\n    block_gain = 0x3014U,\n};\n"));
    EXPECT_THAT(text, HasSubstr("    if ((index >= 0x3010U) && (index < 0x3040U)) {\n"));
    EXPECT_THAT(text, HasSubstr("static_cast<Parameter>(0x3010U + (offset % 0x10U)),\n"
                                "                       static_cast<std::uint8_t>(1U + (offset / 0x10U)), subindex};"));
    // When an object of no family lies in the same range of indices, each object is listed separately.
    const std::string mixed = write_written(box_with(family + object("0x3025", "Other") + heard));
    EXPECT_THAT(mixed, Not(HasSubstr("offset")));
    EXPECT_THAT(mixed, HasSubstr("    block_2_source = 0x3020U,\n    block_2_gain = 0x3024U,\n    other = 0x3025U,\n"));
}

TEST(GeneratedNames, RepeatedObjectsWhoseIndicesCountInDecimalHaveOneName) {
    const std::string repeat = "service = \"device\"\nrepeat = { first = 8, last = 11, step = 0x10, decimal = true }\n";
    const Part box =
        box_with(object("0x3080", "Block {n} source") + repeat + object("0x3084", "Block {n} gain") + repeat);
    std::vector<unsigned> indices;
    for (const Object& one : box.objects) {
        indices.push_back(one.index);
    }
    EXPECT_THAT(indices, testing::UnorderedElementsAre(0x3080, 0x3084, 0x3090, 0x3094, 0x3100, 0x3104, 0x3110, 0x3114));
    const std::string text = write_written(box);
    EXPECT_THAT(text, HasSubstr("{\n    block_source = 0x3080U,\n    block_gain = 0x3084U,\n};\n"));
    EXPECT_THAT(text, HasSubstr("    if ((index >= 0x3080U) && (index < 0x30A0U)) {\n"
                                "        const std::uint32_t offset = index - 0x3080U;\n"
                                "        return Written{static_cast<Parameter>(0x3080U + (offset % 0x10U)),\n"
                                "                       static_cast<std::uint8_t>(8U + (offset / 0x10U)), subindex};"));
    EXPECT_THAT(text,
                HasSubstr("    if ((index >= 0x3100U) && (index < 0x3120U)) {\n"
                          "        const std::uint32_t offset = index - 0x3100U;\n"
                          "        return Written{static_cast<Parameter>(0x3080U + (offset % 0x10U)),\n"
                          "                       static_cast<std::uint8_t>(10U + (offset / 0x10U)), subindex};"));
}

TEST(GeneratedNames, GeneratedNumbersKeepTheHexOrDecimalNotationOfTheRegister) {
    const std::string constant =
        "[[constant]]\nid = \"AO4-K-1\"\nname = \"request\"\nvalue = 0x7E5\n"
        "type = \"UNSIGNED16\"\nsource = [\"M1:1\"]\n"
        "[[constant]]\nid = \"AO4-K-2\"\nname = \"abort\"\nvalue = 0x05030000\n"
        "type = \"UNSIGNED32\"\nsource = [\"M1:1\"]\n"
        "[[constant]]\nid = \"AO4-K-3\"\nname = \"least\"\nvalue = -10\n"
        "type = \"INTEGER16\"\nsource = [\"M1:1\"]\n";
    const std::string values =
        "[[enumeration]]\nid = \"AO4-E-1\"\nname = \"Command\"\n"
        "values = { start = 0x01, stop = 0x0A }\nsource = [\"M1:1\"]\n";
    const Part box = box_with(constant + values);
    EXPECT_THAT(write_constants(box), HasSubstr("std::uint32_t request{0x7E5U};"));
    EXPECT_THAT(write_constants(box), HasSubstr("std::uint32_t abort{0x05030000U};"));
    EXPECT_THAT(write_constants(box), HasSubstr("std::int16_t least{-10};"));
    EXPECT_THAT(write_enumerations(box), HasSubstr("    start = 0x01U,\n    stop = 0x0AU,\n"));
}

}  // namespace

}  // namespace canproof::host::test
