// SPDX-License-Identifier: Apache-2.0
// A line plot as SVG, with round numbers on the axes, a legend and labelled vertical lines. Every browser can display
// it.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace canproof::host {

struct Curve {
    std::string name;
    std::vector<std::pair<double, double>> points;  ///< points in ascending order of x
};

/// A vertical line with a label.
struct PlotMark {
    double x{0.0};
    std::string word;
};

struct LinePlot {
    std::string title;
    std::string x_label;  ///< label of the x axis with its unit
    std::string y_label;
    std::vector<Curve> curves;
    std::vector<PlotMark> marks;
};

/// Returns the distance between the ticks of an axis from `low` to `high`, which must be greater than `low`. It is 1, 2
/// or 5 times a power of ten. The axis is 3.2 to 8 times as long as this distance.
double tick_step(double low, double high);

/// Returns title, axes, labels of vertical lines and the range of each curve in sentences, for readers who do not see
/// the plot.
std::string plot_words(const LinePlot& plot);

/// Whether a plot shows its title. A plot below a caption with the title does not show it.
enum class DrawnTitle { no, yes };

/// Returns the plot as a complete SVG file, with plot_words() as its label. Each curve has a dash pattern or a width of
/// its own.
std::string write_svg(const LinePlot& plot, DrawnTitle title = DrawnTitle::yes);

}  // namespace canproof::host
