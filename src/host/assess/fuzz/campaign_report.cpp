// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/campaign_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/report/line_plot.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

double rate(const TargetRecord& target) {
    return target.seconds > 0.0 ? static_cast<double>(target.executions) / target.seconds : 0.0;
}

/// Returns `now` minus `before` as `+12`, `-3` or `+0`. Returns a dash when `before` has no value.
std::string change(std::uint64_t now, const std::optional<std::uint64_t>& before) {
    return before ? fmt::format("{:+}", static_cast<std::int64_t>(now) - static_cast<std::int64_t>(*before)) : "–";
}

std::optional<std::uint64_t> edges_before(const std::optional<Night>& last, const std::string& target) {
    if (!last || last->edges.count(target) == 0) {
        return {};
    }
    return last->edges.at(target);
}

/// Returns whether this campaign and the previous one had the same targets. Only then can the numbers of lines that
/// they reached be compared.
bool same_targets(const CampaignState& state, const Night& last) {
    return last.edges.size() == state.targets.size() &&
           std::all_of(state.targets.begin(), state.targets.end(),
                       [&](const TargetRecord& one) { return last.edges.count(one.name) != 0; });
}

double percent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string figure(const LinePlot& plot) {
    return html_figure(write_svg(plot, DrawnTitle::no), plot.title);
}

std::string head(const CampaignState& state, const std::optional<Night>& last) {
    std::string text = fmt::format(
        "<p>{}</p><p>Started {}, {} on {} job(s), seed {}; {} executions.",
        state.findings.empty() ? "<span class=holds>No finding.</span>"
                               : fmt::format("<span class=open>{} finding(s).</span>", state.findings.size()),
        state.started, minutes_text(state.minutes), state.jobs, state.seed, grouped(state.executions()));
    text += last ? fmt::format(" The campaign before: {}, {}, {} executions, {} finding(s).", last->started,
                               minutes_text(last->minutes), grouped(last->executions), last->findings)
                 : " There is no earlier campaign to compare with.";
    text += "</p>";
    if (state.phase != "done") {
        text += fmt::format(
            "<p class=open>Not finished: the campaign was stopped during “{}”. The same command without --restart "
            "continues it.</p>",
            state.phase);
    }
    for (const auto& remark : state.remarks) {
        text += fmt::format("<p>{}</p>", escaped(remark));
    }
    return text;
}

std::string findings(const CampaignState& state) {
    if (state.findings.empty()) {
        return "";
    }
    std::vector<std::vector<std::string>> rows;
    for (const auto& one : state.findings) {
        rows.push_back({one.target, escaped(one.title) + (one.reproduces ? "" : " (does not reproduce)"),
                        std::to_string(one.bytes), std::to_string(one.times), escaped(one.pass), one.first_seen,
                        fmt::format("<code>{}</code>", escaped(one.folder)),
                        fmt::format("<code>{}</code>", escaped(one.regression))});
    }
    return "<h2>Findings</h2>" + html_table("Findings of all campaigns",
                                            {{"Target"},
                                             {"What", 30},
                                             {"Bytes"},
                                             {"Times"},
                                             {"Shown by"},
                                             {"First seen"},
                                             {"Kept in"},
                                             {"Regression test"}},
                                            rows);
}

std::string targets(const CampaignState& state, const std::optional<Night>& last) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& one : state.targets) {
        rows.push_back({one.name, fmt::format("{:.0f}", one.seconds), std::to_string(one.executions),
                        fmt::format("{:.0f}", rate(one)), std::to_string(one.edges()),
                        change(one.edges(), edges_before(last, one.name)), fmt::format("{:.0f}", one.last_gain()),
                        std::to_string(one.inputs_before), std::to_string(one.inputs_found),
                        std::to_string(one.inputs_kept), std::to_string(one.inputs_second_pass),
                        one.plateaued() ? "plateaued" : ""});
    }
    std::string text = "<h2>Targets</h2>" + html_table("Targets of this campaign",
                                                       {{"Target", 16},
                                                        {"Seconds"},
                                                        {"Executions"},
                                                        {"Executions per second"},
                                                        {"Edges"},
                                                        {"Change since the last campaign"},
                                                        {"Last new edge, s"},
                                                        {"Inputs before"},
                                                        {"Found"},
                                                        {"Kept"},
                                                        {"Run under valgrind"},
                                                        {"State", 10}},
                                                       rows);
    text += "<p>A target has plateaued when the second half of its time brought no new edge.</p>";
    LinePlot edges{"Edges over each target's own time", "time (s)", "edges", {}, {}};
    LinePlot executions{"Executions over each target's own time", "time (s)", "executions", {}, {}};
    for (const auto& one : state.targets) {
        Curve edge{one.name, {}};
        Curve execution{one.name, {}};
        for (const auto& sample : one.samples) {
            edge.points.emplace_back(sample.seconds, static_cast<double>(sample.edges));
            execution.points.emplace_back(sample.seconds, static_cast<double>(sample.executions));
        }
        if (!one.samples.empty()) {
            edges.curves.push_back(edge);
            executions.curves.push_back(execution);
        }
    }
    return edges.curves.empty() ? text : text + figure(edges) + figure(executions);
}

std::string coverage(const CampaignState& state, const std::optional<Night>& last) {
    const LineCoverage& all = state.coverage;
    if (!all.measured) {
        return "<h2>Lines</h2><p>This campaign did not measure the lines that it reached.</p>";
    }
    const auto before =
        last && last->lines_hit > 0 && same_targets(state, *last) ? std::optional{last->lines_hit} : std::nullopt;
    std::string text = fmt::format(
        "<h2>Lines of the firmware</h2><p>{} of {} ({:.1f} %), {} since the last campaign.</p>", grouped(all.hit()),
        grouped(all.lines()), percent(all.hit(), all.lines()), change(all.hit(), before));
    LinePlot plot{"Lines reached over the campaign", "share of its time (%)", "lines", {{"all targets", {}}}, {}};
    for (const auto& point : all.over_time) {
        plot.curves[0].points.emplace_back(100.0 * point.share, static_cast<double>(point.hit));
    }
    text += figure(plot);
    std::vector<std::vector<std::string>> rows;
    for (const auto& file : all.files) {
        if (file.hit == file.lines && file.functions.empty()) {
            continue;
        }
        std::string names;
        for (const auto& function : file.functions) {
            names += fmt::format("<code>{}</code><br>", escaped(function));
        }
        rows.push_back({fmt::format("<code>{}</code>", escaped(file.path)),
                        fmt::format("{:.1f} %", percent(file.hit, file.lines)), file.unreached, names});
    }
    return text + "<h2>Code that no target reaches</h2>" +
           html_table("Files with code that no target reaches",
                      {{"File", 26}, {"Reached", 8}, {"Lines not reached", 22}, {"Functions not called"}}, rows);
}

}  // namespace

std::string write_campaign_html(const CampaignState& state, const std::optional<Night>& last) {
    return html_page("Fuzzing campaign", "", {},
                     head(state, last) + findings(state) + targets(state, last) + coverage(state, last));
}

nlohmann::json write_campaign_json(const CampaignState& state, const std::optional<Night>& last) {
    nlohmann::json report = state;
    report["finished"] = state.phase == "done";
    report["executions"] = state.executions();
    report["lines"] = state.coverage.lines();
    report["lines_hit"] = state.coverage.hit();
    report["plateaued"] = nlohmann::json::array();
    for (const auto& target : state.targets) {
        if (target.plateaued()) {
            report["plateaued"].push_back(target.name);
        }
    }
    report["last_night"] = last ? nlohmann::json(*last) : nlohmann::json{};
    return report;
}

nlohmann::json write_campaign_exhibit(const CampaignState& state) {
    const bool finished = state.phase == "done";
    nlohmann::json open = nlohmann::json::array();
    for (const auto& one : state.findings) {
        open.push_back(fmt::format("{}: {}", one.target, one.title));
    }
    for (const auto& target : state.targets) {
        if (target.broken_slices != 0) {
            open.push_back(
                fmt::format("{}: {} slice(s) of the fuzzing time ended too early", target.name, target.broken_slices));
        }
    }
    if (!finished) {
        open.push_back(fmt::format("not finished: the campaign was stopped during “{}”", state.phase));
    }
    std::size_t looked_at_again = 0;
    for (const auto& target : state.targets) {
        looked_at_again += target.inputs_second_pass;
    }
    std::string says =
        fmt::format("{} targets, {} on {} job(s), {} executions, {} finding(s)", state.targets.size(),
                    minutes_text(state.minutes), state.jobs, grouped(state.executions()), state.findings.size());
    if (state.coverage.measured) {
        says += fmt::format("; {:.1f} % of the firmware's lines reached by fuzzing alone",
                            percent(state.coverage.hit(), state.coverage.lines()));
    }
    if (looked_at_again != 0) {
        says += fmt::format("; {} inputs also run under valgrind", grouped(looked_at_again));
    }
    return {{"title", "Fuzzing campaign"},
            {"state", open.empty() ? "holds" : "open"},
            {"says", says},
            {"page", "index.html"},
            {"open", open},
            {"data", nlohmann::json::array({"report.json"})}};
}

Night night_of(const CampaignState& state) {
    Night night{state.started, state.minutes, state.executions(), state.coverage.hit(), {}, {}, state.findings.size()};
    for (const auto& target : state.targets) {
        night.edges[target.name] = target.edges();
        night.per_second[target.name] = rate(target);
    }
    return night;
}

}  // namespace canproof::host
