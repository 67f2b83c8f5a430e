// The evidence pack of a small register, with evidence made by hand: what it claims, what it tells as open, its data.
#include "host/assess/evidence/pack.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>

#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/freshness.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/base/input_error.hpp"
#include "host/base/sha256.hpp"
#include "host/register/fingerprint.hpp"

namespace canproof::host::test {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class Pack : public ::testing::Test {
  protected:
    Pack() {
        Manual manual;
        manual.key = "M";
        manual.title = "Manual <of> a device";
        manual.sections = {{"1", "rules", true, "", {}, {}, {}},
                           {"2", "housing", false, "", {}, {"It <stays> dry."}, {}}};
        content_.manuals = {manual};
        Part part;
        part.name = "device";
        part.info.manual = "M";
        Requirement first;
        first.id = "D-A-001";
        first.text = "a < b & \"c\", d";
        first.sources = {"M:1"};
        first.verify = {"test"};
        Requirement second = first;
        second.id = "D-A-002";
        part.requirements = {first, second};
        Decision decision;
        decision.id = "D-D-001";
        decision.text = "Which?";
        decision.readings = {{"one", "M:1", {}}, {"other", "M:1", {}}};
        decision.chosen = "One.";
        decision.because = "safer failure";
        decision.affects = {"D-A-001"};
        part.decisions = {decision};
        content_.parts = {part};
        input_.content = &content_;
        claim("D-A-001", "S.One", true);
        claim("D-A-002", "S.Two", true);
        input_.evidence.implemented["D-A-001"] = {"src/firmware/base/one.cpp:3"};
        input_.evidence.implemented["D-A-002"] = {"src/firmware/base/two.cpp:4"};
        input_.argument.claims = {{"C", "", "All is well.", {}, ""},
                                  {"C1", "C", "Tests pass.", {"tests", "audit"}, "Not on silicon."}};
        for (const auto& [id, print] : fingerprints(content_.parts[0])) {
            content_.parts[0].reviews[id] = {print, "", "", "2026-01-02", "someone", "author", "", {}};
        }
        input_.provenance.commit = "abc";
        input_.provenance.packages = {{"libx", "1.2-3"}};
    }

    void claim(const std::string& id, const std::string& test, bool passed) {
        input_.evidence.verdicts[id] = {{test, "test", passed}};
        input_.evidence.cases.push_back({"S", test.substr(2), passed, passed ? "" : "1 is not 2"});
        ++input_.evidence.tests;
        input_.evidence.failed += passed ? 0 : 1;
    }
    PackFiles make() {
        input_.audits = {audit_part(content_, content_.parts[0], input_.evidence)};
        return make_pack(input_);
    }
    /// `✓ holds` or `✗ open` behind the id of a claim on the overview.
    std::string state_of(const std::string& id) {
        const std::string page = make().at("index.html");
        const auto at = page.find("<b>" + id + "</b>");
        const auto begin = page.find('>', at + id.size() + 8) + 1;
        return page.substr(begin, page.find('<', begin) - begin);
    }

    Register content_;
    PackInput input_;
};

pugi::xml_document parsed(const std::string& text) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(text.c_str())) << text.substr(0, 200);
    return document;
}

}  // namespace

TEST_F(Pack, AClaimHoldsWhileItsEvidenceAndTheClaimsBelowItDo) {
    EXPECT_EQ(state_of("C1"), "✓ holds");
    EXPECT_EQ(state_of("C"), "✓ holds");
    input_.evidence.verdicts.erase("D-A-002");  // a gap
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_EQ(state_of("C"), "✗ open");
}

TEST_F(Pack, EvidenceThatIsNotThereShowsNothing) {
    input_.argument.claims[1].evidence = {"target"};
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_THAT(make().at("index.html"), HasSubstr("not measured"));
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

TEST_F(Pack, AFailedTestIsToldWithItsMessage) {
    claim("D-A-002", "S.Three", false);
    const PackFiles files = make();
    EXPECT_THAT(files.at("tests.html"), HasSubstr("S.Three<td data-h=\"Message\"><code>1 is not 2</code>"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("D-A-002: a test that claims it has failed"));
    const auto junit = parsed(files.at("data/junit.xml"));
    EXPECT_STREQ(junit.child("testsuites").attribute("tests").value(), "3");
    EXPECT_STREQ(junit.select_node("//testsuite[@name='S']").node().attribute("failures").value(), "1");
    EXPECT_STREQ(junit.select_node("//testcase[@name='Three']/failure").node().attribute("message").value(),
                 "1 is not 2");
}

TEST_F(Pack, TextOfTheRegisterIsNoMarkup) {
    const PackFiles files = make();
    EXPECT_THAT(files.at("audit.html"), HasSubstr("a &lt; b &amp; &quot;c&quot;, d"));
    EXPECT_THAT(files.at("sections.html"), Not(HasSubstr("<of>")));
}

TEST_F(Pack, SectionsShowTheConditionsOfUse) {
    EXPECT_THAT(make().at("sections.html"), HasSubstr("It &lt;stays&gt; dry."));
}

TEST_F(Pack, CsvIsQuotedWhereItMustBe) {
    const PackFiles files = make();
    EXPECT_THAT(
        files.at("data/requirements.csv"),
        HasSubstr("\r\nD-A-001,device,requirement,\"a < b & \"\"c\"\", d\",M:1,D-D-001,src/firmware/base/one.cpp:3,"
                  "test,test S.One passed,shown\r\n"));
    EXPECT_THAT(files.at("data/decisions.csv"),
                HasSubstr("D-D-001,device,Which?,one (M:1); other (M:1),One.,safer failure,D-A-001\r\n"));
}

TEST_F(Pack, ReqifHasEachItemOnceAndEachReferenceResolves) {
    const auto document = parsed(make().at("data/register.reqif"));
    std::set<std::string> identifiers;
    for (const auto& node : document.select_nodes("//@IDENTIFIER")) {
        EXPECT_TRUE(identifiers.insert(node.attribute().value()).second) << node.attribute().value();
    }
    std::size_t references = 0;
    for (const auto& node : document.select_nodes("//*[contains(name(), '-REF')]")) {
        ++references;
        EXPECT_EQ(identifiers.count(node.node().text().get()), 1U) << node.node().text().get();
    }
    EXPECT_GT(references, 10U);
    EXPECT_EQ(document.select_nodes("//SPEC-OBJECT").size(), 3U);
    const auto relation = document.select_node("//SPEC-RELATION").node();
    EXPECT_STREQ(relation.select_node("SOURCE/SPEC-OBJECT-REF").node().text().get(), "_D-D-001");
    EXPECT_STREQ(relation.select_node("TARGET/SPEC-OBJECT-REF").node().text().get(), "_D-A-001");
}

TEST_F(Pack, TheBillOfMaterialsNamesEachPackage) {
    const auto sbom = nlohmann::json::parse(make().at("data/sbom.cdx.json"));
    EXPECT_EQ(sbom.at("bomFormat"), "CycloneDX");
    EXPECT_EQ(sbom.at("components").at(0).at("purl"), "pkg:deb/debian/libx@1.2-3");
    EXPECT_EQ(sbom.at("dependencies").at(0).at("dependsOn").at(0), "pkg:deb/debian/libx@1.2-3");
}

TEST_F(Pack, TheSameInputGivesTheSameBytesAndTheManifestTheirSums) {
    const PackFiles files = make();
    EXPECT_EQ(files, make());
    const auto manifest = nlohmann::json::parse(write_manifest({{"a.txt", "abc"}}, input_.provenance));
    // SHA-256 of "abc" as FIPS 180-4 prints it
    EXPECT_EQ(manifest.at("sha256").at("a.txt"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(manifest.at("commit"), "abc");
    EXPECT_EQ(nlohmann::json::parse(write_manifest(files, input_.provenance)).at("sha256").size(), files.size());
}

TEST_F(Pack, AnItemThatChangedSinceItsReviewIsToldAsSuspect) {
    content_.parts[0].requirements[1].text = "edited";
    const PackFiles files = make();
    EXPECT_THAT(files.at("index.html"),
                HasSubstr("1 items have changed, in text, code or tests, since someone read them. Readers of the "
                          "other items and decisions: the author of the change 2, someone else 0"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("Changed since they were reviewed (1)"));
    EXPECT_THAT(files.at("audit.html"), HasSubstr("◐ suspect"));
    EXPECT_THAT(files.at("data/requirements.csv"), HasSubstr("test S.Two passed,suspect\r\n"));
}

TEST_F(Pack, OrphansAreListed) {
    input_.argument.claims[1].evidence = {"orphans"};
    EXPECT_EQ(state_of("C1"), "✗ open");
    input_.orphans = std::vector<std::string>{};
    EXPECT_EQ(state_of("C1"), "✓ holds");
    input_.orphans = {"src/firmware/x.cpp serves <nobody>"};
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_THAT(make().at("index.html"), HasSubstr("<li>src/firmware/x.cpp serves &lt;nobody&gt;"));
}

TEST_F(Pack, WhatWasMeasuredBeforeASourceWasWrittenIsStaleAndCarriesNoClaim) {
    input_.newer = {{"tests", "src/firmware/base/one.cpp"}};
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_THAT(
        make().at("index.html"),
        HasSubstr("<a href=\"tests.html\">Tests</a>: src/firmware/base/one.cpp is newer than this measurement"));
}

TEST_F(Pack, WhatAWholePackWouldHoldIsToldWithTheCommandThatLeavesIt) {
    input_.argument.evidence = {{"fuzz", "Fuzzing campaign", "canproof fuzz"}, {"tests", "Tests", "./run"}};
    const std::string page = make().at("index.html");
    EXPECT_THAT(page, HasSubstr("Fuzzing campaign: not part of this pack; canproof fuzz leaves it"));
    EXPECT_THAT(page, Not(HasSubstr("Tests: not part of this pack")));
}

TEST_F(Pack, AnExhibitWithoutAPageGetsOneFromItsFiguresTablesAndPlots) {
    Exhibit exhibit{"scale", "Many devices", Exhibit::State::holds, "1,000 in real time", ""};
    exhibit.files = {{"scale/scale.csv", "devices,seconds,case\r\n1000000,0.5,2.1.1\r\n20,,3.4\r\n1000,12345.25,4\r\n"},
                     {"scale/scale.svg", "<svg/>"}};
    exhibit.figures = {{"devices in real time", "1,000"}};
    exhibit.open = {"nothing beyond 2,000 was tried"};
    exhibit.data = {"scale/scale.csv"};
    input_.exhibits = {exhibit};
    const PackFiles files = make();
    const std::string page = files.at("scale.html");
    // A column of numbers stands right and in groups of three; one with anything else, here sections, does not.
    EXPECT_THAT(page, HasSubstr("<th scope=col class=n>devices<th scope=col class=n>seconds<th scope=col>case"));
    EXPECT_THAT(page, HasSubstr("<tr><td class=n data-h=\"devices\">1,000,000<td class=n data-h=\"seconds\">0.5"
                                "<td data-h=\"case\">2.1.1"));
    EXPECT_THAT(page, HasSubstr("<tr><td class=n data-h=\"devices\">20<td><td data-h=\"case\">3.4"));
    EXPECT_THAT(page, HasSubstr("<tr><td class=n data-h=\"devices\">1,000<td class=n data-h=\"seconds\">12,345.25"));
    EXPECT_THAT(page, HasSubstr("<img src=\"scale/scale.svg\""));
    EXPECT_THAT(page, HasSubstr("<li>nothing beyond 2,000 was tried"));
    EXPECT_EQ(files.at("data/scale.csv"), files.at("scale/scale.csv"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("devices in real time: <b>1,000</b>"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("<a href=\"scale.html\">Many devices</a>: nothing beyond 2,000"));
    EXPECT_THAT(files.at("index.html"), HasSubstr("<a href=\"data/scale.csv\">scale.csv</a>"));
}

TEST_F(Pack, RunsOnARealKernelAreEvidenceOfTheirOwn) {
    input_.argument.claims[1].evidence = {"socketcan"};
    EXPECT_EQ(state_of("C1"), "✗ open");
    input_.socketcan = Evidence{};
    EXPECT_EQ(state_of("C1"), "✗ open");  // no run is no evidence
    input_.socketcan->tests = 2;
    input_.socketcan->cases = {{"socketcan", "sends", true, ""}, {"socketcan", "joins", true, ""}};
    EXPECT_EQ(state_of("C1"), "✓ holds");
    input_.socketcan->failed = 1;
    input_.socketcan->cases[1].passed = false;
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_THAT(make().at("index.html"), HasSubstr("failed: joins"));
}

TEST_F(Pack, MutationIsCountedByItemAndItsSurvivorsAreListed) {
    input_.argument.claims[1].evidence = {"mutation"};
    input_.mutation = MeasuredMutation{
        {{"D-A-001", {10, 9, 1}}, {"D-A-002", {5, 5, 0}}},
        R"({"survivors": [{"item": "D-A-001", "cell": "limit", "change": "5 -> 6", "reason": "same bits"}]})"};
    EXPECT_EQ(state_of("C1"), "✓ holds");
    EXPECT_THAT(make().at("mutation.html"), HasSubstr("5 -&gt; 6<td data-h=\"Reason\">same bits"));
    EXPECT_THAT(make().at("audit.html"), HasSubstr("9 of 10 altered cells noticed"));
    input_.mutation->items["D-A-002"].noticed = 3;
    EXPECT_EQ(state_of("C1"), "✗ open");
    EXPECT_THAT(make().at("index.html"), HasSubstr("2 altered cells of 1 items that no test notices"));
}

TEST_F(Pack, OnlyFilesThatAreThereAreLinked) {
    const PackFiles files = make();
    const std::string page = files.at("index.html");
    EXPECT_THAT(page, Not(HasSubstr("cobertura")));
    for (auto at = page.find("href=\"data/"); at != std::string::npos; at = page.find("href=\"data/", at + 1)) {
        EXPECT_EQ(files.count(page.substr(at + 6, page.find('"', at + 6) - at - 6)), 1U);
    }
}

TEST(Freshness, IsThatOfAMeasurementAsYoungAsItsSources) {
    namespace fs = std::filesystem;
    const fs::path root = fs::path{::testing::TempDir()} / "freshness";
    fs::create_directories(root / "spec");
    const auto now = fs::file_time_type::clock::now();
    const auto write = [&](const char* name, std::chrono::seconds age) {
        std::ofstream{root / name} << name;
        fs::last_write_time(root / name, now - age);
    };
    write("measured.json", std::chrono::seconds{10});
    write("spec/old.toml", std::chrono::seconds{20});
    EXPECT_EQ(newer_source(root, {"spec", "nowhere"}, root / "measured.json"), "");
    write("spec/reviews.toml", std::chrono::seconds{5});
    EXPECT_EQ(newer_source(root, {"spec"}, root / "measured.json"), "");
    write("spec/b.toml", std::chrono::seconds{5});
    write("spec/a.toml", std::chrono::seconds{1});
    EXPECT_EQ(newer_source(root, {"spec"}, root / "measured.json"), "spec/a.toml");
    EXPECT_EQ(newer_source(root, {"spec"}, root / "never.json"), "");
    EXPECT_EQ(oldest_file(root / "spec").string(), (root / "spec/old.toml").string());
    fs::remove_all(root);
    EXPECT_EQ(oldest_file(root).string(), "");
}

TEST(Freshness, SpeaksOfTheFirmwareOfDevicesToo) {
    namespace fs = std::filesystem;
    const fs::path root = fs::path{::testing::TempDir()} / "freshness_of_devices";
    const fs::path file = "src/devices/ax130751/firmware/ramp.cpp";
    fs::create_directories((root / file).parent_path());
    std::ofstream{root / "measured.json"} << "measured";
    std::ofstream{root / file} << "code";
    const auto measured = fs::last_write_time(root / "measured.json");
    fs::last_write_time(root / file, measured - std::chrono::seconds{1});
    for (const auto& sources :
         {firmware_sources(root), firmware_and_tests(root), socketcan_sources(root), target_sources(root)}) {
        EXPECT_EQ(newer_source(root, sources, root / "measured.json"), "");
    }
    fs::last_write_time(root / file, measured + std::chrono::seconds{1});
    for (const auto& sources :
         {firmware_sources(root), firmware_and_tests(root), socketcan_sources(root), target_sources(root)}) {
        EXPECT_EQ(newer_source(root, sources, root / "measured.json"), file.generic_string());
    }
    fs::remove_all(root);
}

TEST(Verdicts, AreThoseOfTheLastRun) {
    namespace fs = std::filesystem;
    const fs::path root = fs::path{::testing::TempDir()} / "verdicts";
    EXPECT_EQ(newest_verdicts(root).string(), (root / "build/release/verdicts").string());
    const auto now = fs::file_time_type::clock::now();
    const auto run = [&](const char* preset, std::chrono::seconds age) {
        const fs::path folder = root / "build" / preset / "verdicts";
        fs::create_directories(folder);
        std::ofstream{folder / "tests.xml"} << "<testsuites/>";
        fs::last_write_time(folder / "tests.xml", now - age);
        return folder.string();
    };
    run("release", std::chrono::seconds{30});
    const std::string coverage = run("coverage", std::chrono::seconds{10});
    run("debug", std::chrono::seconds{20});
    run("mutation", std::chrono::seconds{1});  // of altered tables
    EXPECT_EQ(newest_verdicts(root).string(), coverage);
    fs::remove_all(root);
}

TEST(ArgumentFile, TheOneOfThisProjectIsSoundAndBadOnesAreToldWithTheirLine) {
    const auto file = std::filesystem::path{::testing::TempDir()} / "argument.toml";
    const auto told = [&](const char* text) {
        std::ofstream{file} << text;
        try {
            return std::to_string(read_argument(file).claims.size());
        } catch (const InputError& error) {
            return std::string{error.what()};
        }
    };
    EXPECT_EQ(told("[[claim]]\nid = \"C\"\ntext = \"t\"\n[[claim]]\nid = \"D\"\nparent = \"C\"\ntext = \"t\"\n"), "2");
    EXPECT_THAT(told("[[claim]]\nid = \"C\"\nparent = \"B\"\ntext = \"t\"\n"),
                HasSubstr("argument.toml:3: there is no claim `B` before this one"));
    EXPECT_THAT(told("[[technique]]\ntable = \"T\"\nname = \"n\"\nlevel = \"R\"\nstate = \"maybe\"\nhow = \"h\"\n"),
                HasSubstr("argument.toml:5: "));
    EXPECT_THAT(told("[[claim\n"), HasSubstr("argument.toml:1: "));
    std::filesystem::remove(file);
}

}  // namespace canproof::host::test
