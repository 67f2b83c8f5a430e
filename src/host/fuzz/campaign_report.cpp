#include "host/fuzz/campaign_report.hpp"

#include <fmt/format.h>

#include "host/fuzz/campaign_display.hpp"
#include "host/plot/line_plot.hpp"
#include "host/plot/markup.hpp"

namespace canproof::host {

namespace {

const char* const style =
    "body{font:15px/1.5 sans-serif;max-width:75em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:1em 0}th,td{padding:.2em .8em;text-align:right;border-bottom:1px solid #ddd}"
    "th:first-child,td:first-child{text-align:left}td.text{text-align:left}code{font-size:13px}"
    ".bad{color:#a00;font-weight:bold}.good{color:#060}svg{max-width:100%;height:auto}";

double rate(const TargetRecord& target) {
    return target.seconds > 0.0 ? static_cast<double>(target.executions) / target.seconds : 0.0;
}

/// `+12`, `-3`, `0`, or a dash when there is nothing to compare with.
std::string change(std::uint64_t now, const std::optional<std::uint64_t>& before) {
    return before ? fmt::format("{:+}", static_cast<std::int64_t>(now) - static_cast<std::int64_t>(*before)) : "–";
}

std::optional<std::uint64_t> edges_before(const std::optional<Night>& last, const std::string& target) {
    if (!last || last->edges.count(target) == 0) {
        return {};
    }
    return last->edges.at(target);
}

double percent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string head(const CampaignState& state, const std::optional<Night>& last) {
    const std::string verdict = state.findings.empty()
                                    ? "<p class=\"good\">No finding.</p>"
                                    : fmt::format("<p class=\"bad\">{} finding(s).</p>", state.findings.size());
    std::string text = fmt::format(
        "<!DOCTYPE html><html lang=\"en\"><meta charset=\"utf-8\"><title>Fuzzing campaign</title><style>{}</style>"
        "<h1>Fuzzing campaign of {}</h1>{}<p>{} minutes on {} job(s), seed {}; {} executions.",
        style, state.started, verdict, state.minutes, state.jobs, state.seed, with_commas(state.executions()));
    text += last ? fmt::format(" The night before: {}, {} minutes, {} executions, {} finding(s).", last->started,
                               last->minutes, with_commas(last->executions), last->findings)
                 : " There is no earlier night to compare with.";
    text += "</p>";
    if (state.phase != "done") {
        text += fmt::format("<p class=\"bad\">Not finished: stopped during “{}”. The same command goes on.</p>",
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
    std::string text =
        "<h2>Findings</h2><table><tr><th>target</th><th>what</th><th>bytes</th><th>times</th>"
        "<th>shown by</th><th>first seen</th><th>kept in</th><th>regression test</th></tr>";
    for (const auto& one : state.findings) {
        text += fmt::format(
            "<tr><td>{}</td><td class=\"text\">{}{}</td><td>{}</td><td>{}</td><td class=\"text\">{}</td>"
            "<td>{}</td><td class=\"text\"><code>{}</code></td><td class=\"text\"><code>{}</code></td></tr>",
            one.target, escaped(one.title), one.reproduces ? "" : " (does not reproduce)", one.bytes, one.times,
            one.pass, one.first_seen, escaped(one.folder), escaped(one.regression));
    }
    return text + "</table>";
}

std::string targets(const CampaignState& state, const std::optional<Night>& last) {
    std::string text =
        "<h2>Targets</h2><table><tr><th>target</th><th>seconds</th><th>executions</th><th>exec/s</th><th>edges</th>"
        "<th>against the last night</th><th>last new edge at</th><th>inputs before</th><th>found</th><th>kept</th>"
        "<th>looked at by valgrind</th><th></th></tr>";
    for (const auto& one : state.targets) {
        text += fmt::format(
            "<tr><td>{}</td><td>{:.0f}</td><td>{}</td><td>{:.0f}</td><td>{}</td><td>{}</td>"
            "<td>{:.0f} s</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            one.name, one.seconds, with_commas(one.executions), rate(one), with_commas(one.edges()),
            change(one.edges(), edges_before(last, one.name)), one.last_gain(), one.inputs_before, one.inputs_found,
            one.inputs_kept, one.inputs_second_pass, one.plateaued() ? "plateaued" : "");
    }
    text += "</table><p>A target has plateaued when the second half of its time brought no new edge.</p>";
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
    return edges.curves.empty() ? text : text + write_svg(edges) + write_svg(executions);
}

std::string coverage(const CampaignState& state, const std::optional<Night>& last) {
    const LineCoverage& all = state.coverage;
    if (!all.measured) {
        return "<h2>Lines</h2><p>Not measured in this campaign.</p>";
    }
    const auto before = last && last->lines_hit > 0 ? std::optional{last->lines_hit} : std::nullopt;
    std::string text = fmt::format(
        "<h2>Lines of src/firmware</h2><p>{} of {} ({:.1f} %), {} against the last night.</p>", with_commas(all.hit()),
        with_commas(all.lines()), percent(all.hit(), all.lines()), change(all.hit(), before));
    LinePlot plot{"Lines reached over the campaign", "share of its time (%)", "lines", {{"all targets", {}}}, {}};
    for (const auto& point : all.over_time) {
        plot.curves[0].points.emplace_back(100.0 * point.share, static_cast<double>(point.hit));
    }
    text += write_svg(plot);
    text +=
        "<h2>What no target reaches</h2><table><tr><th>file</th><th>reached</th><th>lines not reached</th>"
        "<th>functions not called</th></tr>";
    for (const auto& file : all.files) {
        if (file.hit == file.lines && file.functions.empty()) {
            continue;
        }
        std::string names;
        for (const auto& function : file.functions) {
            names += fmt::format("<code>{}</code><br>", escaped(function));
        }
        text += fmt::format(
            "<tr><td><code>{}</code></td><td>{:.1f} %</td><td class=\"text\">{}</td>"
            "<td class=\"text\">{}</td></tr>",
            escaped(file.path), percent(file.hit, file.lines), file.unreached, names);
    }
    return text + "</table>";
}

}  // namespace

std::string write_campaign_html(const CampaignState& state, const std::optional<Night>& last) {
    return head(state, last) + findings(state) + targets(state, last) + coverage(state, last) + "</html>\n";
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
            open.push_back(fmt::format("{}: {} slice(s) ended before their time", target.name, target.broken_slices));
        }
    }
    if (!finished) {
        open.push_back(fmt::format("not finished: stopped during “{}”", state.phase));
    }
    std::size_t looked_at_again = 0;
    for (const auto& target : state.targets) {
        looked_at_again += target.inputs_second_pass;
    }
    std::string says =
        fmt::format("{} targets, {} minutes on {} job(s), {} executions, {} finding(s)", state.targets.size(),
                    state.minutes, state.jobs, with_commas(state.executions()), state.findings.size());
    if (state.coverage.measured) {
        says += fmt::format("; {:.1f} % of the firmware's lines reached by fuzzing alone",
                            percent(state.coverage.hit(), state.coverage.lines()));
    }
    if (looked_at_again != 0) {
        says += fmt::format("; {} inputs once more under valgrind", with_commas(looked_at_again));
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
