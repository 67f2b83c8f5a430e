// SPDX-License-Identifier: Apache-2.0
// Tests the pages of the audit: items by part and service, with links to the sources of their code and tests.
#include "host/assess/evidence/audit_pages.hpp"

#include <gmock/gmock.h>

#include "host/assess/evidence/source_pages.hpp"
#include "tests/host/assess/evidence/pack_bench.hpp"
#include "tests/support/scratch_folder.hpp"

namespace canproof::host::test {

namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class AuditPages : public Pack {
  protected:
    AuditPages() {
        content_.parts[0].requirements[0].place.file = "spec/devices/device/behaviour/sdo_block.toml";
        content_.parts[0].requirements[1].place.file = "spec/devices/device/objects/relay.toml";
        input_.evidence.verdicts["D-A-001"] = {{"S.One", "test", true, 0.0, "tests/one_test.cpp", 2}};
        input_.sources = {{"src/firmware/base/one.cpp", "int one;\n\nstatic_assert(a < b);\nint f();\n"},
                          {"tests/one_test.cpp", "// first\nTEST(S, One) {}\n"}};
    }
};

}  // namespace

TEST_F(AuditPages, ItemsAreOnThePageOfTheirDeviceBelowTheHeadingOfTheirService) {
    const std::string page = make().at("audit-device.html");
    const auto relay = page.find("<h2 id=\"service-relay\">Relay</h2>");
    const auto block = page.find("<h2 id=\"service-sdo_block\">SDO block</h2>");
    ASSERT_NE(relay, std::string::npos);
    ASSERT_NE(block, std::string::npos);
    EXPECT_LT(relay, page.find("id=\"D-A-002\""));
    EXPECT_LT(page.find("id=\"D-A-002\""), block);
    EXPECT_LT(block, page.find("id=\"D-A-001\""));
}

TEST_F(AuditPages, OverviewCountsTheItemsOfEachServiceAndLinksToThem) {
    claim("D-A-002", "S.Three", false);
    const std::string page = make().at("audit.html");
    EXPECT_THAT(page, HasSubstr("<a href=\"audit-device.html#service-sdo_block\">SDO block</a>"
                                "<td class=n data-h=\"Items\">1<td class=n data-h=\"Shown\">1"));
    EXPECT_THAT(page, HasSubstr("<a href=\"audit-device.html#service-relay\">Relay</a>"
                                "<td class=n data-h=\"Items\">1<td class=n data-h=\"Shown\">0<td class=n "
                                "data-h=\"Suspect\">0<td class=n data-h=\"Open\">0<td class=n data-h=\"Failed\">1"));
    EXPECT_THAT(page, HasSubstr("<li>D-A-002: a test that verifies this item has failed"));
}

TEST_F(AuditPages, ItemsCanBeFilteredByKindAndState) {
    const std::string page = make().at("audit-device.html");
    EXPECT_THAT(page,
                HasSubstr("<select data-of=\".kind\"><option value=\"\">all</option><option>requirement</option>"));
    EXPECT_THAT(page, HasSubstr("<option>shown</option><option>suspect</option><option>open</option>"));
}

TEST_F(AuditPages, CodeAndTestsAreLinksToTheirLines) {
    const PackFiles files = make();
    const std::string& page = files.at("audit-device.html");
    EXPECT_THAT(page, HasSubstr("<a href=\"source/src/firmware/base/one.cpp.html#L3\">"
                                "<code>firmware/<wbr>base/<wbr>one.<wbr>cpp:3"));
    EXPECT_THAT(page, HasSubstr("✓</span> S <small>test</small> "
                                "<a href=\"source/tests/one_test.cpp.html#L2\">One</a>"));
    EXPECT_THAT(
        page, HasSubstr("<code>firmware/<wbr>base/<wbr>two.<wbr>cpp:4</code>"));  // the pack does not have this source
    EXPECT_THAT(page, Not(HasSubstr("two.cpp.html")));
}

TEST_F(AuditPages, SharedRequirementThatImplementsAnItemIsShownInsteadOfItsCode) {
    input_.evidence.implemented_by = {{"D-A-002", "D-A-001"}};
    const std::string page = make().at("audit-device.html");
    EXPECT_THAT(page, HasSubstr("<p>implemented by <a href=\"audit-device.html#D-A-001\">D-A-001</a></p>"));
    EXPECT_THAT(page, Not(HasSubstr("two.<wbr>cpp:4")));
}

TEST_F(AuditPages, PageOfAnItemShowsItsReviewOrWhyTheReviewExpired) {
    EXPECT_THAT(make().at("audit-device.html"),
                HasSubstr("reviewed 2026-01-02 by someone, author of the change; read: item"));
    content_.parts[0].requirements[0].text = "edited";
    EXPECT_THAT(make().at("audit-device.html"), HasSubstr("changed since its review of 2026-01-02"));
}

TEST_F(AuditPages, TestsOfOneSuiteWithTheSameResultAreInOneLine) {
    input_.evidence.verdicts["D-A-001"] = {{"S.One", "test", true}, {"T.Two", "test", true}, {"S.Three", "test", true}};
    input_.evidence.verdicts["D-A-001"].push_back({"S.Four", "test", false});
    const std::string page = make().at("audit-device.html");
    EXPECT_THAT(page, HasSubstr("<p><span class=holds>✓</span> S <small>test</small> One, Three</p>"));
    EXPECT_THAT(page, HasSubstr("<p><span class=holds>✓</span> T <small>test</small> Two</p>"));
    EXPECT_THAT(page, HasSubstr("<p><span class=open>✗</span> S <small>test</small> Four</p>"));
}

TEST_F(AuditPages, LineOfASourceLinksBackToItsItems) {
    const PackFiles files = make();
    const std::string& code = files.at("source/src/firmware/base/one.cpp.html");
    EXPECT_THAT(code, HasSubstr("<base href=\"../../../../\">"));
    EXPECT_THAT(code, HasSubstr("<li id=L3><code>static_assert(a &lt; b);</code> "
                                "<a href=\"audit-device.html#D-A-001\">D-A-001</a>"));
    EXPECT_THAT(files.at("source/tests/one_test.cpp.html"),
                HasSubstr("<li id=L2><code>TEST(S, One) {}</code> <a href=\"audit-device.html#D-A-001\">"));
}

TEST_F(AuditPages, OnlySourcesThatTheEvidenceNamesAreRead) {
    const canproof::test::ScratchFolder folder;
    std::filesystem::create_directories(folder / "src/firmware/base");
    std::filesystem::create_directories(folder / "tests");
    folder.fill(folder / "src/firmware/base/one.cpp", "int one;\n");
    folder.fill(folder / "src/firmware/base/other.cpp", "int other;\n");
    folder.fill(folder / "tests/one_test.cpp", "TEST(S, One) {}\n");
    const std::map<std::string, std::string> expected{{"src/firmware/base/one.cpp", "int one;\n"},
                                                      {"tests/one_test.cpp", "TEST(S, One) {}\n"}};
    EXPECT_EQ(sources_named_by(input_.evidence, folder / ""), expected);
}

TEST(ServiceTitle, AbbreviationsAreInCapitals) {
    EXPECT_EQ(service_title("sdo_block"), "SDO block");
    EXPECT_EQ(service_title("receive_pdo"), "Receive PDO");
    EXPECT_EQ(service_title("relay"), "Relay");
}

}  // namespace canproof::host::test
