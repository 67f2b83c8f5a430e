// SPDX-License-Identifier: Apache-2.0
#include "host/conform/report/report_records.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "host/conform/run/cases.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host::conform {

namespace {

/// Returns the limits as JSON. Leaves out an infinite limit, because JSON has no infinite numbers.
nlohmann::ordered_json limits_of(const TimeLimits& limits) {
    nlohmann::ordered_json json{{"least_us", limits.least}};
    if (std::isfinite(limits.most)) {
        json["most_us"] = limits.most;
    }
    return json;
}

nlohmann::ordered_json times_of(const Measured& measured) {
    const Spread spread = spread_of(measured.times);
    nlohmann::ordered_json json{{"count", spread.count},          {"min_us", spread.smallest},
                                {"median_us", spread.median},     {"mean_us", spread.mean},
                                {"p99_us", spread.percentile_99}, {"max_us", spread.largest}};
    if (measured.of_mean) {
        json["accepted_mean"] = limits_of(*measured.of_mean);
    }
    if (measured.of_each) {
        json["accepted_each"] = limits_of(*measured.of_each);
    }
    if (!measured.times.empty()) {
        const Histogram histogram = histogram_of(measured);
        json["histogram"] = {{"from_us", histogram.low}, {"bin_us", histogram.width}, {"counts", histogram.counts}};
    }
    return json;
}

nlohmann::ordered_json case_of(const CaseResult& one) {
    nlohmann::ordered_json json;
    json["id"] = one.id;
    json["service"] = one.group;
    json["public"] = one.numbers;
    json["shows"] = one.shows;
    json["section"] = one.section;
    json["tests"] = one.tests;
    json["verdict"] = words_of(one.verdict);
    json["why"] = one.why;
    json["step"] = one.step;
    json["runs"] = one.runs;
    json["us"] = one.time.us;
    json["notes"] = one.notes;
    json["not_put_back"] = one.left;
    for (const auto& [what, measured] : one.times) {
        json["times"][what] = times_of(measured);
    }
    return json;
}

}  // namespace

std::string write_json(const ConformReport& report) {
    nlohmann::ordered_json json;
    json["program"] = report.program;
    json["sheet"] = report.sheet;
    json["sheet_sha256"] = report.checksum;
    json["target"] = report.target;
    json["node"] = report.node;
    json["bit_rate"] = report.bit_rate;
    json["traffic_percent"] = report.traffic;
    json["bus"] = {{"frames", report.bus_use.frames()},
                   {"tester_frames", report.bus_use.own_frames()},
                   {"error_frames", report.error_frames},
                   {"lost_frames", report.lost_frames},
                   {"bits", report.bus_use.bits()}};
    if (const auto load = report.mean_load()) {
        json["bus"]["mean_load_percent"] = *load;
    }
    if (const auto load = report.highest_load()) {
        json["bus"]["busiest_second_percent"] = *load;
    }
    json["identity"] = report.identity;
    json["us"] = report.time.us;
    json["interrupted"] = report.interrupted;
    json["troubles"] = report.troubles;
    json["not_put_back"] = report.left;
    json["exit_status"] = report.exit_status();
    for (const Verdict verdict : {Verdict::passed, Verdict::failed, Verdict::unstable, Verdict::skipped,
                                  Verdict::no_answer, Verdict::broken, Verdict::not_run}) {
        json["counts"][words_of(verdict)] = report.count(verdict);
    }
    json["cases"] = nlohmann::ordered_json::array();
    for (const CaseResult& one : report.results) {
        json["cases"].push_back(case_of(one));
    }
    return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

namespace {

void add_case(pugi::xml_node suite, const CaseResult& one) {
    auto node = suite.append_child("testcase");
    node.append_attribute("classname") = one.group.c_str();
    node.append_attribute("name") = one.id.c_str();
    if (one.verdict == Verdict::skipped || one.verdict == Verdict::not_run) {
        node.append_child("skipped").append_attribute("message") = one.why.c_str();
    } else if (one.verdict != Verdict::passed) {
        auto failure = node.append_child(one.verdict == Verdict::broken ? "error" : "failure");
        failure.append_attribute("type") = words_of(one.verdict);
        failure.append_attribute("message") = one.why.c_str();
        failure.append_child(pugi::node_pcdata).set_value(one.step.c_str());
    }
}

void add_suite(pugi::xml_node suites, const std::string& group, const std::vector<const CaseResult*>& cases) {
    const auto count = [&](std::initializer_list<Verdict> verdicts) {
        return std::count_if(cases.begin(), cases.end(), [&](const CaseResult* one) {
            return std::find(verdicts.begin(), verdicts.end(), one->verdict) != verdicts.end();
        });
    };
    auto suite = suites.append_child("testsuite");
    suite.append_attribute("name") = group.c_str();
    suite.append_attribute("tests") = cases.size();
    suite.append_attribute("failures") = count({Verdict::failed, Verdict::unstable, Verdict::no_answer});
    suite.append_attribute("errors") = count({Verdict::broken});
    suite.append_attribute("skipped") = count({Verdict::skipped, Verdict::not_run});
    for (const CaseResult* const one : cases) {
        add_case(suite, *one);
    }
}

}  // namespace

std::string write_junit_xml(const ConformReport& report) {
    pugi::xml_document document;
    auto head = document.append_child(pugi::node_declaration);
    head.append_attribute("version") = "1.0";
    head.append_attribute("encoding") = "UTF-8";
    auto suites = document.append_child("testsuites");
    for (const std::string& group : case_groups()) {
        std::vector<const CaseResult*> cases;
        for (const CaseResult& one : report.results) {
            if (one.group == group) {
                cases.push_back(&one);
            }
        }
        if (!cases.empty()) {
            add_suite(suites, group, cases);
        }
    }
    std::ostringstream out;
    document.save(out, "  ");
    return out.str();
}

}  // namespace canproof::host::conform
