// SPDX-License-Identifier: Apache-2.0
#include "tests/host/register/broken_register.hpp"

#include <gmock/gmock.h>

#include "host/register/fingerprint.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "tests/support/replaced.hpp"

namespace canproof::host::test {

namespace {

const std::string requirement = R"([[requirement]]
id = "AO4-R-1"
text = "The box is square."
source = ["M1:1"]
kind = "functional"
verify = ["test"]
)";

std::string table(const std::string& columns_and_rows) {
    return "[[table]]\nid = \"AO4-T1\"\ntitle = \"t\"\nsource = [\"M1:Table 3\"]\n" + columns_and_rows;
}

std::string decision(const std::string& last_lines) {
    return "[[decision]]\nid = \"AO4-D-1\"\nquestion = \"?\"\nreadings = [\n  { says = \"a\", source = \"M1:1\" },\n"
           "  { says = \"b\", source = \"M1:2.1\" },\n]\nchosen = \"a\"\nbecause = \"safer failure\"\nseverity = "
           "\"low\"\n" +
           last_lines;
}

std::string constant(const std::string& type_and_value) {
    return "[[constant]]\nid = \"AO4-K-1\"\nname = \"size\"\nsource = [\"M1:1\"]\n" + type_and_value;
}

std::string signal(const std::string& rest) {
    return "[[signal]]\nid = \"AO4-S-1\"\nname = \"in\"\ntext = \"t\"\nsource = [\"M1:1\"]\ndirection = \"input\"\n" +
           rest;
}

const std::string reviews_file = "spec/devices/box/reviews.toml";

/// Returns a review file; `items` is line 5.
std::string review(const std::string& date, const std::string& items) {
    return "[[review]]\ndate = \"" + date + "\"\nby = \"x\"\n[review.items]\n" + items;
}

const std::string no_columns = "inputs = [\"a\"]\noutputs = [\"b\"]\n";

const std::vector<Broken> requirement_cases{
    {"UnknownKey", items_file, requirement + "author = \"me\"\n", 7, "the key `author` is unknown", "remove the key"},
    {"ByWhatIsNotThere", items_file, requirement + "by = \"CO-NONE-1\"\n", 7,
     "AO4-R-1 is implemented by CO-NONE-1, which is no shared requirement or is retired",
     "name a requirement of spec/canopen"},
    {"ByItself", items_file, requirement + "by = \"AO4-R-1\"\n", 7,
     "AO4-R-1 is implemented by AO4-R-1, which is no shared requirement or is retired",
     "name a requirement of spec/canopen"},
    {"UnknownItem", items_file, "[[rule]]\nid = \"AO4-R-1\"\n", 1, "the key `rule` is unknown",
     "spec/README.md lists the keys"},
    {"MissingText", items_file, replaced(requirement, "text = \"The box is square.\"\n", ""), 1, "text is missing",
     "add `text = …`"},
    {"EmptyText", items_file, replaced(requirement, "The box is square.", ""), 3, "text is not a non-empty string",
     "write a non-empty string"},
    {"MissingId", items_file, replaced(requirement, "id = \"AO4-R-1\"\n", ""), 1, "id is missing", "add `id = …`"},
    {"MissingSource", items_file, replaced(requirement, "source = [\"M1:1\"]\n", ""), 1, "source is missing",
     "add `source = …`"},
    {"EmptySource", items_file, replaced(requirement, "[\"M1:1\"]", "[]"), 4,
     "source is not a list of strings, not empty", "write a list of strings"},
    {"DerivedWithoutReason", items_file, replaced(requirement, "source = [\"M1:1\"]\n", "derived = true\n"), 1,
     "reason is missing", "add `reason = …`"},
    {"DerivedWithAManual", items_file, requirement + "derived = true\nreason = \"a bound of the design\"\n", 4,
     "AO4-R-1 is derived and cites a manual", "otherwise remove `derived`"},
    {"DeviceWithCiaOnly", items_file, replaced(requirement, "M1:1", "CiA301:7.2.4"), 4,
     "AO4-R-1 cites no section of a manual", "write `derived = true`"},
    {"ReasonWithoutDerived", items_file, requirement + "reason = \"a bound of the design\"\n", 7,
     "the key `reason` is unknown", "remove the key"},
    {"SourceWithoutSection", items_file, replaced(requirement, "M1:1", "M1"), 4, "source \"M1\" names no section",
     "write KEY:section"},
    {"SourceOfUnknownManual", items_file, replaced(requirement, "M1:1", "M2:1"), 4,
     "source \"M2:1\" names an unknown manual", "use a key from spec/manuals"},
    {"SourceOfUnknownSection", items_file, replaced(requirement, "M1:1", "M1:1 2.2"), 4, "M1 has no section 2.2",
     "correct the source, or add 2.2 to the manual's file in spec/manuals"},
    {"SourceOfUnknownTable", items_file, replaced(requirement, "M1:1", "M1:Table 4"), 4, "M1 has no section Table 4",
     "add Table 4"},
    {"SourceOfUnknownObject", items_file, replaced(requirement, "M1:1", "M1:2001h"), 4, "M1 has no section 2001h",
     "add 2001h"},
    {"UnknownKind", items_file, replaced(requirement, "functional", "nice"), 5, "kind = \"nice\" is unknown",
     "use one of functional, range"},
    {"UnknownVerify", items_file, replaced(requirement, "[\"test\"]", "[\"test\", \"hope\"]"), 6,
     "verify = \"hope\" is unknown", "use test, property, fuzz, analysis, target or inspection"},
    {"PrefixOfOtherDevice", items_file, replaced(requirement, "AO4-R-1", "INC-R-1"), 2,
     "id INC-R-1 does not begin with AO4-", "begin the id with the prefix of its folder"},
    {"PrefixOfDeviceInShared", shared_file, requirement, 2, "id AO4-R-1 does not begin with CO-",
     "begin the id with the prefix of its folder"},
    {"MalformedId", items_file, replaced(requirement, "AO4-R-1", "AO4-r_1"), 2, "id AO4-r_1 is malformed",
     "use capitals, digits"},
    {"DuplicateId", items_file, requirement + requirement, 8,
     "id AO4-R-1 is a duplicate of spec/devices/box/items.toml:2", "give one of the two another number"},
    {"NotToml", items_file, "[[requirement]]\nid = \"AO4-R-1\ntext = \"a\"\n", 2, "not TOML", "correct the syntax"},
};

const std::vector<Broken> table_cases{
    {"NoRows", items_file, table(no_columns), 1, "the table has no rows", "add `rows"},
    {"NoInputs", items_file, table("outputs = [\"b\"]\nrows = [[1]]\n"), 1, "the table has no inputs", "add `inputs"},
    {"RowTooShort", items_file, table(no_columns + "rows = [\n  [1, 2],\n  [2],\n]\n"), 9, "row of AO4-T1 has 1 cells",
     "write 2 cells: one for each input and output"},
    {"Gap", items_file,
     table("inputs = [{ name = \"a\", min = 0, max = 9 }]\noutputs = [\"b\"]\nrows = [\n  [\"0..3\", 1],\n  [\"5..9\", "
           "2],\n]\n"),
     1, "AO4-T1 has a gap: no row for a = 4", "add a row for this combination"},
    {"GapOfTwoInputs", items_file,
     table("inputs = [\"a\", \"on\"]\noutputs = [\"b\"]\nrows = [\n  [1, true, 1],\n  [1, false, 1],\n  [2, true, "
           "2],\n]\n"),
     1, "AO4-T1 has a gap: no row for a = 2, on = false", "add a row for this combination"},
    {"Overlap", items_file,
     table("inputs = [\"a\", \"word\"]\noutputs = [\"b\"]\nrows = [\n  [1, \"x\", 1],\n  [1, \"*\", 1],\n]\n"), 9,
     "AO4-T1 has an overlap: a = 1, word = x is covered by line 8 too",
     "change the rows so that only one covers this combination"},
    {"CellOutsideDomain", items_file,
     table("inputs = [{ name = \"a\", min = 0, max = 1 }]\noutputs = [\"b\"]\nrows = [\n  [\"0..2\", 1],\n]\n"), 8,
     "AO4-T1 value 0 is outside the domain of a", "correct the cell or the column's domain"},
    {"CellAllowsNothing", items_file,
     table("inputs = [{ name = \"a\", min = 0, max = 1 }]\noutputs = [\"b\"]\nrows = [[[], 1]]\n"), 7,
     "AO4-T1 value  is outside the domain of a", "correct the cell"},
    {"RangeBeyondNumbers", items_file,
     table("inputs = [{ name = \"a\", values = [\"x\"] }]\noutputs = [\"b\"]\nrows = [[\"1..99999999999999999999\", "
           "1]]\n"),
     7, "AO4-T1 value 1..99999999999999999999 is outside the domain of a", "correct the cell"},
    {"WordOutsideDomain", items_file,
     table("inputs = [{ name = \"a\", values = [\"x\"] }]\noutputs = [\"b\"]\nrows = [\n  [\"y\", 1],\n]\n"), 8,
     "AO4-T1 value y is outside the domain of a", "correct the cell"},
    {"OutputOutsideType", items_file,
     table("inputs = [\"a\"]\noutputs = [{ name = \"b\", type = \"UNSIGNED8\" }]\nrows = [\n  [1, 256],\n]\n"), 8,
     "AO4-T1 value 256 is outside the domain of b", "correct the cell"},
    {"OutputIsAnything", items_file, table(no_columns + "rows = [\n  [1, \"*\"],\n]\n"), 8,
     "AO4-T1 output b is not one value", "write a single literal"},
    {"OutputTypeUnknown", items_file,
     table("inputs = [\"a\"]\noutputs = [{ name = \"b\", type = \"BYTE\" }]\nrows = [[1, 1]]\n"), 6,
     "AO4-T1 column b has the unknown type BYTE", "use BOOLEAN"},
    {"EnumerationMissing", items_file,
     table("inputs = [\"a\"]\noutputs = [{ name = \"b\", enumeration = \"CO-E-X\" }]\nrows = [[1, \"x\"]]\n"), 6,
     "AO4-T1 column b names enumeration CO-E-X, which does not exist", "name an [[enumeration]]"},
    {"RealInput", items_file, table(no_columns + "rows = [[1.5, 1]]\n"), 5, "AO4-T1 input a is a REAL32",
     "use whole numbers"},
    {"TwoColumnsOfOneName", items_file, table("inputs = [\"a\"]\noutputs = [\"a\"]\nrows = [[1, 1]]\n"), 6,
     "AO4-T1 has two columns a", "give each column its own name"},
    {"ColumnNameIsKeyword", items_file, table("inputs = [\"switch\"]\noutputs = [\"a\"]\nrows = [[1, 1]]\n"), 5,
     "AO4-T1 column switch is no C++ name", "no C++ keyword"},
};

const std::vector<Broken> other_cases{
    {"DecisionAffectsNothing", items_file, decision(""), 1, "AO4-D-1 affects nothing", "give the reason in `none = …`"},
    {"DecisionAffectsStranger", items_file, decision("affects = [\"AO4-R-7\"]\n"), 11,
     "AO4-D-1 affects AO4-R-7, which does not exist", "correct the id or remove it"},
    {"DecisionReadsUnknownSection", items_file, replaced(decision("none = \"editorial\"\n"), "M1:2.1", "M1:9"), 6,
     "M1 has no section 9", "correct the source"},
    {"DecisionSeverityUnknown", items_file, replaced(decision("none = \"editorial\"\n"), "low", "odd"), 10,
     "severity = \"odd\" is unknown", "use one of high, medium, low"},
    {"ConstantOutOfType", items_file, constant("type = \"UNSIGNED8\"\nvalue = 256\n"), 6,
     "AO4-K-1 value 256 is no UNSIGNED8", "use a whole number from 0 to 255"},
    {"ConstantOfUnknownType", items_file, constant("type = \"FLOAT\"\nvalue = 2.5\n"), 1,
     "AO4-K-1 type FLOAT is unknown", "use REAL32, REAL64 or an integer type"},
    {"ConstantNameTaken", items_file,
     constant("type = \"UNSIGNED8\"\nvalue = 2\n") +
         replaced(constant("type = \"UNSIGNED8\"\nvalue = 2\n"), "K-1", "K-2"),
     7, "AO4-K-2 name size is already used in spec/devices/box/items.toml:1", "give each item its own name"},
    {"EnumerationNumberTwice", items_file,
     "[[enumeration]]\nid = \"AO4-E-1\"\nname = \"Mode\"\nvalues = { a = 1, b = 1 }\nsource = [\"M1:1\"]\n", 1,
     "AO4-E-1 gives the number 1 to two words", "give each word its own number"},
    {"EnumerationEmpty", items_file, "[[enumeration]]\nid = \"AO4-E-1\"\nname = \"Mode\"\nsource = [\"M1:1\"]\n", 1,
     "the enumeration has no values", "add `values"},
    {"SignalDefaultAboveMaximum", items_file, signal("type = \"REAL32\"\nmin = 0.0\nmax = 5.0\ndefault = 6.0\n"), 10,
     "AO4-S-1 default 6 is outside 0 to 5", "correct the default or the range"},
    {"SignalDefaultOfOtherType", items_file, signal("type = \"BOOLEAN\"\ndefault = 0.5\n"), 8,
     "AO4-S-1 default 0.5 is no BOOLEAN", "use true or false"},
    {"SignalWithoutRange", items_file, signal("type = \"UNSIGNED32\"\nmin = 0\ndefault = 1\n"), 1,
     "AO4-S-1 has no range", "give the signal `min` and `max`"},
    {"SignalCountWithoutNumber", items_file, signal("type = \"BOOLEAN\"\ndefault = false\ncount = 2\n"), 1,
     "signal in has a count but no {n} in its name", "write name"},
    {"SectionTwice", manual_file,
     small_register().at(manual_file) + "[[section]]\nref = \"1\"\ntitle = \"again\"\ndisposition = \"normative\"\n",
     20, "section 1 is already in line 6", "register each section once"},
    {"ConditionOfUseWithoutCondition", manual_file,
     replaced(small_register().at(manual_file), "disposition = \"informative\"", "disposition = \"condition-of-use\""),
     11, "section 2.1 gives no condition of use", "add `conditions = "},
    {"InformativeWithoutReason", manual_file,
     replaced(small_register().at(manual_file), "reason = \"a drawing\"\n", ""), 11,
     "informative section 2.1 gives no reason", "add `reason = …`"},
    {"UnknownDisposition", manual_file,
     replaced(small_register().at(manual_file), "disposition = \"normative\"", "disposition = \"odd\"\nreason = \"x\""),
     9, "disposition = \"odd\" is unknown", "use one of normative, informative"},
    {"DeviceNameIsNotFolder", device_file, replaced(small_register().at(device_file), "\"box\"", "\"crate\""), 1,
     "name crate is not the name of the folder", "write box"},
    {"NodeIdTooLarge", device_file, replaced(small_register().at(device_file), "node_id = 3", "node_id = 128"), 7,
     "node_id is not a whole number from 1 to 127", "write a whole number from 1 to 127"},
    {"ManualOfDeviceUnknown", device_file,
     replaced(small_register().at(device_file), "manual = \"M1\"", "manual = \"M9\""), 5, "manual M9 is not registered",
     "add spec/manuals/NAME.toml"},
    {"LimitAbortUnknown", device_file, small_register().at(device_file) + "limit_abort = \"any\"\n", 13,
     "limit_abort = \"any\" is unknown", "use one of range, high_low"},
    {"FileInNoFolder", "spec/odd/x.toml", "a = 1\n", 1, "the file is in no known folder", "move the file to manuals/"},
    {"FolderWithoutDevice", "spec/devices/lid/items.toml", "", 1, "the device has no device.toml", "write one"},
    {"ReviewOfStranger", "spec/devices/box/reviews.toml",
     "[[review]]\ndate = \"2026-11-21\"\nby = \"x\"\n[review.items]\nAO4-R-1 = \"00000000\"\n", 5,
     "the reviewed item or section AO4-R-1 does not exist", "remove the line"},
    {"ReviewOfUnknownSection", "spec/devices/box/reviews.toml",
     "[[review]]\ndate = \"2026-11-21\"\nby = \"x\"\n[review.items]\n\"M1:99\" = \"00000000\"\n", 5,
     "the reviewed item or section M1:99 does not exist", "remove the line"},
    {"ReviewOnNoDay", reviews_file, review("2026-02-29", "\"M1:1\" = \"00000000\"\n"), 2, "date 2026-02-29 is no date",
     "write YYYY-MM-DD"},
    {"ReviewInMonth13", reviews_file, review("2026-13-01", "\"M1:1\" = \"00000000\"\n"), 2,
     "date 2026-13-01 is no date", "write YYYY-MM-DD"},
    {"ReviewMarkedOnNoDay", reviews_file,
     "[[review]]\ndate = \"2026-11-21\"\nby = \"x\"\nmarked = \"today\"\n[review.items]\n\"M1:1\" = \"00000000\"\n", 4,
     "marked today is no date", "write YYYY-MM-DD"},
    {"ReviewWithMalformedHash", reviews_file, review("2026-11-21", "\"M1:1\" = \"zz\"\n"), 5,
     "the hashes of M1:1 are malformed", "record the review with `canproof spec review`"},
    {"ReviewWithMalformedHashOfTests", reviews_file, review("2026-11-21", "\"M1:1\" = \"00000000 - 0000000G\"\n"), 5,
     "the hashes of M1:1 are malformed", "record the review with `canproof spec review`"},
    {"ReviewWithFourHashes", reviews_file, review("2026-11-21", "\"M1:1\" = \"00000000 - - 00000000\"\n"), 5,
     "the hashes of M1:1 are malformed", "record the review with `canproof spec review`"},
    {"ManualOnNoDay", manual_file, replaced(small_register().at(manual_file), "2020-02-03", "24.11.2014"), 5,
     "date 24.11.2014 is no date", "write YYYY-MM-DD"},
    {"BitRateNotInBitRates", device_file,
     replaced(small_register().at(device_file), "bit_rate = 125000", "bit_rate = 123456"), 8,
     "bit_rate 123456 is not in bit_rates", "correct the bit rate, or add it to bit_rates"},
    {"BitRateTwice", device_file,
     replaced(small_register().at(device_file), "[10000, 125000]", "[125000, 10000, 125000]"), 9,
     "bit_rates lists 125000 twice", "keep one of the two"},
    {"PartNumberTwice", device_file, replaced(small_register().at(device_file), "[\"B.1\"]", "[\"B.1\", \"b.1\"]"), 6,
     "b.1 is already a part number of box", "give each part number to one device, once"},
    {"PartNumberOfAnotherDevice", "spec/devices/lid/device.toml",
     replaced(replaced(small_register().at(device_file), "\"box\"", "\"lid\""), "AO4", "LID"), 6,
     "B.1 is already a part number of box", "give each part number to one device, once"},
};

const std::string heartbeat_topic = "topic = \"heartbeat.range\"\n";

/// Returns requirement AO4-R-2 with the same topic as AO4-R-1. The topic is in line 15. `last_lines` has the choice.
std::string second(const std::string& last_lines) {
    return replaced(requirement, "R-1", "R-2") + heartbeat_topic + last_lines;
}

const std::vector<Broken> topic_cases{
    {"TopicWithoutChoice", items_file, requirement + heartbeat_topic, 1, "choice is missing", "add `choice = …`"},
    {"ChoiceWithoutTopic", items_file, requirement + "choice = \"any\"\n", 7, "choice has no topic",
     "add `topic = …`, or remove this key"},
    {"DiffersWithoutTopic", items_file, decision("none = \"-\"\ndiffers = \"its manual says so\"\n"), 12,
     "differs has no topic", "add `topic = …`, or remove this key"},
    {"OverridesWithoutTopic", items_file, requirement + "overrides = \"its manual says so\"\n", 7,
     "overrides has no topic", "add `topic = …`, or remove this key"},
    {"TopicMalformed", items_file, requirement + "topic = \"Heartbeat range\"\nchoice = \"any\"\n", 7,
     "topic Heartbeat range is malformed", "such as heartbeat.consumer-range"},
    {"ChoiceMalformed", items_file, requirement + heartbeat_topic + "choice = \"any-\"\n", 8,
     "choice any- is malformed", "such as refused-above-127"},
    {"TopicWithOneAnswer", items_file, decision("none = \"-\"\n" + heartbeat_topic + "choice = \"any\"\n"), 12,
     "no other item answers topic heartbeat.range", "spell the topic as other items do"},
    {"TwoChoicesInOneFolder", items_file,
     requirement + heartbeat_topic + "choice = \"any\"\n" + second("choice = \"some\"\n"), 15,
     "AO4-R-2 chooses some for topic heartbeat.range, but AO4-R-1 (spec/devices/box/items.toml:7) chooses any",
     "choose one answer"},
    {"DiffersFromNobody", items_file,
     requirement + heartbeat_topic + "choice = \"any\"\n" + second("choice = \"any\"\ndiffers = \"so\"\n") +
         decision("none = \"-\"\n"),
     15, "AO4-R-2 gives a reason to differ, but no device of the same manufacturer chooses differently",
     "remove `differs`"},
    {"OverridesNothing", items_file,
     requirement + heartbeat_topic + "choice = \"any\"\n" + second("choice = \"any\"\noverrides = \"so\"\n") +
         decision("none = \"-\"\n"),
     15, "AO4-R-2 gives a reason to override, but no shared item chooses differently", "remove `overrides`"},
    {"ServiceThatNoDeviceHas", items_file, requirement + "topic = \"services.lsss\"\nchoice = \"true\"\n", 7,
     "device.toml has no services.lsss", "use services.lss, services.block_sdo"},
    {"ServiceAgainstDeviceFile", items_file, requirement + "topic = \"services.lss\"\nchoice = \"false\"\n", 7,
     "AO4-R-1 chooses false for topic services.lss, but device.toml has true", "correct the item or device.toml"},
};

}  // namespace

TEST_P(BrokenRegister, BrokenRegisterIsRefusedWithFileLineReasonAndFix) {
    const Broken& broken = GetParam();
    const LoadResult loaded = load_register(with(broken.file, broken.text));
    ASSERT_EQ(loaded.faults.size(), 1U) << all_faults(loaded);
    const Fault& fault = loaded.faults.front();
    const bool other_file = broken.name == "FolderWithoutDevice";
    EXPECT_EQ(fault.place.file, other_file ? "spec/devices/lid/device.toml" : broken.file);
    EXPECT_EQ(fault.place.line, broken.line) << fault.text();
    EXPECT_THAT(fault.what, testing::HasSubstr(broken.what));
    EXPECT_THAT(fault.fix, testing::HasSubstr(broken.fix));
}

INSTANTIATE_TEST_SUITE_P(Requirements, BrokenRegister, testing::ValuesIn(requirement_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Tables, BrokenRegister, testing::ValuesIn(table_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Topics, BrokenRegister, testing::ValuesIn(topic_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Others, BrokenRegister, testing::ValuesIn(other_cases), case_name);

TEST(RegisterFaults, FaultTextHasFileLineReasonAndFix) {
    const Fault fault{{"spec/devices/box/items.toml", 41}, "something is wrong", "fix it"};
    EXPECT_EQ(fault.text(), "spec/devices/box/items.toml:41: something is wrong; fix it");
}

TEST(RegisterFaults, ValidRegisterHasNoFaults) {
    const LoadResult loaded = load_register(with(items_file, requirement));
    EXPECT_EQ(all_faults(loaded), "");
    ASSERT_EQ(loaded.content.parts.size(), 2U);
    EXPECT_EQ(loaded.content.parts[1].requirements.at(0).text, "The box is square.");
}

TEST(RegisterFaults, DerivedRequirementNeedsNoSource) {
    const std::string derived = "derived = true\nreason = \"a bound of the design\"\n";
    const LoadResult loaded = load_register(with(items_file, replaced(requirement, "source = [\"M1:1\"]\n", derived)));
    EXPECT_EQ(all_faults(loaded), "");
    const Requirement& read = loaded.content.part("box")->requirements.front();
    EXPECT_EQ(origins(read), std::vector<std::string>{"derived: a bound of the design"});
    Requirement cites_manual = read;
    cites_manual.derived.clear();
    EXPECT_NE(fingerprint(cites_manual), fingerprint(read)) << "a review must expire when an item becomes derived";
}

TEST(RegisterFaults, ConditionsOfUseOfAManualSectionAreLoaded) {
    const std::string condition = "disposition = \"condition-of-use\"\nconditions = [\"The box stays dry.\"]";
    const LoadResult loaded =
        load_register(with(manual_file, replaced(small_register().at(manual_file),
                                                 "disposition = \"informative\"\nreason = \"a drawing\"", condition)));
    EXPECT_EQ(all_faults(loaded), "");
    const Section& housing = loaded.content.manuals.front().sections.at(1);
    EXPECT_EQ(housing.conditions, std::vector<std::string>{"The box stays dry."});
    EXPECT_FALSE(housing.normative) << "no item has to cover it";
}

TEST(RegisterFaults, AllFaultsAreReportedAtOnceSortedByFileAndLine) {
    SpecFiles files = with(items_file, replaced(requirement, "functional", "nice") + "colour = 1\n" +
                                           replaced(requirement, "M1:1", "M2:1"));
    files["spec/devices/box/z.toml"] = constant("type = \"UNSIGNED8\"\nvalue = 256\n");
    files[shared_file] =
        "[[table]]\nid = \"CO-T1\"\ntitle = \"t\"\nsource = [\"CiA301:7\"]\ninputs = [\"a\", \"b\"]\n"
        "outputs = [\"c\"]\nrows = [[1, 1, 1], [2, 2, 2]]\n";
    const LoadResult loaded = load_register(files);
    std::vector<std::string> places;
    for (const Fault& fault : loaded.faults) {
        places.push_back(fault.place.file + ":" + std::to_string(fault.place.line));
    }
    // The shared table lacks (1, 2) and (2, 1); the second requirement begins in line 8 of items.toml.
    const std::vector<std::string> expected{"spec/canopen/shared.toml:1",    "spec/canopen/shared.toml:1",
                                            "spec/devices/box/items.toml:5", "spec/devices/box/items.toml:7",
                                            "spec/devices/box/items.toml:9", "spec/devices/box/items.toml:11",
                                            "spec/devices/box/z.toml:6"};
    EXPECT_EQ(places, expected) << all_faults(loaded);
}

TEST(RegisterFaults, WhileAFileIsNotTomlOnlyFaultsOfSyntaxAreReported) {
    SpecFiles files = with(items_file, replaced(requirement, "functional", "nice"));
    files[manual_file] = "key = \"M1\n";  // the source M1:1 of the requirement needs this file
    files["spec/devices/box/z.toml"] = "a" + std::string(100, '.') + "\n";
    const LoadResult loaded = load_register(files);
    ASSERT_EQ(loaded.faults.size(), 2U) << all_faults(loaded);
    EXPECT_EQ(loaded.faults[0].place.file, "spec/devices/box/z.toml");
    EXPECT_EQ(loaded.faults[1].place.file, manual_file);
    EXPECT_THAT(loaded.faults[1].what, testing::HasSubstr("the file is not TOML: "));
    files[manual_file] = small_register().at(manual_file);
    files.erase("spec/devices/box/z.toml");
    EXPECT_THAT(all_faults(load_register(files)), testing::HasSubstr("kind = \"nice\" is unknown"));
}

}  // namespace canproof::host::test
