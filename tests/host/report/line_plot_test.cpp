// SPDX-License-Identifier: Apache-2.0
// Tests line plots that are written as SVG.
#include "host/report/line_plot.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <pugixml.hpp>
#include <set>

#include "host/report/markup.hpp"

namespace canproof::host::test {

namespace {

pugi::xml_document parsed(const std::string& svg) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(svg.c_str()));
    return document;
}

std::vector<std::string> texts(const pugi::xml_document& document) {
    std::vector<std::string> all;
    for (const auto& text : document.child("svg").children("text")) {
        all.emplace_back(text.child_value());
    }
    return all;
}

}  // namespace

TEST(LinePlot, TicksAreRoundNumbers) {
    EXPECT_DOUBLE_EQ(tick_step(0.0, 10.0), 2.0);
    EXPECT_DOUBLE_EQ(tick_step(0.0, 8.0), 1.0);
    EXPECT_DOUBLE_EQ(tick_step(-270.0, 1820.0), 500.0);
    EXPECT_DOUBLE_EQ(tick_step(-2e-7, 3e-7), 1e-7);
}

TEST(LinePlot, PlotContainsItsTitleAxisTextsAndCurves) {
    const LinePlot plot{"a < b & \"c\"",
                        "x / s",
                        "y / V",
                        {{"one", {{0.0, 0.0}, {10.0, 5.0}}}, {"two", {{0.0, 1.0}, {10.0, 1.0}}}},
                        {{4.0, "here"}}};
    const auto document = parsed(write_svg(plot));
    const auto words = texts(document);
    for (const char* word : {"a < b & \"c\"", "x / s", "y / V", "one", "two", "here", "0", "10", "5"}) {
        EXPECT_NE(std::find(words.begin(), words.end(), word), words.end()) << word;
    }
    std::vector<std::string> paths;
    for (const auto& path : document.child("svg").children("path")) {
        paths.emplace_back(path.attribute("d").value());
    }
    // The plot area extends from the point (84, 360) to (940, 44).
    EXPECT_EQ(paths, (std::vector<std::string>{"M84.0 360.0L940.0 44.0", "M84.0 296.8L940.0 296.8"}));
}

TEST(LinePlot, NanValueIsAGap) {
    const double no_number = std::numeric_limits<double>::quiet_NaN();
    const LinePlot plot{"", "", "", {{"one", {{0.0, 0.0}, {2.0, no_number}, {4.0, 4.0}, {8.0, 8.0}}}}, {}};
    const auto document = parsed(write_svg(plot));
    EXPECT_STREQ(document.child("svg").child("path").attribute("d").value(), "M84.0 360.0M512.0 202.0L940.0 44.0");
}

TEST(LinePlot, LegendOfManyCurvesHasRowsAndCurvesDifferWithoutColour) {
    LinePlot plot{"", "", "", {}, {}};
    for (int i = 0; i < 18; ++i) {
        plot.curves.push_back({std::to_string(i), {{0.0, 0.0}, {1.0, 2.5e6}}});
    }
    const auto document = parsed(write_svg(plot));
    std::vector<std::pair<double, double>> places;
    std::set<std::string> looks;
    bool has_grouped_tick = false;
    for (const auto& node : document.child("svg").children()) {
        const std::string word = node.child_value();
        if (node.name() == std::string{"text"} && plot.curves.size() > places.size() &&
            word == plot.curves[places.size()].name && node.attribute("text-anchor").empty()) {
            places.emplace_back(node.attribute("x").as_double(), node.attribute("y").as_double());
        }
        if (node.name() == std::string{"path"}) {
            looks.insert(node.attribute("stroke-width").value() + std::string{" "} +
                         node.attribute("stroke-dasharray").value());
        }
        has_grouped_tick = has_grouped_tick || word == "2,500,000";
    }
    ASSERT_EQ(places.size(), 18U);
    EXPECT_EQ(places[6].first, places[0].first);  // six legend entries in one row
    EXPECT_LT(places[0].second, places[6].second);
    EXPECT_EQ(std::set(places.begin(), places.end()).size(), 18U);
    EXPECT_EQ(looks.size(), 18U);  // all 18 curves differ in width or dashes
    EXPECT_TRUE(has_grouped_tick);
}

TEST(Grouped, ThousandsAreSeparated) {
    EXPECT_EQ(grouped("999"), "999");
    EXPECT_EQ(grouped("-999"), "-999");
    EXPECT_EQ(grouped("1000"), "1,000");
    EXPECT_EQ(grouped("-1234567.25"), "-1,234,567.25");
    EXPECT_EQ(grouped(std::uint64_t{18446744073709551615U}), "18,446,744,073,709,551,615");
}

TEST(Prose, BackticksBecomeCode) {
    EXPECT_EQ(prose("run `a < b` & `c`."), "run <code>a &lt; b</code> &amp; <code>c</code>.");
    EXPECT_EQ(prose("one ` alone"), "one ` alone");
    EXPECT_EQ(prose(""), "");
}

TEST(Breakable, NameIsDividedBetweenItsWords) {
    EXPECT_EQ(breakable("RelayStaysOff"), "Relay<wbr>Stays<wbr>Off");
    EXPECT_EQ(breakable("ax/led_ring.cpp:7"), "ax/<wbr>led_<wbr>ring.<wbr>cpp:7");
    EXPECT_EQ(breakable("a<B"), "a&lt;B");
}

TEST(LinePlot, FlatCurveAndEmptyPlotAreDrawn) {
    // The axes extend half a unit on each side of the only point, so that it lies in the middle of the plot area.
    const auto flat = parsed(write_svg(LinePlot{"flat", "", "", {{"one", {{1.0, 7.0}}}}, {}}));
    EXPECT_STREQ(flat.child("svg").child("path").attribute("d").value(), "M512.0 202.0");
    EXPECT_EQ(texts(flat).front(), "flat");
    EXPECT_EQ(texts(flat).back(), "one");
    // Without a curve, both axes extend from 0 to 1, in steps of 0.2.
    const auto none = parsed(write_svg(LinePlot{"none", "x / s", "y / V", {}, {}}));
    EXPECT_TRUE(none.child("svg").child("path").empty());
    EXPECT_EQ(texts(none), (std::vector<std::string>{"none", "0", "0.2", "0.4", "0.6", "0.8", "1", "0", "0.2", "0.4",
                                                     "0.6", "0.8", "1", "x / s", "y / V"}));
}

TEST(LinePlot, PlotOfExtremeValuesHasNumbersOnly) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    const double huge = std::numeric_limits<double>::max();
    for (const auto& [one, other] : std::vector<std::pair<double, double>>{
             {1e17, 1e17}, {-1e17, -1e17}, {1e17, 1e17 + 16.0}, {0.0, tiny}, {-huge, huge}, {1e300, 1e300}}) {
        const std::string svg = write_svg(LinePlot{"", "", "", {{"", {{0.0, one}, {1.0, other}}}}, {}});
        EXPECT_EQ(svg.find("nan"), std::string::npos) << one;
        EXPECT_EQ(svg.find("inf"), std::string::npos) << one;
        EXPECT_LT(svg.size(), 20000U) << one;
    }
    // A constant value lies in the middle of the plot area, between the y coordinates 44 and 360.
    const LinePlot flat{"", "", "", {{"one", {{0.0, 1e17}, {1.0, 1e17}}}}, {}};
    EXPECT_STREQ(parsed(write_svg(flat)).child("svg").child("path").attribute("d").value(), "M84.0 202.0L940.0 202.0");
}

TEST(LinePlot, DescriptionContainsTitleAxesRangesAndMarkedPoints) {
    const LinePlot plot{"Output after a step",
                        "time in s",
                        "voltage in V",
                        {{"aout1", {{0.0, -2.5}, {10.0, 5.0}}}, {"aout2", {{0.0, 1.0}, {10.0, 1.0}}}, {"aout3", {}}},
                        {{4.0, "here"}}};
    const std::string words =
        "Output after a step. Plot of voltage in V against time in s from 0 to 10: aout1 from -2.5 to 5, aout2 "
        "constant at 1, aout3. Marked: “here” at 4.";
    EXPECT_EQ(plot_words(plot), words);
    const auto document = parsed(write_svg(plot));
    EXPECT_EQ(document.child("svg").attribute("aria-label").value(), words);
    EXPECT_STREQ(document.child("svg").child_value("title"), "Output after a step");
}

}  // namespace canproof::host::test
