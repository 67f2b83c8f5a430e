// SPDX-License-Identifier: Apache-2.0
// Tests the documents that are generated from a small register, and what they list as missing.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/assess/documents/error_matrix.hpp"
#include "host/assess/documents/failure_modes.hpp"
#include "host/assess/documents/hardware_interface.hpp"
#include "host/assess/documents/interface_control.hpp"
#include "host/assess/documents/item_words.hpp"
#include "host/assess/documents/render.hpp"
#include "host/assess/documents/residual_errors.hpp"
#include "host/assess/documents/safety_manual.hpp"
#include "host/assess/documents/threats.hpp"
#include "host/base/input_error.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const char* const items = R"(
[[requirement]]
id = "AO4-A-001"
text = "Below 9 V the device raises 3100h."
source = ["M1:1"]
kind = "fault"
verify = ["test"]
[[requirement]]
id = "AO4-A-002"
text = "The output is off within 10 ms."
source = ["M1:1"]
kind = "timing"
verify = ["test"]
[[signal]]
id = "AO4-S-SUPPLY"
name = "supply"
direction = "input"
type = "REAL32"
unit = "V"
min = 0.0
max = 60.0
default = 12.0
text = "Supply voltage."
source = ["M1:1"]
[[signal]]
id = "AO4-S-OUT"
name = "out{n}"
count = 2
direction = "output"
type = "BOOLEAN"
default = false
text = "Switched output."
source = ["M1:1"]
[[constant]]
id = "AO4-K-LIMIT"
name = "limit"
value = 9.0
type = "REAL32"
unit = "V"
text = "Least supply."
source = ["M1:1"]
[[table]]
id = "AO4-T-ERRORS"
name = "error_codes"
errors = "error"
title = "Errors"
source = ["M1:Table 3"]
inputs = ["error"]
outputs = [{ name = "code", type = "UNSIGNED16" }, { name = "register_bits", type = "UNSIGNED8" }]
rows = [["supply", 0x3100, 0x05], ["silence", 0x8130, 0x11]]
[[hazard]]
id = "AO4-H-001"
text = "The output is on."
at = ["AO4-S-OUT"]
safe_state = "off"
[[hazard.failure]]
text = "The supply is low."
prevented_by = ["AO4-A-001"]
[[hazard.failure]]
text = "The switch is welded."
reason = "Nothing measures it."
)";

const char* const objects = R"(
[[object]]
index = 0x1014
name = "COB-ID EMCY"
source = ["M1:1"]
type = "UNSIGNED32"
access = "rw"
default = "$NODEID+0x80"
[[object]]
index = 0x1800
name = "TPDO1 parameter"
source = ["M1:1"]
[[object.entry]]
sub = 1
name = "COB-ID"
type = "UNSIGNED32"
access = "rw"
default = "$NODEID+0x180"
[[object.entry]]
sub = 2
name = "Transmission type"
type = "UNSIGNED8"
access = "rw"
default = 254
[[object]]
index = 0x1A00
name = "TPDO1 mapping"
source = ["M1:1"]
type = "UNSIGNED32"
array = 2
kind = "record"
access = "rw"
default = [0x20000110, 0x20000210]
[[object.entry]]
sub = 0
name = "Number"
type = "UNSIGNED8"
access = "rw"
default = 2
[[object]]
index = 0x2000
name = "Level"
text = "Level of each channel."
source = ["M1:1"]
type = "INTEGER16"
array = 2
access = "rw"
default = 5
range = { min = -10, max = 10 }
mapping = "tpdo"
unit = "mV"
)";

class Documents : public ::testing::Test {
  protected:
    Documents() {
        SpecFiles files = with(items_file, items);
        files["spec/devices/box/objects.toml"] = objects;
        files[manual_file] += "conditions = [\"The plant | has a fuse.\"]\n";
        LoadResult loaded = load_register(files);
        EXPECT_EQ(all_faults(loaded), "");
        content_ = std::move(loaded.content);
    }

    const Part& box() const { return *content_.part("box"); }

    /// Returns all rows of all tables whose caption begins with this text.
    static std::vector<std::vector<std::string>> rows_of(const Document& document, const std::string& caption) {
        std::vector<std::vector<std::string>> rows;
        for (const auto& chapter : document.chapters) {
            for (const auto& table : chapter.tables) {
                if (table.caption.rfind(caption, 0) == 0) {
                    rows.insert(rows.end(), table.rows.begin(), table.rows.end());
                }
            }
        }
        return rows;
    }

    static void write(const std::filesystem::path& file, const std::string& text) {
        std::filesystem::create_directories(file.parent_path());
        std::ofstream{file} << text;
    }

    Analysis analysis(const std::string& text) const {
        const auto folder = std::filesystem::path{::testing::TempDir()} / "analysis";
        write(folder / "a.toml", text);
        return read_analysis(folder, content_);
    }
    std::string refusal(const std::string& text) const {
        try {
            analysis(text);
            return "";
        } catch (const InputError& error) {
            return error.what();
        }
    }

    Register content_;
};

}  // namespace

TEST_F(Documents, ObjectsConstantsTablesAndSignalsAreDescribedInWords) {
    EXPECT_EQ(item_words(box(), "AO4-OD-2000"),
              "ARRAY. Sub 0 (Highest sub-index): UNSIGNED8, constant, every value of the type, default 2, not stored, "
              "cannot be "
              "mapped into PDOs. Sub 1 to 2 (Level 1): INTEGER16, read and write, range -10 … 10, default 5, stored by "
              "1010h (store "
              "parameters), may be mapped into TPDOs.");
    EXPECT_EQ(item_words(box(), "AO4-K-LIMIT"), "REAL32: limit = 9 V.");
    EXPECT_EQ(item_words(box(), "AO4-T-ERRORS"),
              "error → code, register_bits: supply → 3100h, 05h; silence → 8130h, 11h.");
    EXPECT_EQ(item_words(box(), "AO4-S-SUPPLY"), "supply: input, REAL32, 0 … 60 V, at power-on 12 V.");
    EXPECT_EQ(item_words(box(), "AO4-A-001"), "");
}

TEST_F(Documents, SafetyManualListsFailuresConditionsOfUseAndConstants) {
    const Document manual = safety_manual(content_, box(), {});
    EXPECT_THAT(rows_of(manual, "AO4-H-001"),
                ElementsAre(ElementsAre("The supply is low.", "AO4-A-001"),
                            ElementsAre("The switch is welded.", "not prevented by the device")));
    EXPECT_THAT(rows_of(manual, "Failures that the device does not prevent"),
                ElementsAre(ElementsAre("AO4-H-001", "The switch is welded.", "Nothing measures it.")));
    EXPECT_THAT(rows_of(manual, "Conditions of use"),
                ElementsAre(ElementsAre("Table 3", "Rates", "The plant | has a fuse.")));
    EXPECT_THAT(rows_of(manual, "Constants with a unit"),
                ElementsAre(ElementsAre("AO4-K-LIMIT", "9 V", "Least supply.", "M1:1")));
}

TEST_F(Documents, HardwareInterfaceListsEveryInputAndOutput) {
    const Document interface = hardware_interface(box(), {});
    EXPECT_THAT(rows_of(interface, "Inputs"), ElementsAre(ElementsAre("supply", "REAL32", "V", "0 … 60 V", "12",
                                                                      "Supply voltage.", "", "AO4-S-SUPPLY", "M1:1")));
    EXPECT_THAT(rows_of(interface, "Outputs"),
                ElementsAre(ElementsAre("out1, out2", "BOOLEAN", "", "every value of the type", "false",
                                        "Switched output.", "AO4-H-001", "AO4-S-OUT", "M1:1")));
}

TEST_F(Documents, InterfaceControlDocumentHasCobIdsAndMappings) {
    const Document interface = interface_control(content_, box(), {});
    const auto messages = rows_of(interface, "COB-IDs at node-ID 3");
    // COB-IDs of node 3: 80h + 3, 600h + 3, 580h + 3, 700h + 3
    EXPECT_THAT(messages, Contains(ElementsAre("EMCY", "sent", "083h", "8", "1014h")));
    EXPECT_THAT(messages, Contains(ElementsAre("SDO request", "received", "603h", "8", "")));
    EXPECT_THAT(messages, Contains(ElementsAre("SDO response", "sent", "583h", "8", "")));
    EXPECT_THAT(messages, Contains(ElementsAre("LSS request", "received", "7E5h", "8", "")));
    EXPECT_THAT(rows_of(interface, "RPDOs"), IsEmpty());
    // TPDO1 has the COB-ID 180h + 3 and two values of 16 bits, one after the other
    EXPECT_THAT(rows_of(interface, "TPDOs"),
                ElementsAre(ElementsAre("TPDO1, 1800h", "183h", "254 (event)", "", "",
                                        "bit 0: 2000h:01 Level 1 (16 bit), bit 16: 2000h:02 Level 2 (16 bit)")));
    EXPECT_THAT(rows_of(interface, "Timing of this device"),
                ElementsAre(ElementsAre("AO4-A-002", "The output is off within 10 ms.", "M1:1")));
    EXPECT_THAT(rows_of(interface, "Object dictionary"),
                Contains(ElementsAre("2000h:01", "Level 1", "INTEGER16", "rw", "5", "-10 … 10", "tpdo", "yes", "mV")));
}

TEST_F(Documents, ErrorMatrixNamesRequirements_AndMarksErrorsWithoutARequirement) {
    const Document matrix = error_matrix(content_, box(), {});
    EXPECT_THAT(rows_of(matrix, "Errors"),
                ElementsAre(ElementsAre("supply", "3100h", "05h", "", "AO4-A-001", "no lamp", "AO4-T-ERRORS"),
                            ElementsAre("silence", "8130h", "11h", "", "missing", "no lamp", "AO4-T-ERRORS")));
}

TEST_F(Documents, FailureModeThatTheAnalysisOmitsIsListedAsMissing) {
    const Analysis known = analysis(R"([[failure_mode]]
devices = ["box"]
signals = ["AO4-S-SUPPLY"]
mode = "too low"
detected = ["AO4-A-001"]
errors = ["supply"]
note = "Below 9 V."
[[failure_mode]]
devices = ["box"]
at = "heartbeat"
mode = "missing"
)");
    const Document made = failure_modes(content_, box(), known);
    EXPECT_THAT(
        rows_of(made, "Inputs"),
        ElementsAre(
            ElementsAre("supply (AO4-S-SUPPLY)", "too low", "AO4-A-001", "missing", "3100h supply", "Below 9 V."),
            ElementsAre("supply (AO4-S-SUPPLY)", "too high", "missing", "missing", "missing", ""),
            ElementsAre("supply (AO4-S-SUPPLY)", "NaN", "missing", "missing", "missing", ""),
            ElementsAre("supply (AO4-S-SUPPLY)", "plausible and wrong", "missing", "missing", "missing", "")));
    EXPECT_THAT(rows_of(made, "Messages and memory"),
                ElementsAre(ElementsAre("heartbeat", "missing", "missing", "missing", "missing", "")));
    EXPECT_THAT(rows_of(made, "Outputs"), Contains(Contains("not prevented: Nothing measures it.")));
    // The hazards in the table of outputs contain the failures of the processor.
    EXPECT_THAT(made.chapters.at(0).text.at(1), Not(HasSubstr("not analysed")));
    // Cells with the word "missing": 1 + 3 + 3 + 3 in the four rows of the input, and 4 in the row of the message,
    // whose mode is "missing" too.
    EXPECT_EQ(count_missing(made), 14U);
}

TEST_F(Documents, FailureAnalysisThatNamesUnknownItemsIsRefusedWithItsLine) {
    const std::string mode = "[[failure_mode]]\ndevices = [\"box\"]\nsignals = [\"AO4-S-SUPPLY\"]\n";
    EXPECT_THAT(refusal(mode + "mode = \"on fire\"\n"),
                HasSubstr("a.toml:1: the signal `AO4-S-SUPPLY` has no failure mode `on fire`; name one of its modes "
                          "(an output has none): too low, too high"));
    EXPECT_THAT(refusal(mode + "mode = \"NaN\"\ndetected = [\"AO4-A-009\"]\n"),
                HasSubstr("`AO4-A-009` is no requirement or is retired"));
    EXPECT_THAT(refusal(mode + "mode = \"NaN\"\nerrors = [\"fire\"]\n"),
                HasSubstr("no table of errors of box contains the error `fire`"));
    EXPECT_THAT(refusal("[[failure_mode]]\ndevices = [\"bax\"]\nat = \"x\"\nmode = \"y\"\n"),
                HasSubstr("`bax` is no device"));
    EXPECT_THAT(refusal("[[failure_mode]]\ndevices = [\"box\"]\nmode = \"y\"\n"),
                HasSubstr("a failure mode must name either `signals` or `at`, not both"));
    EXPECT_EQ(refusal(mode + "mode = \"NaN\"\n"), "");
}

TEST_F(Documents, ThreatsOfADeviceAreThoseOfItsServices) {
    const Analysis known = analysis(R"([[threat]]
service = "EMCY"
objects = ["1014h"]
requirement = "FR 7"
text = "Flood."
rest = "All."
[[threat]]
service = "Store"
objects = ["1010h"]
requirement = "FR 3"
text = "Wear."
rest = "All."
[[threat]]
service = "LSS"
lss = true
requirement = "FR 2"
text = "Lost."
by = ["AO4-A-001"]
rest = "Some."
)");
    EXPECT_THAT(rows_of(threats(box(), known), "Threats"),
                ElementsAre(ElementsAre("EMCY", "FR 7", "Flood.", "missing", "All."),
                            ElementsAre("LSS", "FR 2", "Lost.", "AO4-A-001", "Some.")));
}

TEST_F(Documents, DocumentIsWrittenAsHtmlMarkdownAndJson) {
    const Document manual = safety_manual(content_, box(), {});
    const std::string page = document_html(manual, {{"AO4-H-001", "hazards.html#AO4-H-001"}});
    EXPECT_THAT(page, HasSubstr("<a href=\"hazards.html#AO4-H-001\">AO4-H-001</a>"));
    EXPECT_THAT(page, HasSubstr("<caption>Constants with a unit</caption>"));
    EXPECT_THAT(document_markdown(manual), HasSubstr("| Table 3 | Rates | The plant \\| has a fuse. |"));
    const auto json = nlohmann::json::parse(document_json(manual));
    EXPECT_EQ(json.at("chapters").at(2).at("tables").at(0).at("rows").at(0).at("Failure"), "The switch is welded.");
}

TEST(DocumentTables, TableWithoutRowsIsReplacedByASentence) {
    const Document document{"d", "D", "About.", {{"Limits", {}, {{"Limits of <x>", {"Signal"}, {}}}}}};
    EXPECT_THAT(document_html(document, {}), HasSubstr("<h2>Limits</h2>\n<p>Limits of &lt;x&gt;: none.</p>\n"));
    EXPECT_THAT(document_markdown(document), HasSubstr("## Limits\n\nLimits of <x>: none.\n"));
}

TEST(DocumentTables, CaptionThatDiffersFromItsHeadingStaysVisible) {
    const DocumentTable own{"Limits of signals", {"Signal"}, {{"x"}}};
    const DocumentTable same{"", {"Signal"}, {{"x"}}};
    const Document document{"d", "D", "About.", {{"Limits", {}, {own}}, {"Rest", {}, {same}}}};
    const std::string page = document_html(document, {});
    // The style sheet hides the caption of a table in a <div> that follows a heading.
    EXPECT_THAT(page, HasSubstr("<h2>Limits</h2>\n<div><div><table><caption>Limits of signals</caption>"));
    EXPECT_THAT(page, HasSubstr("<h2>Rest</h2>\n<div><table><caption>Rest</caption>"));
}

TEST(ResidualErrors, ResidualErrorsFollowTheBinomialDistribution) {
    // Three bits, each wrong with probability 1/2: of the eight patterns 3 + 1 have two or more wrong bits.
    EXPECT_DOUBLE_EQ(two_or_more_wrong(3, 0.5), 4.0 / 8.0);
    // Four bits, each wrong with probability 1/10: 6 * 0.01 * 0.81 + 4 * 0.001 * 0.9 + 0.0001 = 0.0486 + 0.0036 +
    // 0.0001.
    EXPECT_NEAR(two_or_more_wrong(4, 0.1), 0.0523, 1e-15);
    // 111 bits, each wrong with probability 1e-8: only pairs of wrong bits matter, 111 * 110 / 2 = 6105 pairs, each
    // with probability 1e-16.
    EXPECT_NEAR(two_or_more_wrong(111, 1e-8), 6105e-16, 6105e-16 * 2e-6);
    EXPECT_EQ(two_or_more_wrong(111, 0.0), 0.0);
    EXPECT_EQ(longest_frame_bits, 111);
    // A frame passes a CRC of 15 bits with probability 1 / 32768.
    EXPECT_NEAR(undetected_in_frame(1e-8), 6105e-16 / 32768.0, 1e-22);
    // 111,000 bit/s carry 1000 frames of 111 bits per second.
    EXPECT_DOUBLE_EQ(frames_an_hour(111000.0), 3600000.0);
}

}  // namespace canproof::host::test
