// SPDX-License-Identifier: Apache-2.0
// Tests the code that is generated from a valid register. Every expected line is derived by hand from spec/README.md
// and object_types.hpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "host/codegen/write_all.hpp"
#include "host/codegen/write_embedded.hpp"
#include "host/codegen/write_literals.hpp"
#include "host/codegen/write_objects.hpp"
#include "host/codegen/write_requirements.hpp"
#include "host/codegen/write_tables.hpp"
#include "host/register/layout.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "tests/host/codegen/box_register.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;
using testing::Not;

class Generated : public testing::Test {
  protected:
    Generated() {
        files_ = with(items_file, box_files().at("box/behaviour.toml"));
        files_["spec/devices/box/objects.toml"] = box_files().at("box/objects.toml");
        files_[shared_file] = box_files().at("box/shared.toml");
        loaded_ = load_register(files_);
    }
    void SetUp() override { ASSERT_EQ(all_faults(loaded_), ""); }
    const Part& box() const { return *loaded_.content.part("box"); }
    const Part& canopen() const { return *loaded_.content.part("canopen"); }
    /// Returns the fingerprint of the box's layout after a change of the text that defines its objects.
    std::uint32_t layout_of_box_with(const std::string& old_text, const std::string& new_text) const {
        SpecFiles changed = files_;
        std::string& text = changed.at("spec/devices/box/objects.toml");
        text.replace(text.find(old_text), old_text.size(), new_text);
        const LoadResult loaded = load_register(changed);
        EXPECT_EQ(all_faults(loaded), "") << new_text;
        return make_layout(*loaded.content.part("box")).fingerprint;
    }

    SpecFiles files_;
    LoadResult loaded_;
};

}  // namespace

TEST_F(Generated, ObjectRowsContainTheirFirstEntryAndTheirEntryCount) {
    const std::string text = write_objects(box());
    // 1018h: sub 0, 1 and 4 make three rows; the arrays have sub 0 and two elements.
    EXPECT_THAT(text, HasSubstr("inline constexpr std::array<ObjectRow, 11U> object_rows{{\n"
                                "    {0x1000U, 0U, 1U, ObjectKind::var},  // AO4-OD-1000 Device Type\n"
                                "    {0x1001U, 1U, 1U, ObjectKind::var},  // AO4-OD-1001 Error Register\n"
                                "    {0x1014U, 2U, 1U, ObjectKind::var},  // AO4-OD-1014 COB-ID EMCY\n"
                                "    {0x1018U, 3U, 3U, ObjectKind::record},  // AO4-OD-1018 Identity Object\n"
                                "    {0x2000U, 6U, 3U, ObjectKind::array},  // AO4-OD-2000 Upper Bound\n"
                                "    {0x2001U, 9U, 3U, ObjectKind::array},  // AO4-OD-2001 Limit\n"
                                "    {0x2100U, 12U, 1U, ObjectKind::var},  // AO4-OD-2100 Label\n"
                                "    {0x2200U, 13U, 1U, ObjectKind::var},  // AO4-OD-2200 Mode 1\n"
                                "    {0x2210U, 14U, 1U, ObjectKind::var},  // AO4-OD-2210 Mode 2\n"
                                "    {0x2300U, 15U, 1U, ObjectKind::var},  // AO4-OD-2300 Scale\n"
                                "    {0x2400U, 16U, 1U, ObjectKind::var},  // AO4-OD-2400 Choice\n"
                                "}};\n"));
}

TEST_F(Generated, EntryRowsHaveOffsetLimitTypeRightsAndService) {
    const std::string text = write_objects(box());
    const std::string rw = "rights::read | rights::write";
    // Constants: 1000h at 0, 1018h:0 at 4, 1018h:1 at 5, 2000h:0 at 9, 2001h:0 at 10. Image: 1001h at 0 (maintained by
    // emcy), 2000h at 1 and 3 (mapped into PDOs), 2001h at 5 and 7 (not stored). Then the settings from 12 on: 1014h at
    // 12, 1018h:4 at 16 (factory), 2100h at 20, 2200h at 24, 2210h at 25, 2300h at 26, 2400h at 30.
    for (const std::string& row : {
             std::string{
                 "{0U, 4U, no_limit, 0U, DataType::unsigned32, rights::read | rights::constant, Service::none},"},
             std::string{"{0U, 1U, no_limit, 0U, DataType::unsigned8, rights::read, Service::emcy},"},
             "{12U, 4U, 0U, 0U, DataType::unsigned32, " + rw + " | rights::stored | rights::node_id, Service::emcy},",
             std::string{
                 "{4U, 1U, no_limit, 0U, DataType::unsigned8, rights::read | rights::constant, Service::none},"},
             std::string{
                 "{5U, 4U, no_limit, 1U, DataType::unsigned32, rights::read | rights::constant, Service::none},"},
             std::string{
                 "{16U, 4U, no_limit, 4U, DataType::unsigned32, rights::read, Service::none},  // AO4-OD-1018 Serial"},
             "{1U, 2U, 1U, 1U, DataType::integer16, " + rw + " | rights::rpdo | rights::stored, Service::none},",
             "{3U, 2U, 1U, 2U, DataType::integer16, " + rw + " | rights::rpdo | rights::stored, Service::none},",
             "{5U, 2U, no_limit, 1U, DataType::integer16, " + rw + ", Service::none},",
             "{20U, 4U, no_limit, 0U, DataType::visible_string, " + rw + " | rights::stored, Service::none},",
             "{24U, 1U, 2U, 0U, DataType::unsigned8, " + rw + " | rights::stored, Service::none},",
             "{25U, 1U, 2U, 0U, DataType::unsigned8, " + rw + " | rights::stored, Service::none},",
             "{26U, 4U, 3U, 0U, DataType::real32, " + rw + " | rights::stored, Service::none},",
             "{30U, 1U, 4U, 0U, DataType::unsigned8, " + rw + " | rights::stored, Service::none},",
         }) {
        EXPECT_THAT(text, HasSubstr(row));
    }
}

TEST_F(Generated, LimitRowsContainTheLimitsAsBitsOfTheEntryType) {
    const std::string text = write_objects(box());
    // -100 as INTEGER16 is FF9Ch; 10.0 as REAL32 is 41200000h; the settings 0…3 of the table have no gap, so the limits
    // are 0 and 3.
    EXPECT_THAT(text, HasSubstr("    {{LimitKind::value, 0x00000001U, 0}, {LimitKind::none, 0U, 0}},\n"
                                "    {{LimitKind::value, 0x0000FF9CU, 0}, {LimitKind::entry, 0x002001FFU, -3}},\n"
                                "    {{LimitKind::list, 0x00000002U, 0}, {LimitKind::none, 0U, 0}},\n"
                                "    {{LimitKind::none, 0U, 0}, {LimitKind::value, 0x41200000U, 0}},\n"
                                "    {{LimitKind::value, 0x00000000U, 0}, {LimitKind::value, 0x00000003U, 0}},\n"));
    EXPECT_THAT(text, HasSubstr("allowed_values{{\n    0x00000002U,\n    0x00000008U,\n}};"));
}

TEST_F(Generated, ConstantsAndDefaultsAreLittleEndianBytesOneEntryPerLine) {
    const std::string text = write_objects(box());
    EXPECT_THAT(text, HasSubstr("std::array<std::uint8_t, 11U> constant_pool{{\n"
                                "    0x91U, 0x01U, 0x02U, 0x00U,  // 0: AO4-OD-1000 Device Type\n"
                                "    0x04U,  // 4: AO4-OD-1018 Highest sub-index\n"
                                "    0x17U, 0x00U, 0x00U, 0x00U,  // 5: AO4-OD-1018 Vendor-ID\n"
                                "    0x02U,  // 9: AO4-OD-2000 Highest sub-index\n"
                                "    0x02U,  // 10: AO4-OD-2001 Highest sub-index\n"
                                "}};"));
    // -6 is FFFAh, 1.5F is 3FC00000h; the text has its capacity of four bytes.
    EXPECT_THAT(text, HasSubstr("std::array<std::uint8_t, 32U> default_image{{\n"
                                "    0x00U,  // 0: AO4-OD-1001 Error Register\n"
                                "    0x05U, 0x00U,  // 1: AO4-OD-2000 Upper Bound 1\n"
                                "    0xFAU, 0xFFU,  // 3: AO4-OD-2000 Upper Bound 2\n"
                                "    0x64U, 0x00U,  // 5: AO4-OD-2001 Limit 1\n"
                                "    0x64U, 0x00U,  // 7: AO4-OD-2001 Limit 2\n"
                                "    0x00U, 0x00U, 0x00U,  // 9: padding\n"
                                "    0x80U, 0x00U, 0x00U, 0x00U,  // 12: AO4-OD-1014 COB-ID EMCY\n"
                                "    0x01U, 0x00U, 0x00U, 0x00U,  // 16: AO4-OD-1018 Serial Number\n"
                                "    0x61U, 0x62U, 0x00U, 0x00U,  // 20: AO4-OD-2100 Label\n"
                                "    0x02U,  // 24: AO4-OD-2200 Mode 1\n"
                                "    0x08U,  // 25: AO4-OD-2210 Mode 2\n"
                                "    0x00U, 0x00U, 0xC0U, 0x3FU,  // 26: AO4-OD-2300 Scale\n"
                                "    0x01U,  // 30: AO4-OD-2400 Choice\n"
                                "    0x00U,  // 31: padding\n"
                                "}};"));
    EXPECT_THAT(text, HasSubstr("inline constexpr std::size_t image_size = 32U;"));
    // The settings begin behind 1001h, 2000h (mapped) and 2001h (not stored): 9 bytes, padded to 12.
    EXPECT_THAT(text, HasSubstr("U, 12U};\nstatic_assert(is_sound(tables));"));
}

TEST_F(Generated, FieldConstantsHaveTheOffsetsOfTheirEntries) {
    const std::string text = write_objects(box());
    EXPECT_THAT(text, HasSubstr("inline constexpr Field<std::uint8_t> o1001_error_register{0U};  // AO4-OD-1001\n"
                                "inline constexpr Field<std::uint32_t> o1014_cob_id_emcy{12U};  // AO4-OD-1014\n"
                                "inline constexpr Field<std::uint32_t> o1018_4_serial_number{16U};  // AO4-OD-1018\n"
                                "inline constexpr ArrayField<std::int16_t, 2U> o2000_upper_bound{1U};  // AO4-OD-2000\n"
                                "inline constexpr ArrayField<std::int16_t, 2U> o2001_limit{5U};  // AO4-OD-2001\n"
                                "inline constexpr StringField o2100_label{20U, 4U};  // AO4-OD-2100\n"
                                "inline constexpr Field<std::uint8_t> o2200_mode_1{24U};  // AO4-OD-2200\n"
                                "inline constexpr Field<std::uint8_t> o2210_mode_2{25U};  // AO4-OD-2210\n"
                                "inline constexpr Field<float> o2300_scale{26U};  // AO4-OD-2300\n"));
    EXPECT_THAT(text, Not(HasSubstr("o1000_device_type")));
    EXPECT_THAT(text, HasSubstr("//   spec/devices/box/items.toml\n//   spec/devices/box/objects.toml\n"));
}

TEST_F(Generated, LayoutFingerprintChangesWithEachPropertyThatAStoredValueMustAgreeWith) {
    const std::uint32_t before = layout_of_box_with("", "");
    EXPECT_NE(layout_of_box_with("length = 4", "length = 5"), before);
    EXPECT_NE(layout_of_box_with("\"UNSIGNED8\"\naccess = \"rw\"", "\"INTEGER8\"\naccess = \"rw\""), before);
    EXPECT_NE(layout_of_box_with("access = \"rw\"\ndefault = 1.5", "access = \"wo\"\ndefault = 1.5"), before);
    EXPECT_NE(layout_of_box_with("mapping = \"rpdo\"", "mapping = \"both\""), before);
    EXPECT_NE(layout_of_box_with("min = -100", "min = -99"), before);
    EXPECT_NE(layout_of_box_with("{ object = \"2001\", add = -3 }", "97"), before);
    EXPECT_NE(layout_of_box_with("add = -3", "add = -2"), before);
    EXPECT_NE(layout_of_box_with("max = 10.0", "max = 11.0"), before);
    EXPECT_NE(layout_of_box_with("values = [2, 8]", "values = [2, 8, 9]"), before);
    EXPECT_NE(layout_of_box_with("{ min = 1 }", "{ min = 1, zero = true }"), before);
    EXPECT_NE(layout_of_box_with("\"$NODEID+0x80\"", "0x80"), before);
}

TEST_F(Generated, LayoutFingerprintChangesWithAMappableEntryThatIsNotStored) {
    const std::string limit = "default = [5, -6]\nrange = { min = -100, max = { object = \"2001\", add = -3 } }\n";
    const std::uint32_t before = layout_of_box_with(limit, "stored = false\n" + limit);
    EXPECT_NE(layout_of_box_with(limit, "stored = false\ndefault = [5, -6]\n"), before);
}

TEST_F(Generated, LayoutFingerprintStaysWithANameADefaultAndAnEntryThatIsNotStored) {
    const std::uint32_t before = layout_of_box_with("", "");
    EXPECT_EQ(layout_of_box_with("\"Label\"", "\"Title\""), before);
    EXPECT_EQ(layout_of_box_with("default = 1.5", "default = 2.5"), before);
    EXPECT_EQ(layout_of_box_with("default = 100", "default = 99"), before);
}

TEST_F(Generated, TableRowIsGeneratedForEachAlternative_AndRangesAreKept) {
    const std::string text = write_tables(loaded_.content, box());
    EXPECT_THAT(text, HasSubstr("namespace rate_by_setting {"));
    EXPECT_THAT(text, HasSubstr("enum class Word : std::uint8_t { a, b };\n"
                                "enum class Action : std::uint8_t { run, and_, shut_off };"));
    const std::string state = ", canopen::NmtState::";
    EXPECT_THAT(text,
                HasSubstr("    {0U, 1U, true, Word::a, 100000U, Action::run" + state + "stopped},  // AO4-T1\n" +
                          "    {0U, 1U, true, Word::b, 100000U, Action::run" + state + "stopped},  // AO4-T1\n" +
                          "    {2U, 2U, true, Word::a, 66U, Action::and_" + state + "stopped},  // AO4-T1\n" +
                          "    {2U, 2U, true, Word::b, 66U, Action::and_" + state + "stopped},  // AO4-T1\n" +
                          "    {3U, 3U, true, Word::a, 66U, Action::and_" + state + "stopped},  // AO4-T1\n" +
                          "    {3U, 3U, true, Word::b, 66U, Action::and_" + state + "stopped},  // AO4-T1\n" +
                          "    {0U, 3U, false, Word::a, 0U, Action::shut_off" + state + "operational},  // AO4-T1\n" +
                          "    {0U, 3U, false, Word::b, 0U, Action::shut_off" + state + "operational},  // AO4-T1\n"));
    EXPECT_THAT(
        text, HasSubstr("constexpr const Row* find(const std::uint32_t setting, const bool enable, const Word word)"));
}

TEST_F(Generated, ConstantsEnumerationsAndSignalsAreGenerated) {
    EXPECT_THAT(write_constants(box()), HasSubstr("/// Reference of the converter. (AO4-K-1; M1:1) [V]\n"
                                                  "inline constexpr float reference_voltage{4.096F};\n"));
    EXPECT_THAT(write_constants(box()), HasSubstr("inline constexpr std::uint32_t steps{4095U};\n"));
    EXPECT_THAT(write_enumerations(canopen()), HasSubstr("enum class NmtState : std::uint8_t {\n"
                                                         "    initialising = 0U,\n    stopped = 4U,\n"
                                                         "    operational = 5U,\n    pre_operational = 127U,\n};"));
    EXPECT_THAT(write_enumerations(canopen()),
                HasSubstr("enum class Level : std::int16_t {\n    low = -1,\n    default_ = 0,\n    high = 300,\n};"));
    const std::string signals = write_signals(box());
    EXPECT_THAT(signals, HasSubstr("    std::uint8_t switch_high{3U};  ///< Coding switch. (AO4-S-2)\n"));
    EXPECT_THAT(
        signals,
        HasSubstr("    std::array<float, 2U> aout{{1.0F, 1.0F}};  ///< Voltage at the output. (AO4-S-1) [V]\n"));
    EXPECT_THAT(signals, HasSubstr("    visit(\"aout1\", group.aout[0U]);\n    visit(\"aout2\", group.aout[1U]);\n"));
}

TEST_F(Generated, IdsOfItemsBecomeCppTypesUnlessTheItemIsRetired) {
    const std::string text = write_requirements(loaded_.content, box());
    for (const char* id : {"AO4_R_1", "AO4_OD_1000", "AO4_OD_2210", "AO4_T1", "AO4_K_2", "AO4_S_1"}) {
        EXPECT_THAT(text, HasSubstr("struct " + std::string{id} + " { static constexpr bool in_force = true;"));
    }
    EXPECT_THAT(text, Not(HasSubstr("CO_E_STATE")));
    EXPECT_THAT(write_requirements(loaded_.content, canopen()), HasSubstr("struct CO_E_STATE {"));
    EXPECT_THAT(text, HasSubstr("static constexpr const char* id = \"AO4-R-1\";"));
    EXPECT_THAT(text, Not(HasSubstr("AO4_R_2")));
}

TEST_F(Generated, EmbeddedFilesAreSplitIntoLiteralsShortEnoughForCompilers) {
    SpecFiles large;
    std::string line = "# " + std::string(96, 'x') + "\n";  // 99 bytes
    for (int i = 0; i < 200; ++i) {
        large["spec/a.toml"] += line;
    }
    const std::string text = write_embedded(large);
    // 80 lines of 99 bytes are the most below 8000 bytes: 200 lines give three pieces.
    std::size_t pieces = 0;
    for (std::size_t at = text.find("R\"~~~~("); at != std::string::npos; at = text.find("R\"~~~~(", at + 1)) {
        ++pieces;
        EXPECT_LT(text.find(")~~~~\"", at) - at, 16384U);
    }
    EXPECT_EQ(pieces, 3U);
    EXPECT_THAT(text, HasSubstr("const SpecFiles& embedded_spec()"));
}

TEST_F(Generated, FileWithOnlyStatementsDecisionsAndReviewsIsNotEmbedded) {
    const SpecFiles files{{"spec/manuals/m/1.toml", "[[statement]]\nsection = \"1\"\n"},
                          {"spec/a.toml", "[[decision]]\nid = \"A\"\n[[review]]\nby = \"B\"\n"},
                          {"spec/b.toml", "[[decision]]\nid = \"C\"\n[[constant]]\nid = \"D\"\n"},
                          {"spec/c.toml", "# nothing yet\n"}};
    const std::string text = write_embedded(files);
    EXPECT_THAT(text, Not(HasSubstr("spec/manuals/m/1.toml")));
    EXPECT_THAT(text, Not(HasSubstr("spec/a.toml")));
    EXPECT_THAT(text, HasSubstr("spec/b.toml"));
    EXPECT_THAT(text, HasSubstr("spec/c.toml"));
}

TEST_F(Generated, GeneratedFilesAreWrittenOnlyWhenTheyChange) {
    const auto out = std::filesystem::path{testing::TempDir()} / "canproof_generated_test";
    std::filesystem::remove_all(out);
    write_all(loaded_.content, files_, out);
    const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours{1};
    std::filesystem::last_write_time(out / "box/objects.hpp", old);
    std::ofstream{out / "box/tables.hpp"} << "something else";
    write_all(loaded_.content, files_, out);
    EXPECT_EQ(std::filesystem::last_write_time(out / "box/objects.hpp"), old);
    std::ostringstream tables;
    tables << std::ifstream{out / "box/tables.hpp"}.rdbuf();
    EXPECT_EQ(tables.str(), write_tables(loaded_.content, box()));
    for (const char* file : {"embedded_spec.cpp", "canopen/requirements.hpp", "box/requirements.hpp",
                             "canopen/enumerations.hpp", "canopen/constants.hpp", "canopen/tables.hpp",
                             "box/signals.hpp", "box/constants.hpp", "box/enumerations.hpp"}) {
        EXPECT_TRUE(std::filesystem::exists(out / file)) << file;
    }
    std::filesystem::remove_all(out);
}

}  // namespace canproof::host::test
