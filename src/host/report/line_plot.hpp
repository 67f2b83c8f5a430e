// A line plot as SVG: axes with round numbers, a legend, marks. Needs nothing but a browser.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace canproof::host {

struct Curve {
    std::string name;
    std::vector<std::pair<double, double>> points;  ///< x ascending
};

/// A vertical line with a word on it.
struct PlotMark {
    double x{0.0};
    std::string word;
};

struct LinePlot {
    std::string title;
    std::string x_label;  ///< with its unit
    std::string y_label;
    std::vector<Curve> curves;
    std::vector<PlotMark> marks;
};

/// Distance of the ticks of an axis from `low` to `high`: 1, 2 or 5 times a power of ten, for four to ten ticks.
double tick_step(double low, double high);

/// The plot as a whole SVG file.
std::string write_svg(const LinePlot& plot);

}  // namespace canproof::host
