// SPDX-License-Identifier: Apache-2.0
// Tests the data of an evidence pack for other tools: ReqIF, JUnit, CSV, CycloneDX, coverage, the argument, the
// manifest.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>

#include "host/assess/evidence/package_records.hpp"
#include "host/base/input_error.hpp"
#include "host/base/sha256.hpp"
#include "tests/host/assess/evidence/pack_bench.hpp"

namespace canproof::host::test {

namespace {

using ::testing::HasSubstr;

pugi::xml_document parsed(const std::string& text) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(text.c_str())) << text.substr(0, 200);
    return document;
}

}  // namespace

TEST_F(Pack, CsvFieldsAreQuotedWhereNeeded) {
    const PackFiles files = make();
    EXPECT_THAT(
        files.at("data/requirements.csv"),
        HasSubstr("\r\nD-A-001,device,requirement,\"a < b & \"\"c\"\", d\",,M:1,D-D-001,src/firmware/base/one.cpp:3,"
                  "test,test S.One passed,shown\r\n"));
    EXPECT_THAT(files.at("data/decisions.csv"),
                HasSubstr("D-D-001,device,high,Which?,one (M:1); other (M:1),One.,safer failure,D-A-001\r\n"));
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
    EXPECT_EQ(document.select_nodes("//SPEC-OBJECT").size(), 4U);  // two requirements, a decision, a normative section
    EXPECT_EQ(document.select_nodes("//SPEC-RELATION").size(),
              3U);  // relations: one affected item, two items that cover section 1
    const auto relation = document.select_node("//SPEC-RELATION[TYPE/SPEC-RELATION-TYPE-REF='_type-affects']").node();
    const auto cover = document.select_node("//SPEC-RELATION[TYPE/SPEC-RELATION-TYPE-REF='_type-covers']").node();
    EXPECT_STREQ(cover.select_node("SOURCE/SPEC-OBJECT-REF").node().text().get(), "_D-A-001");
    EXPECT_STREQ(cover.select_node("TARGET/SPEC-OBJECT-REF").node().text().get(), "_section-device-1");
    EXPECT_STREQ(relation.select_node("SOURCE/SPEC-OBJECT-REF").node().text().get(), "_D-D-001");
    EXPECT_STREQ(relation.select_node("TARGET/SPEC-OBJECT-REF").node().text().get(), "_D-A-001");
}

TEST_F(Pack, ReqifHasCodeTestsAndReviewOfAnItem) {
    const auto document = parsed(make().at("data/register.reqif"));
    const auto value = [&](const char* attribute) {
        const std::string path =
            std::string{
                "//SPEC-OBJECT[@IDENTIFIER='_D-A-001']//ATTRIBUTE-VALUE-STRING[DEFINITION/"
                "ATTRIBUTE-DEFINITION-STRING-REF='"} +
            attribute + "']/@THE-VALUE";
        return std::string{document.select_node(path.c_str()).attribute().value()};
    };
    EXPECT_EQ(value("_attribute-code"), "src/firmware/base/one.cpp:3");
    EXPECT_EQ(value("_attribute-tests"), "S.One (test, passed)");
    EXPECT_EQ(value("_attribute-review"), "2026-01-02, someone, author; no independent review");
    EXPECT_EQ(value("_attribute-state"), "shown");
}

TEST_F(Pack, JunitCaseHasTheTimeFileAndRequirementOfItsTest) {
    input_.evidence.cases[0].seconds = 0.25;
    input_.evidence.cases[0].file = "tests/one_test.cpp";
    input_.evidence.cases[0].items = {"D-A-001"};
    const auto document = parsed(make().at("data/junit.xml"));
    EXPECT_STREQ(document.select_node("//testsuite").node().attribute("errors").value(), "0");
    const auto one = document.select_node("//testcase[@name='One']").node();
    EXPECT_STREQ(one.attribute("time").value(), "0.250");
    EXPECT_STREQ(one.attribute("file").value(), "tests/one_test.cpp");
    EXPECT_STREQ(one.select_node("properties/property[@name='requirement']").node().attribute("value").value(),
                 "D-A-001");
    EXPECT_FALSE(document.select_node("//testcase[@name='Two']").node().child("properties"));
}

TEST_F(Pack, BillOfMaterialsNamesEachPackage) {
    input_.provenance.packages["toolx"] = "3";
    input_.provenance.package_sums = {{"libx", std::string(64, 'a')}};
    input_.packages.packages = {{"libx", "required", "MIT"}, {"toolx", "excluded", ""}};
    input_.packages.vulnerabilities = {{"CVE-2026-1", "libx", "not_affected", "The function is not called."},
                                       {"CVE-2026-2", "libx", "fixed", "1.2-3 repairs it."},
                                       {"CVE-2026-3", "libx", "affected", "Read no foreign key."},
                                       {"CVE-2026-4", "libx", "in_triage", "Not judged yet."}};
    const auto sbom = nlohmann::json::parse(make().at("data/sbom.cdx.json"));
    EXPECT_EQ(sbom.at("bomFormat"), "CycloneDX");
    EXPECT_EQ(sbom.at("specVersion"), "1.6");
    const auto& library = sbom.at("components").at(0);
    EXPECT_EQ(library.at("purl"), "pkg:deb/debian/libx@1.2-3");
    EXPECT_EQ(library.at("scope"), "required");
    EXPECT_EQ(library.at("hashes").at(0).at("content"), std::string(64, 'a'));
    EXPECT_EQ(library.at("licenses").at(0).at("expression"), "MIT");
    EXPECT_EQ(sbom.at("components").at(1).at("licenses").at(0).at("license").at("name"),
              "several licences: /usr/share/doc/toolx/copyright");
    // The program depends on the libraries that it links, not on the build tools.
    EXPECT_EQ(sbom.at("dependencies").at(0).at("dependsOn").size(), 1U);
    EXPECT_EQ(sbom.at("dependencies").at(0).at("dependsOn").at(0), "pkg:deb/debian/libx@1.2-3");
    EXPECT_EQ(sbom.at("vulnerabilities").at(0).at("analysis").at("state"), "not_affected");
    EXPECT_EQ(sbom.at("vulnerabilities").at(1).at("analysis").at("state"), "resolved");
    EXPECT_EQ(sbom.at("vulnerabilities").at(2).at("analysis").at("state"), "exploitable");
    EXPECT_EQ(sbom.at("vulnerabilities").at(3).at("analysis").at("state"), "in_triage");
    EXPECT_EQ(sbom.at("vulnerabilities").at(0).at("affects").at(0).at("ref"), "pkg:deb/debian/libx@1.2-3");
}

TEST(PackageRecordsFile, VulnerabilityOfAnUnknownPackageIsRefused) {
    const auto file = std::filesystem::path{::testing::TempDir()} / "packages.toml";
    const std::string package = "[[package]]\nname = \"libx\"\nscope = \"required\"\n";
    std::ofstream{file} << package << "licence = \"MIT\"\n";
    EXPECT_EQ(read_package_records(file).package("libx")->licence, "MIT");
    EXPECT_EQ(read_package_records(file).package("liby"), nullptr);
    std::ofstream{file} << package
                        << "[[vulnerability]]\nid = \"CVE-1\"\npackage = \"liby\"\nstate = \"fixed\"\ndetail = \"d\"\n";
    EXPECT_THROW(read_package_records(file), InputError);
    std::filesystem::remove(file);
    EXPECT_TRUE(read_package_records(file).packages.empty());
}

TEST_F(Pack, ArgumentIsExportedWithGoalsAndSolutions) {
    const auto argument = nlohmann::json::parse(make().at("data/argument.json"));
    EXPECT_EQ(argument.at("goals").at(1).at("id"), "C1");
    EXPECT_EQ(argument.at("goals").at(1).at("supports"), "C");
    EXPECT_EQ(argument.at("goals").at(1).at("state"), "holds");
    EXPECT_EQ(argument.at("goals").at(1).at("context"), "Not on silicon.");
    EXPECT_EQ(argument.at("goals").at(1).at("solutions").size(), 2U);
    EXPECT_EQ(argument.at("solutions").at("tests").at("state"), "holds");
    // The graph on the page of the argument: a box for each claim and each piece of evidence, each with a link.
    const std::string page = make().at("argument.html");
    EXPECT_THAT(page, HasSubstr("<a href=\"#C1\">"));
    EXPECT_THAT(page, HasSubstr("role=\"group\""));
}

TEST_F(Pack, ArgumentIsExportedAsSacm) {
    input_.argument.claims.push_back({"C2", "C", "Code is \"measured\".", {"fuzz"}, ""});
    const auto document = parsed(make().at("data/argument.sacm.xmi"));
    const auto element = [&](const std::string& id) {
        return document.select_node(("//*[@xmi:id='" + id + "']").c_str()).node();
    };
    EXPECT_STREQ(element("C1").attribute("xsi:type").value(), "argumentation_:Claim");
    EXPECT_STREQ(element("C1").select_node("content/value/@content").attribute().value(), "Tests pass.");
    EXPECT_STREQ(element("C1").select_node("note/content/value/@content").attribute().value(),
                 "Limits: Not on silicon.");
    EXPECT_STREQ(element("C1").attribute("assertionDeclaration").value(), "asserted");
    // Fuzzing was not measured: the claim, the claim above it and the evidence need support.
    for (const char* id : {"C", "C2", "evidence.C2.fuzz"}) {
        EXPECT_STREQ(element(id).attribute("assertionDeclaration").value(), "needsSupport") << id;
    }
    EXPECT_STREQ(element("inference.C").attribute("source").value(), "C1 C2");
    EXPECT_STREQ(element("inference.C").attribute("target").value(), "C");
    EXPECT_STREQ(element("evidence.C1.tests").attribute("source").value(), "reference.tests");
    EXPECT_STREQ(element("reference.tests").attribute("referencedArtifactElement").value(), "artifact.tests");
    EXPECT_STREQ(element("artifact.tests").attribute("version").value(), "abc");
}

TEST_F(Pack, McdcIsExportedAsJson) {
    FileCoverage file;
    file.file = "src/firmware/base/one.cpp";
    file.conditions = {3, 4};
    file.gaps = {{"condition", file.file, 7, "a && b", "b is not shown to decide"},
                 {"line", file.file, 9, "x", "never"}};
    input_.coverage = MeasuredCoverage{{file}, {}};
    input_.coverage->verdict.gaps = {{file.gaps[0], "b is always true"}};
    const auto coverage = nlohmann::json::parse(make().at("data/coverage.json"));
    EXPECT_EQ(coverage.at("conditions").at("covered"), 3);
    EXPECT_EQ(coverage.at("conditions").at("total"), 4);
    EXPECT_EQ(coverage.at("files").at(0).at("conditions").at("covered"), 3);
    ASSERT_EQ(coverage.at("gaps").size(), 1U);
    EXPECT_EQ(coverage.at("gaps").at(0).at("kind"), "condition");
    EXPECT_EQ(coverage.at("gaps").at(0).at("line"), 7);
    EXPECT_EQ(coverage.at("gaps").at(0).at("reason"), "b is always true");
}

TEST_F(Pack, PackIsReproducible_AndTheManifestHasTheHashesOfItsFiles) {
    const PackFiles files = make();
    EXPECT_EQ(files, make());
    const auto manifest = nlohmann::json::parse(write_manifest({{"a.txt", "abc"}}, input_.provenance));
    // SHA-256 of "abc" as FIPS 180-4 prints it
    EXPECT_EQ(manifest.at("sha256").at("a.txt"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(manifest.at("commit"), "abc");
    EXPECT_EQ(nlohmann::json::parse(write_manifest(files, input_.provenance)).at("sha256").size(), files.size());
}

}  // namespace canproof::host::test
