// SPDX-License-Identifier: Apache-2.0
// An evidence pack of a small register, with hand-made evidence.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "host/assess/evidence/pack.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/register/fingerprint.hpp"

namespace canproof::host::test {

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
        decision.severity = "high";
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
        for (const auto& prints : {fingerprints(content_.parts[0]), fingerprints(content_.manuals[0])}) {
            for (const auto& [id, print] : prints) {
                content_.parts[0].reviews[id] = {print, "", "", "2026-01-02", "someone", "author", "", {}};
            }
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
    /// Returns the state after the id of a claim on the overview: `✓ holds` or `✗ open`.
    std::string state_of(const std::string& id) {
        const std::string page = make().at("index.html");
        const auto at = page.find("<b>" + id + "</b>");
        const auto begin = page.find('>', at + id.size() + 8) + 1;
        return page.substr(begin, page.find('<', begin) - begin);
    }

    Register content_;
    PackInput input_;
};

}  // namespace canproof::host::test
