// SPDX-License-Identifier: Apache-2.0
#include "host/prove/verdict_xml.hpp"

#include <fmt/format.h>

#include <pugixml.hpp>
#include <sstream>

namespace canproof::host::prove {

std::string verdict_xml(const std::vector<TheoremResult>& results) {
    pugi::xml_document document;
    pugi::xml_node suite = document.append_child("testsuites").append_child("testsuite");
    suite.append_attribute("name") = "proofs";
    for (const TheoremResult& one : results) {
        if (one.requirements.empty() || one.verdict == Verdict::unknown) {
            continue;
        }
        pugi::xml_node test = suite.append_child("testcase");
        test.append_attribute("name") = one.name.c_str();
        test.append_attribute("classname") = one.area.c_str();
        test.append_attribute("file") = one.file.c_str();
        test.append_attribute("status") = "run";
        test.append_attribute("time") = fmt::format("{:.3f}", one.seconds).c_str();
        if (one.verdict == Verdict::refuted) {
            test.append_child("failure").append_attribute("message") = one.reason.c_str();
        }
        pugi::xml_node claims = test.append_child("properties");
        for (const std::string& requirement : one.requirements) {
            pugi::xml_node claim = claims.append_child("property");
            claim.append_attribute("name") = requirement.c_str();
            claim.append_attribute("value") = "proof";
        }
    }
    std::ostringstream text;
    document.save(text, "  ");
    return text.str();
}

}  // namespace canproof::host::prove
