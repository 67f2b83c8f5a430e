// The evidence pack of a small register, with evidence made by hand: what it claims, what it tells as open, its data.
#include "host/evidence/pack.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>

#include "host/bus/candump.hpp"
#include "host/evidence/sha256.hpp"

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
        manual.sections = {{"1", "rules", true, "", {}, {}}};
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

TEST(Exhibits, AreReadFromFoldersAndBadOnesAreTold) {
    const auto root = std::filesystem::path{::testing::TempDir()} / "exhibits";
    std::filesystem::create_directories(root / "fuzz" / "data");
    std::filesystem::create_directories(root / "empty");
    std::ofstream{root / "fuzz/exhibit.json"}
        << R"({"title": "Fuzzing", "state": "open", "says": "one finding", "page": "report.html"})";
    std::ofstream{root / "fuzz/report.html"} << "<p>";
    std::ofstream{root / "fuzz/data/a"} << "b";
    const auto found = read_exhibits(root);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].key, "fuzz");
    EXPECT_EQ(found[0].state, Exhibit::State::open);
    EXPECT_EQ(found[0].page, "fuzz/report.html");
    EXPECT_EQ(found[0].files, (std::map<std::string, std::string>{{"fuzz/data/a", "b"}, {"fuzz/report.html", "<p>"}}));
    const auto told = [&](const char* text) {
        std::ofstream{root / "fuzz/exhibit.json"} << text;
        try {
            return std::to_string(read_exhibits(root).size());
        } catch (const InputError& error) {
            return std::string{error.what()};
        }
    };
    EXPECT_THAT(told(R"({"title": "x", "state": "fine", "says": ""})"), HasSubstr("state `fine` is neither"));
    EXPECT_THAT(told(R"({"title": "x"})"), HasSubstr("it needs title, state and says"));
    EXPECT_THAT(told("nothing"), HasSubstr("exhibit.json"));
    std::filesystem::remove_all(root);
    EXPECT_TRUE(read_exhibits(root).empty());
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
