#include "host/assess/evidence/junit.hpp"

#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

namespace {

using Cases = std::vector<const TestCase*>;

void add_suite(pugi::xml_node suites, const std::string& name, const Cases& cases) {
    auto suite = suites.append_child("testsuite");
    std::size_t failures = 0;
    suite.append_attribute("name") = name.c_str();
    suite.append_attribute("tests") = cases.size();
    auto failed = suite.append_attribute("failures");
    for (const TestCase* one : cases) {
        auto node = suite.append_child("testcase");
        node.append_attribute("classname") = name.c_str();
        node.append_attribute("name") = one->name.c_str();
        if (!one->passed) {
            ++failures;
            node.append_child("failure").append_attribute("message") = one->failure.c_str();
        }
    }
    failed = failures;
}

}  // namespace

std::string write_junit(const Evidence& evidence) {
    std::map<std::string, Cases> suites;
    for (const auto& one : evidence.cases) {
        suites[one.suite].push_back(&one);
    }
    pugi::xml_document document;
    auto head = document.append_child(pugi::node_declaration);
    head.append_attribute("version") = "1.0";
    head.append_attribute("encoding") = "UTF-8";
    auto all = document.append_child("testsuites");
    all.append_attribute("tests") = evidence.tests;
    all.append_attribute("failures") = evidence.failed;
    for (const auto& [name, cases] : suites) {
        add_suite(all, name, cases);
    }
    std::ostringstream out;
    document.save(out, "  ");
    return out.str();
}

}  // namespace canproof::host
