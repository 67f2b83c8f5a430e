// SPDX-License-Identifier: Apache-2.0
#include "host/conform/report/report_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/conform/report/measured_times.hpp"
#include "host/conform/run/cases.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host::conform {

namespace {

constexpr std::size_t most_frames = 400;

bool has_page(const CaseResult& one) {
    return one.verdict != Verdict::passed && one.verdict != Verdict::skipped && one.verdict != Verdict::not_run;
}

std::string page_of(const CaseResult& one) {
    return "case-" + one.id + ".html";
}

std::string state(Verdict verdict) {
    const bool open = verdict == Verdict::skipped || verdict == Verdict::not_run;
    return fmt::format("<span class=\"state {}\">{}</span>",
                       verdict == Verdict::passed ? "holds"
                       : open                     ? "partly"
                                                  : "open",
                       words_of(verdict));
}

std::vector<NavigationEntry> navigation(const ConformReport& report) {
    std::vector<NavigationEntry> all{{"index.html", "Summary"}};
    for (const std::string& group : case_groups()) {
        if (std::any_of(report.results.begin(), report.results.end(),
                        [&](const CaseResult& one) { return one.group == group; })) {
            all.push_back({group + ".html", group});
        }
    }
    return all;
}

/// Returns the program, the data sheet and the node-ID as text for the foot of each page and of each printed sheet.
std::string origin(const ConformReport& report) {
    return fmt::format("{}, {}, node-ID {}", report.program, report.sheet, report.node);
}

std::string summary_page(const ConformReport& report) {
    std::vector<std::vector<std::string>> facts{
        {"Data sheet", escaped(report.sheet)},
        {"SHA-256 of the data sheet", "<code>" + escaped(report.checksum) + "</code>"},
        {"Bus", escaped(report.target)},
        {"Node-ID", fmt::format("{}", report.node)},
        {"Bit rate", report.bit_rate == 0 ? "not known" : fmt::format("{} bit/s", report.bit_rate)},
        {"Requested background traffic", fmt::format("{:.0f} %", report.traffic)},
        {"Bus load measured", load_words(report)},
        {"Program", escaped(report.program)}};
    for (const auto& [what, text] : report.identity) {
        facts.push_back({escaped(what), escaped(text)});
    }
    std::vector<std::vector<std::string>> rows;
    for (const NavigationEntry& entry : navigation(report)) {
        if (entry.page == "index.html") {
            continue;
        }
        std::map<Verdict, std::size_t> counts;
        for (const CaseResult& one : report.results) {
            counts[one.verdict] += one.group == entry.title ? 1U : 0U;
        }
        rows.push_back({fmt::format("<a href=\"{}\">{}</a>", entry.page, entry.title),
                        fmt::format("{}", counts[Verdict::passed]),
                        fmt::format("{}", counts[Verdict::failed] + counts[Verdict::no_answer]),
                        fmt::format("{}", counts[Verdict::unstable]), fmt::format("{}", counts[Verdict::skipped]),
                        fmt::format("{}", counts[Verdict::broken] + counts[Verdict::not_run])});
    }
    std::string body = html_table("Verdicts by service",
                                  {{"Service"}, {"Passed"}, {"Failed"}, {"Unstable"}, {"Skipped"}, {"Not run"}}, rows);
    std::vector<std::vector<std::string>> failed;
    for (const CaseResult& one : report.results) {
        if (has_page(one)) {
            failed.push_back({fmt::format("<a href=\"{}\">{}</a>", page_of(one), escaped(one.id)), state(one.verdict),
                              escaped(one.why)});
        }
    }
    body += "<h2>What did not pass</h2>\n";
    body += failed.empty() ? "<p>Nothing.</p>\n"
                           : html_table("Cases that did not pass", {{"Case"}, {"Verdict"}, {"Why"}}, failed);
    for (const std::string& one : report.troubles) {
        body += "<p>Before the first case: " + escaped(one) + "</p>\n";
    }
    for (const std::string& one : report.left) {
        body += "<p>Not put back: " + escaped(one) + "</p>\n";
    }
    body += "<h2>The run</h2>\n" + html_table("Facts of the run", {{"What"}, {"Value"}}, facts);
    const std::string times = times_table(times_of_all(report));
    body += times.empty() ? "" : "<h2>Measured times of all cases</h2>\n" + times;
    return html_page("Conformance test", "index.html", {navigation(report), origin(report)}, body);
}

std::string service_page(const ConformReport& report, const std::string& group) {
    std::vector<std::vector<std::string>> rows;
    std::string times;
    for (const CaseResult& one : report.results) {
        if (one.group == group) {
            const std::string id = escaped(one.id);
            rows.push_back({has_page(one) ? fmt::format("<a href=\"{}\">{}</a>", page_of(one), id) : id,
                            state(one.verdict), escaped(fmt::format("{}", fmt::join(one.numbers, ", "))),
                            escaped(one.shows), escaped(one.section), escaped(one.why)});
            const std::string table = times_table(one.times);
            times += table.empty() ? "" : fmt::format("<h3>{}</h3>\n{}", id, table);
        }
    }
    const std::string body =
        html_table("Cases of the service", {{"Case"}, {"Verdict"}, {"Public"}, {"Shows"}, {"Section"}, {"Why"}}, rows,
                   Search::yes) +
        (times.empty() ? "" : "<h2>Measured times</h2>\n" + times);
    return html_page("Conformance: " + group, group + ".html", {navigation(report), origin(report)}, body);
}

std::string case_page(const ConformReport& report, const CaseResult& one) {
    std::string body =
        fmt::format("<p>{} {}</p>\n<p>{}</p>\n", state(one.verdict), escaped(one.why), escaped(one.shows));
    body += fmt::format("<p>Expected by: {}. Ended at:</p>\n<pre>{}</pre>\n", escaped(one.section), escaped(one.step));
    for (const std::string& note : one.notes) {
        body += "<p>Note: " + escaped(note) + "</p>\n";
    }
    for (const std::string& left : one.left) {
        body += "<p>Not put back: " + escaped(left) + "</p>\n";
    }
    const std::size_t first = one.frames.size() > most_frames ? one.frames.size() - most_frames : 0;
    body += fmt::format("<h2>Frames{}</h2>\n<pre>",
                        first == 0 ? "" : fmt::format(" (the last {} of {})", most_frames, one.frames.size()));
    for (std::size_t i = first; i < one.frames.size(); ++i) {
        const FrameRecord& record = one.frames[i];
        body += escaped(format_candump_line({record.time, "can0", record.frame})) +
                (record.own ? " tester" : " slave") + "\n";
    }
    body += "</pre>\n";
    const std::string times = times_table(one.times);
    body += times.empty() ? "" : "<h2>Measured times</h2>\n" + times;
    return html_page(one.id, page_of(one), {navigation(report), origin(report)}, body);
}

}  // namespace

std::map<std::string, std::string> report_pages(const ConformReport& report) {
    std::map<std::string, std::string> pages;
    pages["index.html"] = summary_page(report);
    for (const NavigationEntry& entry : navigation(report)) {
        if (entry.page != "index.html") {
            pages[entry.page] = service_page(report, entry.title);
        }
    }
    for (const CaseResult& one : report.results) {
        if (has_page(one)) {
            pages[page_of(one)] = case_page(report, one);
        }
    }
    return pages;
}

}  // namespace canproof::host::conform
