// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/junit.hpp"

#include <fmt/format.h>

#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

namespace {

using Cases = std::vector<const TestCase*>;

std::string seconds_text(const double seconds) {
    return fmt::format("{:.3f}", seconds);
}

/// Adds the items of the register that the test case verifies.
void add_items(pugi::xml_node node, const TestCase& one) {
    if (one.items.empty()) {
        return;
    }
    auto properties = node.append_child("properties");
    for (const auto& id : one.items) {
        auto property = properties.append_child("property");
        property.append_attribute("name") = "requirement";
        property.append_attribute("value") = id.c_str();
    }
}

void add_suite(pugi::xml_node suites, const std::string& name, const Cases& cases) {
    auto suite = suites.append_child("testsuite");
    std::size_t failures = 0;
    suite.append_attribute("name") = name.c_str();
    suite.append_attribute("tests") = cases.size();
    auto failed = suite.append_attribute("failures");
    // Jenkins requires the attribute `errors`. It is always 0, because an interrupted test case counts as failed.
    suite.append_attribute("errors") = 0;
    auto time = suite.append_attribute("time");
    double seconds = 0.0;
    for (const TestCase* one : cases) {
        auto node = suite.append_child("testcase");
        node.append_attribute("classname") = name.c_str();
        node.append_attribute("name") = one->name.c_str();
        node.append_attribute("time") = seconds_text(one->seconds).c_str();
        seconds += one->seconds;
        if (!one->file.empty()) {
            node.append_attribute("file") = one->file.c_str();
        }
        add_items(node, *one);
        if (!one->passed) {
            ++failures;
            node.append_child("failure").append_attribute("message") = one->failure.c_str();
        }
    }
    failed = failures;
    time = seconds_text(seconds).c_str();
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
