// SPDX-License-Identifier: Apache-2.0
// Tests the evidence pack of a small register: its claims, its open points, its pages.
#include "host/assess/evidence/pack.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <pugixml.hpp>

#include "host/assess/evidence/exhibit.hpp"
#include "tests/host/assess/evidence/pack_bench.hpp"

namespace canproof::host::test {

namespace {

using ::testing::HasSubstr;
using ::testing::Not;

pugi::xml_document parsed_file(const std::string& text) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(text.c_str())) << text.substr(0, 200);
    return document;
}

}  // namespace

TEST_F(Pack, ClaimHoldsWhileItsEvidenceAndItsSubclaimsHold) {
    EXPECT_EQ(state_of("C1"), "✓ holds");
    EXPECT_EQ(state_of("C"), "✓ holds");
    input_.evidence.verdicts.erase("D-A-002");  // no test result for D-A-002: a gap
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_EQ(state_of("C"), "✗ open");
}

TEST_F(Pack, AbsentEvidenceSupportsNoClaim) {
    input_.argument.claims[1].evidence = {"target"};
    EXPECT_EQ(state_of("C1"), "○ not measured");
    EXPECT_EQ(state_of("C"), "○ not measured");
    EXPECT_THAT(make().at("index.html"), HasSubstr("<b>0 of 2 claims hold; 2 wait for evidence that was not measured"));
    input_.exhibits = {{"target",
                        "On target",
                        Exhibit::State::holds,
                        "all equal",
                        "target/index.html",
                        {{"target/index.html", "<p>page"}, {"target/log.txt", "1"}}}};
    EXPECT_EQ(state_of("C1"), "✓ holds");
    const PackFiles files = make();
    EXPECT_EQ(files.at("target/log.txt"), "1");
    EXPECT_THAT(files.at("audit.html"), HasSubstr("<a href=\"target/index.html\">On target</a>"));
    input_.exhibits[0].state = Exhibit::State::open;
    EXPECT_EQ(state_of("C1"), "✗ open");
}

TEST_F(Pack, ClaimWithOpenAndUnmeasuredEvidenceIsOpen) {
    input_.argument.claims[1].evidence = {"target", "tests"};
    claim("D-A-002", "S.Three", false);
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_EQ(state_of("C"), "✗ open");
}

TEST_F(Pack, FailedTestIsShownWithItsMessage) {
    claim("D-A-002", "S.Three", false);
    const PackFiles files = make();
    EXPECT_THAT(files.at("tests.html"), HasSubstr("S.Three<td data-h=\"Message\"><code>1 is not 2</code>"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("D-A-002: a test that verifies this item has failed"));
    const auto junit = parsed_file(files.at("data/junit.xml"));
    EXPECT_STREQ(junit.child("testsuites").attribute("tests").value(), "3");
    EXPECT_STREQ(junit.select_node("//testsuite[@name='S']").node().attribute("failures").value(), "1");
    EXPECT_STREQ(junit.select_node("//testcase[@name='Three']/failure").node().attribute("message").value(),
                 "1 is not 2");
}

TEST_F(Pack, RegisterTextIsEscapedInHtml) {
    const PackFiles files = make();
    EXPECT_THAT(files.at("audit-device.html"), HasSubstr("a &lt; b &amp; &quot;c&quot;, d"));
    EXPECT_THAT(files.at("sections.html"), Not(HasSubstr("<of>")));
}

TEST_F(Pack, PageOfManualSectionsShowsTheConditionsOfUse) {
    EXPECT_THAT(make().at("sections.html"), HasSubstr("It &lt;stays&gt; dry."));
}

TEST_F(Pack, EachPageNamesItsSourceRevision) {
    input_.provenance.date = "2026-01-02T03:04:05Z";
    input_.exhibits = {{"rules",
                        "Rules",
                        Exhibit::State::holds,
                        "all kept",
                        "rules/report.html",
                        {{"rules/report.html", "<!doctype html><main><h1>Own heading</h1><p>Body</p></main>"}}}};
    for (const auto& [name, text] : make()) {
        if (name.size() > 5 && name.substr(name.size() - 5) == ".html") {
            EXPECT_THAT(text, HasSubstr("<footer>canproof abc, 2026-01-02T03:04:05Z</footer>")) << name;
            EXPECT_THAT(text, HasSubstr("@page{@top-left{content:\"")) << name;
            EXPECT_THAT(text, HasSubstr("@bottom-left{content:\"canproof abc, 2026-01-02T03:04:05Z\"")) << name;
        }
    }
}

TEST_F(Pack, ReportPageOfAToolGetsTheMenuAndHeadingOfThePack) {
    input_.exhibits = {{"rules",
                        "Rules",
                        Exhibit::State::open,
                        "one broken",
                        "rules/report.html",
                        {{"rules/report.html", "<!doctype html><main><h1>Own heading</h1><p>Body</p></main>"}}}};
    input_.exhibits[0].open = {"rule <1>"};
    const std::string page = make().at("rules/report.html");
    EXPECT_THAT(page, HasSubstr("<a href=\"../audit.html\">Audit</a>"));
    EXPECT_THAT(page, HasSubstr("<a href=\"../rules/report.html\" aria-current=true>Rules</a>"));
    EXPECT_THAT(page, HasSubstr("<main><h1>Rules</h1>\n<p><span class=\"state open\">✗ open</span></p>\n"
                                "<h2>Open</h2>\n<ul><li>rule &lt;1&gt;\n</ul>\n<p>Body</p></main>"));
    EXPECT_THAT(page, Not(HasSubstr("Own heading")));
}

TEST_F(Pack, EachTableOfEachPageHasACaption) {
    input_.argument.techniques = {{"IEC A.1", "Requirements", "1a", "Semi-formal methods", "HR", "shown", "Tables."}};
    std::size_t tables = 0;
    for (const auto& [name, text] : make()) {
        if (name.size() > 5 && name.substr(name.size() - 5) == ".html") {
            for (auto at = text.find("<table>"); at != std::string::npos; at = text.find("<table>", at + 1)) {
                ++tables;
                EXPECT_EQ(text.compare(at, 16, "<table><caption>"), 0) << name << ": " << text.substr(at, 80);
                EXPECT_NE(text.compare(at, 26, "<table><caption></caption>"), 0) << name << ": " << text.substr(at, 80);
            }
        }
    }
    EXPECT_GT(tables, 20U);
}

TEST_F(Pack, DecisionShowsItsReviewOrWhyThereIsNone) {
    EXPECT_THAT(make().at("decisions.html"), HasSubstr("<small>reviewed 2026-01-02 by "));
    content_.parts[0].decisions[0].chosen = "the other";
    EXPECT_THAT(make().at("decisions.html"), HasSubstr("<small>changed since its review of 2026-01-02</small>"));
    content_.parts[0].reviews.erase(content_.parts[0].decisions[0].id);
    EXPECT_THAT(make().at("decisions.html"), HasSubstr("<small>never reviewed</small>"));
}

TEST_F(Pack, TechniqueTablesOfTheSafetyStandardsHaveAPage) {
    input_.argument.techniques = {{"IEC A.1", "Requirements", "1a", "Semi-formal <methods>", "HR", "shown", "Tables."},
                                  {"IEC A.1", "Requirements", "1b", "Formal methods", "R", "missing", "None."},
                                  {"IEC A.2", "Architecture", "1", "Voting", "R", "not applicable", "One channel."}};
    const PackFiles files = make();
    const std::string& page = files.at("standards.html");
    EXPECT_THAT(page, HasSubstr("3 rows: 1 shown, 0 partly, 1 missing, 1 not applicable; 0 rest on evidence that is"));
    EXPECT_THAT(page, HasSubstr("<h2>IEC A.2: Architecture</h2>"));
    EXPECT_THAT(page, HasSubstr("Semi-formal &lt;methods&gt;"));
    EXPECT_THAT(page, HasSubstr("✗ missing"));
    EXPECT_THAT(page, HasSubstr("○ not applicable"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("IEC A.1, Formal methods: None."));
    EXPECT_THAT(files.at("index.html"), Not(HasSubstr("Voting")));
}

TEST_F(Pack, TechniqueIsShownOnlyWhileTheExhibitsThatItNamesHold) {
    input_.argument.evidence = {{"coverage", "Coverage", "tests/coverage"}};
    input_.argument.techniques = {
        {"IEC B.2", "Tests", "7b", "Statements", "HR", "shown", "Measured.", {"coverage", "tests"}},
        {"IEC B.2", "Tests", "1", "Boundaries", "HR", "partly", "By tests.", {"tests"}}};
    const PackFiles files = make();
    const std::string& page = files.at("standards.html");
    EXPECT_THAT(page, HasSubstr("2 rows: 0 shown, 1 partly, 0 missing, 0 not applicable; 1 rest on evidence that is"));
    EXPECT_THAT(page, HasSubstr("○ not measured"));
    EXPECT_THAT(page, HasSubstr("Measured. In this pack, this does not count as shown: the evidence (Coverage) is not "
                                "measured."));
    EXPECT_THAT(page, HasSubstr("◐ partly"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("IEC B.2, Statements: Measured. In this pack"));
    claim("D-A-002", "S.Three", false);
    EXPECT_THAT(make().at("standards.html"), HasSubstr("By tests. In this pack, this does not count as partly: the "
                                                       "evidence (Tests) is open."));
}

TEST_F(Pack, ToolIsListedWithItsPackageVersion_AndAToolOfCanproofWithItsCommit) {
    input_.argument.tools = {{"linker <x>", "libx", "Wrong code.", "Tests.", "T3", "None met."},
                             {"own", "", "A gap.", "Tests.", "T2", "None met."},
                             {"gone", "liby", "A gap.", "Tests.", "T2", "None met."}};
    const std::string page = make().at("argument.html");
    EXPECT_THAT(page, HasSubstr("linker &lt;x&gt;<td data-h=\"Class\">T3<td data-h=\"Version\">1.2-3"));
    EXPECT_THAT(page, HasSubstr("own<td data-h=\"Class\">T2<td data-h=\"Version\">commit abc"));
    EXPECT_THAT(page, HasSubstr("gone<td data-h=\"Class\">T2<td data-h=\"Version\">not installed"));
}

TEST_F(Pack, EachTestCaseIsListedWithItsSuite) {
    const std::string page = make().at("tests.html");
    EXPECT_THAT(page, HasSubstr("<td data-h=\"Suite\">S<td class=n data-h=\"Cases\">2<td data-h=\"State\">"));
    EXPECT_THAT(page, HasSubstr("<td data-h=\"Names\">One, Two"));
}

TEST_F(Pack, DocumentsOfADeviceAreListedAndLinked) {
    const PackFiles files = make();
    for (const char* name :
         {"safety-manual", "hardware-interface", "interface-control", "error-matrix", "failure-modes", "threats"}) {
        const std::string page = std::string{"device-"} + name + ".html";
        EXPECT_EQ(files.count(page), 1U) << page;
        EXPECT_EQ(files.count(std::string{"documents/device/"} + name + ".md"), 1U) << name;
        EXPECT_THAT(files.at("documents.html"), HasSubstr("href=\"" + page + "\""));
    }
    EXPECT_EQ(files.count("all-residual-errors.html"), 1U);
    EXPECT_THAT(files.at("device-safety-manual.html"), HasSubstr("href=\"decisions.html#D-D-001\""));
    EXPECT_THAT(files.at("device-safety-manual.html"), HasSubstr("It &lt;stays&gt; dry."));
}

TEST_F(Pack, ItemChangedSinceItsReviewIsShownAsSuspect) {
    content_.parts[0].requirements[1].text = "edited";
    const PackFiles files = make();
    EXPECT_THAT(files.at("index.html"),
                HasSubstr("1 items, decisions, hazards or dispositions of sections have changed since their latest "
                          "review; for 0 items this review did not include code and tests. Independent readers have "
                          "read 0 of 2 items with code and tests; their review of 0 has expired, and 2 have none. "
                          "Independent readers have read 0 of 1 decisions; their review of 0 has expired, and 1 have "
                          "none. Independent readers have read 0 of 2 dispositions of sections; their review of 0 has "
                          "expired, and 2 have none."));
    EXPECT_THAT(files.at("index.html"), HasSubstr("Changed since they were reviewed (1)"));
    EXPECT_THAT(files.at("audit-device.html"), HasSubstr("◐ suspect"));
    EXPECT_THAT(files.at("data/requirements.csv"), HasSubstr("test S.Two passed,suspect\r\n"));
}

TEST_F(Pack, IndependentReviewsAreCountedAndTheExpiredOnesAreListed) {
    Part& part = content_.parts[0];
    const auto prints = fingerprints(part);
    const auto independent = [](const std::string& print) {
        return Review{print, "", "", "2025-12-31", "a <reader>", "independent", "", {}};
    };
    part.independent_reviews["D-A-001"] = independent("00000000");
    part.reviews["D-D-001"] = independent(prints.at("D-D-001"));
    const PackFiles files = make();
    const std::string& page = files.at("reviews.html");
    const std::array<const char*, 8> columns{
        "In force", "Independent",        "Independent, text alone", "Independent, expired", "No independent review",
        "Author",   "Author, text alone", "Role not recorded"};
    const auto row_of_all = [&columns](const std::array<int, 8>& numbers) {
        std::string row = "<td data-h=\"Part\">all";
        for (std::size_t i = 0; i < columns.size(); ++i) {
            row += fmt::format("<td class=n data-h=\"{}\">{}", columns[i], numbers[i]);
        }
        return row;
    };
    EXPECT_THAT(page, HasSubstr(row_of_all({2, 0, 0, 1, 1, 2, 0, 0}))) << "items";
    EXPECT_THAT(page, HasSubstr(row_of_all({1, 1, 0, 0, 0, 0, 0, 0}))) << "decisions";
    EXPECT_THAT(page, HasSubstr("2025-12-31 by a &lt;reader&gt;, not the author of the change"));
    EXPECT_THAT(page, HasSubstr("<a href=\"audit-device.html#D-A-001\">D-A-001</a>"));
    const std::string& audit = files.at("audit-device.html");
    EXPECT_THAT(audit,
                HasSubstr("author of the change; read: item; independent review by a &lt;reader&gt; has expired: "
                          "changed since its review of 2025-12-31</small>"));
    EXPECT_THAT(audit, HasSubstr("author of the change; read: item; no independent review</small>")) << "D-A-002";
    EXPECT_THAT(files.at("data/register.reqif"), HasSubstr("2026-01-02, someone, author; no independent review"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("<a href=\"reviews.html\">Suspects</a>"));
}

TEST_F(Pack, SourceFileThatServesNoItemIsListed_AndTheClaimAboutSourceFilesIsOpen) {
    input_.argument.claims[1].evidence = {"orphans"};
    EXPECT_EQ(state_of("C1"), "○ not measured");
    input_.orphans = std::vector<std::string>{};
    EXPECT_EQ(state_of("C1"), "✓ holds");
    input_.orphans = {"src/firmware/x.cpp serves <nobody>"};
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_THAT(make().at("index.html"), HasSubstr("<li>src/firmware/x.cpp serves &lt;nobody&gt;"));
}

TEST_F(Pack, MeasurementOlderThanItsSourceIsStaleAndSupportsNoClaim) {
    input_.newer = {{"tests", "src/firmware/base/one.cpp"}};
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_THAT(
        make().at("index.html"),
        HasSubstr("<a href=\"tests.html\">Tests</a>: src/firmware/base/one.cpp has changed since this measurement"));
}

TEST_F(Pack, MissingEvidenceIsListedWithTheCommandThatCreatesIt) {
    input_.argument.evidence = {{"fuzz", "Fuzzing campaign", "canproof fuzz"}, {"tests", "Tests", "./run"}};
    const std::string page = make().at("index.html");
    EXPECT_THAT(page, HasSubstr("Fuzzing campaign: not part of this pack; canproof fuzz creates it"));
    EXPECT_THAT(page, Not(HasSubstr("Tests: not part of this pack")));
}

TEST_F(Pack, UnreadableMeasurementOfAnEarlierStateCountsAsStaleAndNotAsAbsent) {
    input_.argument.evidence = {{"coverage", "Coverage", "tests/coverage"}};
    input_.argument.claims[1].evidence = {"coverage"};
    EXPECT_EQ(state_of("C1"), "○ not measured");
    input_.newer = {{"coverage", "src/firmware/base/one.cpp"}};
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_THAT(make().at("index.html"), HasSubstr("src/firmware/base/one.cpp has changed since this measurement"));
}

TEST_F(Pack, EvidenceWithoutAPageGetsAPageWithItsNumbersTablesAndPlots) {
    Exhibit exhibit{"scale", "Many devices", Exhibit::State::holds, "1,000 in real time", ""};
    exhibit.files = {{"scale/scale.csv",
                      "devices,seconds,case\r\n1000000,0.5,2.1.1\r\n20,,3.4\r\n1000,12345.25,4\r\n"
                      "1,1,\"a \"\"wire\"\", cut\"\r\n2,2,\"\"\r\n3,3,\"\"\"\"\r\n"},
                     {"scale/bare.svg", "<svg/>"},
                     {"scale/scale.svg",
                      "<svg aria-label=\"Growth of &quot;ms&quot;. Plot of a.\"><title>Growth of "
                      "&quot;ms&quot;</title></svg>"}};
    exhibit.figures = {{"devices in real time", "1,000"}};
    exhibit.open = {"nothing beyond 2,000 was tried"};
    exhibit.data = {"scale/scale.csv"};
    input_.exhibits = {exhibit};
    const PackFiles files = make();
    const std::string page = files.at("scale.html");
    // A column of numbers is right-aligned and grouped by three digits; a column with other text, here sections, is
    // not.
    EXPECT_THAT(page, HasSubstr("<th scope=col class=n>devices<th scope=col class=n>seconds<th scope=col>case"));
    EXPECT_THAT(page, HasSubstr("<tr><td class=n data-h=\"devices\">1,000,000<td class=n data-h=\"seconds\">0.5"
                                "<td data-h=\"case\">2.1.1"));
    EXPECT_THAT(page, HasSubstr("<tr><td class=n data-h=\"devices\">20<td><td data-h=\"case\">3.4"));
    EXPECT_THAT(page, HasSubstr("<tr><td class=n data-h=\"devices\">1,000<td class=n data-h=\"seconds\">12,345.25"));
    EXPECT_THAT(page, HasSubstr("<td data-h=\"case\">a &quot;wire&quot;, cut\n"));  // quotes are doubled in CSV
    EXPECT_THAT(page, HasSubstr("<td class=n data-h=\"seconds\">2<td>\n"));
    EXPECT_THAT(page, HasSubstr("<td class=n data-h=\"seconds\">3<td data-h=\"case\">&quot;"));
    EXPECT_THAT(page, HasSubstr("<figure><img src=\"scale/scale.svg\" alt=\"Growth of &quot;ms&quot;. Plot of a.\">"
                                "<figcaption>Growth of &quot;ms&quot;</figcaption></figure>"));
    EXPECT_THAT(page, HasSubstr("<figure><img src=\"scale/bare.svg\" alt=\"Plot of the figures of Many devices\">"
                                "<figcaption>Many devices</figcaption></figure>"));
    EXPECT_THAT(page, HasSubstr("<li>nothing beyond 2,000 was tried"));
    EXPECT_EQ(files.at("data/scale.csv"), files.at("scale/scale.csv"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("devices in real time: <b>1,000</b>"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("<a href=\"scale.html\">Many devices</a>: nothing beyond 2,000"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("<a href=\"data/scale.csv\">scale.csv</a>"));
}

TEST_F(Pack, RunsOnARealLinuxKernelAreSeparateEvidence) {
    input_.argument.claims[1].evidence = {"socketcan"};
    EXPECT_EQ(state_of("C1"), "○ not measured");
    input_.socketcan = Evidence{};
    EXPECT_EQ(state_of("C1"), "✗ open");  // a run without tests is no evidence
    input_.socketcan->tests = 2;
    input_.socketcan->cases = {{"socketcan", "sends", true, ""}, {"socketcan", "joins", true, ""}};
    EXPECT_EQ(state_of("C1"), "✓ holds");
    input_.socketcan->failed = 1;
    input_.socketcan->cases[1].passed = false;
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_THAT(make().at("index.html"), HasSubstr("failed: joins"));
}

TEST_F(Pack, MutantsAreCountedByItemAndSurvivorsAreListed) {
    input_.argument.claims[1].evidence = {"mutation"};
    input_.mutation = MeasuredMutation{
        {{"D-A-001", {10, 9, 1}}, {"D-A-002", {5, 5, 0}}},
        R"({"survivors": [{"item": "D-A-001", "cell": "limit", "change": "5 -> 6", "reason": "same bits"}]})"};
    EXPECT_EQ(state_of("C1"), "✓ holds");
    EXPECT_THAT(make().at("mutation.html"), HasSubstr("5 -&gt; 6<td data-h=\"Reason\">same bits"));
    EXPECT_THAT(make().at("audit-device.html"), HasSubstr("9 of 10 altered cells noticed"));
    input_.mutation->items["D-A-002"].noticed = 3;
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_THAT(make().at("index.html"), HasSubstr("2 altered cells of 1 items that no test notices"));
}

TEST_F(Pack, PlotsHaveACaptionAndAnAlternativeText) {
    input_.figures["lamp.svg"] = {"Light of a <lamp>", "<svg/>",
                                  "Light of a lamp. Plot of <lux> against seconds: lamp."};
    const PackFiles files = make();
    EXPECT_EQ(files.at("plots/lamp.svg"), "<svg/>");
    EXPECT_THAT(files.at("plots.html"),
                HasSubstr("alt=\"Light of a lamp. Plot of &lt;lux&gt; against seconds: lamp.\""));
    EXPECT_THAT(files.at("plots.html"), HasSubstr("<figcaption>Light of a &lt;lamp&gt;</figcaption>"));
}

TEST_F(Pack, OnlyExistingDataFilesAreLinked) {
    const PackFiles files = make();
    const std::string page = files.at("index.html");
    EXPECT_THAT(page, Not(HasSubstr("cobertura")));
    for (auto at = page.find("href=\"data/"); at != std::string::npos; at = page.find("href=\"data/", at + 1)) {
        EXPECT_EQ(files.count(page.substr(at + 6, page.find('"', at + 6) - at - 6)), 1U);
    }
}

}  // namespace canproof::host::test
