// SPDX-License-Identifier: Apache-2.0
#include "host/assess/coverage/cobertura.hpp"

#include <fmt/format.h>

#include <pugixml.hpp>
#include <sstream>

#include "host/assess/coverage/coverage.hpp"

namespace canproof::host {

namespace {

std::string rate(const CoverageCount& count) {
    return fmt::format("{:.4f}", count.percent() / 100.0);
}

void add_class(pugi::xml_node classes, const FileCoverage& file) {
    auto one = classes.append_child("class");
    one.append_attribute("name") = file.file.c_str();
    one.append_attribute("filename") = file.file.c_str();
    one.append_attribute("line-rate") = rate(file.line_count()).c_str();
    one.append_attribute("branch-rate") = rate(file.branches).c_str();
    one.append_attribute("complexity") = "0";
    one.append_child("methods");
    auto lines = one.append_child("lines");
    for (const auto& [number, hits] : file.lines) {
        auto line = lines.append_child("line");
        line.append_attribute("number") = number;
        line.append_attribute("hits") = hits;
        const auto branches = file.line_branches.find(number);
        const bool branch = branches != file.line_branches.end();
        line.append_attribute("branch") = branch;
        if (branch) {
            const CoverageCount& count = branches->second;
            line.append_attribute("condition-coverage") =
                fmt::format("{:.0f}% ({}/{})", count.percent(), count.covered, count.total).c_str();
        }
    }
}

}  // namespace

std::string write_cobertura(const std::vector<FileCoverage>& files) {
    const CoverageTotals totals = totals_of(files);
    const CoverageCount& lines = totals.lines;
    const CoverageCount& branches = totals.branches;
    pugi::xml_document document;
    auto head = document.append_child(pugi::node_declaration);
    head.append_attribute("version") = "1.0";
    auto coverage = document.append_child("coverage");
    coverage.append_attribute("line-rate") = rate(lines).c_str();
    coverage.append_attribute("branch-rate") = rate(branches).c_str();
    coverage.append_attribute("lines-covered") = lines.covered;
    coverage.append_attribute("lines-valid") = lines.total;
    coverage.append_attribute("branches-covered") = branches.covered;
    coverage.append_attribute("branches-valid") = branches.total;
    coverage.append_attribute("complexity") = "0";
    coverage.append_attribute("version") = "canproof";
    coverage.append_attribute("timestamp") = "0";  // constant, so that the same commit gives the same bytes
    coverage.append_child("sources").append_child("source").text() = ".";
    auto package = coverage.append_child("packages").append_child("package");
    package.append_attribute("name") = "firmware";
    package.append_attribute("line-rate") = rate(lines).c_str();
    package.append_attribute("branch-rate") = rate(branches).c_str();
    package.append_attribute("complexity") = "0";
    auto classes = package.append_child("classes");
    for (const auto& file : files) {
        if (!file.is_host()) {
            add_class(classes, file);
        }
    }
    std::ostringstream out;
    document.save(out, "  ");
    return out.str();
}

}  // namespace canproof::host
