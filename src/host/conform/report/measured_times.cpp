// SPDX-License-Identifier: Apache-2.0
#include "host/conform/report/measured_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host::conform {

namespace {

constexpr double bar_width = 6.0;
constexpr double height = 48.0;
constexpr double lowest_bar = 2.0;  // least height of a bar, so that one time among thousands stays visible
constexpr double width = bar_width * static_cast<double>(Histogram::bins);

std::string ms(double us) {
    return fmt::format("{:.3f}", us / 1000.0);
}

std::string ms(std::uint64_t us) {
    return ms(static_cast<double>(us));
}

/// Returns the limits in ms: `mean 95.000 to 105.000, each at most 1000.000`. Returns `no limit` when there are no
/// limits.
std::string accepted_words(const Measured& measured) {
    std::string words;
    const auto add = [&words](const char* what, const std::optional<TimeLimits>& limits) {
        if (!limits) {
            return;
        }
        words += fmt::format("{}{} ", words.empty() ? "" : ", ", what);
        words += std::isinf(limits->most) ? "at least " + ms(limits->least)
                 : limits->least > 0.0    ? ms(limits->least) + " to " + ms(limits->most)
                                          : "at most " + ms(limits->most);
    };
    add("mean", measured.of_mean);
    add("each", measured.of_each);
    return words.empty() ? "no limit" : words;
}

std::string draw_limits(const Measured& measured, const Histogram& histogram) {
    std::string lines;
    for (const auto& limits : {measured.of_mean, measured.of_each}) {
        for (const double limit : limits ? std::vector<double>{limits->least, limits->most} : std::vector<double>{}) {
            const double x = (limit - histogram.low) / histogram.width * bar_width;
            if (limit > 0.0 && x >= 0.0 && x <= width + 0.01) {
                lines += fmt::format(
                    "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"0\" y2=\"{1}\" style=\"stroke:var(--bad)\" "
                    "stroke-width=\"1.5\" stroke-dasharray=\"3 2\"/>",
                    x, height);
            }
        }
    }
    return lines;
}

}  // namespace

std::string load_words(const ConformReport& report) {
    const auto mean = report.mean_load();
    const auto highest = report.highest_load();
    const std::string load =
        mean && highest ? fmt::format("{:.1f} % on average, {:.1f} % in the busiest second", *mean, *highest)
                        : fmt::format("the bit rate is not known; {} bits of frames", grouped(report.bus_use.bits()));
    return fmt::format("{}; {} frames ({} from the tester), {} error frames, {} lost frames", load,
                       grouped(report.bus_use.frames()), grouped(report.bus_use.own_frames()),
                       grouped(report.error_frames), grouped(report.lost_frames));
}

std::map<std::string, Measured> times_of_all(const ConformReport& report) {
    std::map<std::string, Measured> all;
    for (const CaseResult& one : report.results) {
        for (const char* const what : {"SDO answer", "boot-up"}) {
            if (const auto found = one.times.find(what); found != one.times.end()) {
                all[what].add_all(found->second);
            }
        }
    }
    return all;
}

std::string draw_times(const Measured& measured) {
    if (measured.times.empty()) {
        return "";
    }
    const Histogram histogram = histogram_of(measured);
    const auto most = static_cast<double>(*std::max_element(histogram.counts.begin(), histogram.counts.end()));
    std::string bars;
    for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
        if (histogram.counts[bin] != 0) {
            const double tall = std::max(lowest_bar, static_cast<double>(histogram.counts[bin]) / most * height);
            bars += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                                static_cast<double>(bin) * bar_width, height - tall, bar_width - 1.0, tall);
        }
    }
    const double high = histogram.low + histogram.width * static_cast<double>(Histogram::bins);
    return fmt::format(
        "<svg role=\"img\" aria-label=\"{0} times between {1} ms and {2} ms\" viewBox=\"-2 0 {3} {4}\" width=\"{3}\" "
        "height=\"{4}\"><g style=\"fill:var(--link)\">{5}</g>{6}<line x1=\"0\" x2=\"{7}\" y1=\"{8}\" y2=\"{8}\" "
        "stroke=\"currentColor\"/><text x=\"0\" y=\"{9}\" font-size=\"10\" fill=\"currentColor\">{1}</text><text "
        "x=\"{7}\" y=\"{9}\" font-size=\"10\" fill=\"currentColor\" text-anchor=\"end\">{2} ms</text></svg>",
        measured.times.size(), ms(histogram.low), ms(high), width + 4.0, height + 14.0, bars,
        draw_limits(measured, histogram), width, height, height + 11.0);
}

std::string times_table(const std::map<std::string, Measured>& times) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [what, measured] : times) {
        const Spread spread = spread_of(measured.times);
        rows.push_back({escaped(what), fmt::format("{}", spread.count), ms(spread.smallest), ms(spread.median),
                        ms(spread.mean), ms(spread.percentile_99), ms(spread.largest), accepted_words(measured),
                        draw_times(measured)});
    }
    return rows.empty() ? ""
                        : html_table("Measured times in ms",
                                     {{"Measured"},
                                      {"Count"},
                                      {"Min"},
                                      {"Median"},
                                      {"Mean"},
                                      {"99 %"},
                                      {"Max"},
                                      {"Accepted"},
                                      {"Distribution"}},
                                     rows);
}

}  // namespace canproof::host::conform
