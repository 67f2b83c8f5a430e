// SPDX-License-Identifier: Apache-2.0
#include "host/conform/report/report_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/conform/report/measured_times.hpp"
#include "host/conform/report/report_pages.hpp"
#include "host/conform/report/report_records.hpp"

namespace canproof::host::conform {

std::string result_line(const CaseResult& one) {
    std::string text = fmt::format("{:<10} {:<10} {}", words_of(one.verdict), one.group, one.id);
    if (!one.why.empty()) {
        text += ": " + one.why;
    }
    if (!one.step.empty()) {
        text += fmt::format("\n           at {}", one.step);
    }
    return text;
}

std::string summary_lines(const ConformReport& report) {
    std::string text =
        fmt::format("\n{} cases on node {} ({}, {}):", report.results.size(), report.node, report.sheet, report.target);
    for (const Verdict verdict : {Verdict::passed, Verdict::failed, Verdict::unstable, Verdict::no_answer,
                                  Verdict::broken, Verdict::skipped, Verdict::not_run}) {
        const std::size_t count = report.count(verdict);
        if (count != 0 || verdict == Verdict::passed || verdict == Verdict::failed) {
            text += fmt::format(" {} {},", count, words_of(verdict));
        }
    }
    text.back() = '\n';
    text += report.interrupted ? "interrupted; the written parameters are put back\n" : "";
    text += fmt::format("bus load: {}\n", load_words(report));
    for (const auto& [what, measured] : times_of_all(report)) {
        const Spread spread = spread_of(measured.times);
        text += fmt::format("{}: {} times, {:.3f} ms at least, {:.3f} ms in the median, {:.3f} ms at most\n", what,
                            spread.count, static_cast<double>(spread.smallest) / 1000.0,
                            static_cast<double>(spread.median) / 1000.0, static_cast<double>(spread.largest) / 1000.0);
    }
    for (const std::string& one : report.troubles) {
        text += "before the first case: " + one + "\n";
    }
    for (const std::string& one : report.left) {
        text += "not put back: " + one + "\n";
    }
    return text;
}

std::map<std::string, std::string> report_files(const ConformReport& report) {
    std::map<std::string, std::string> files = report_pages(report);
    std::string text;
    for (const CaseResult& one : report.results) {
        text += result_line(one) + "\n";
    }
    files["report.txt"] = text + summary_lines(report);
    files["report.json"] = write_json(report);
    files["junit.xml"] = write_junit_xml(report);
    return files;
}

}  // namespace canproof::host::conform
