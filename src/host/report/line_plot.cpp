// SPDX-License-Identifier: Apache-2.0
#include "host/report/line_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/report/markup.hpp"

namespace canproof::host {

namespace {

constexpr double width = 960.0;
constexpr double left = 84.0;
constexpr double right = 940.0;
constexpr double top = 44.0;
constexpr double bottom = 360.0;
constexpr double legend_top = 416.0;
constexpr double legend_row = 20.0;
constexpr std::size_t legend_columns = 6;

// The colours differ in hue and in lightness, so that readers who cannot see colours can distinguish them.
constexpr const char* colours[]{"#1b6ca8", "#d1495b", "#2e8b57", "#8e44ad", "#e08e0b", "#17a2a2", "#5d5d5d", "#a0522d"};

/// After all colours are used once, further curves are dashed, then dotted.
constexpr const char* dashes[]{"", " stroke-dasharray=\"7 3\"", " stroke-dasharray=\"2 2\""};

/// Greatest value of a curve that is drawn. The difference of two such values is finite.
constexpr double greatest = 1e300;
/// Smallest range of an axis: its ticks differ as floating-point numbers.
constexpr double least_range = 1e-300;
/// Smallest range of an axis, as a share of its greatest value.
constexpr double least_share = 1e-12;

bool is_drawn(double value) {
    return std::isfinite(value) && std::fabs(value) <= greatest;
}

struct AxisRange {
    double low{0.0};
    double high{1.0};

    /// Returns the range of all points, extended to whole ticks. The range is never empty.
    static AxisRange of(const std::vector<Curve>& curves, bool of_x) {
        bool any = false;
        AxisRange range;
        for (const Curve& curve : curves) {
            for (const auto& [x, y] : curve.points) {
                const double value = of_x ? x : y;
                if (is_drawn(value)) {
                    range.low = any ? std::min(range.low, value) : value;
                    range.high = any ? std::max(range.high, value) : value;
                    any = true;
                }
            }
        }
        const double share = least_share * std::max(std::fabs(range.low), std::fabs(range.high));
        if (range.high - range.low <= std::max(share, least_range)) {
            const double more = std::max(0.5, share);
            range = {range.low - more, range.high + more};
        }
        const double step = tick_step(range.low, range.high);
        return {std::floor(range.low / step) * step, std::ceil(range.high / step) * step};
    }
};

class Canvas {
  public:
    explicit Canvas(const LinePlot& plot)
        : plot_{plot}, x_{AxisRange::of(plot.curves, true)}, y_{AxisRange::of(plot.curves, false)} {}

    std::string svg() {
        const std::size_t rows = (plot_.curves.size() + legend_columns - 1) / legend_columns;
        const double height = legend_top + legend_row * static_cast<double>(std::max<std::size_t>(rows, 1)) + 4.0;
        text_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
            "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
            width, height);
        put(left, 24.0, plot_.title, "font-size=\"15\" font-weight=\"bold\"");
        axes();
        for (const PlotMark& mark : plot_.marks) {
            text_ += fmt::format(
                "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#999999\" "
                "stroke-dasharray=\"3 3\"/>\n",
                at_x(mark.x), top, bottom);
            text_ += fmt::format(
                "<text transform=\"translate({:.1f} {}) rotate(-90)\" text-anchor=\"end\" font-size=\"10\">{}</text>\n",
                at_x(mark.x) - 3.0, top + 4.0, escaped(mark.word));
        }
        for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
            draw(plot_.curves[i], i);
        }
        return text_ + "</svg>\n";
    }

  private:
    double at_x(double x) const { return left + (x - x_.low) / (x_.high - x_.low) * (right - left); }
    double at_y(double y) const { return bottom - (y - y_.low) / (y_.high - y_.low) * (bottom - top); }

    void put(double x, double y, const std::string& words, const std::string& attributes) {
        text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, attributes, escaped(words));
    }

    void axes() {
        const double x_step = tick_step(x_.low, x_.high);
        for (double x = x_.low; x <= x_.high + x_step / 2.0; x += x_step) {
            text_ += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#e6e6e6\"/>\n",
                                 at_x(x), top, bottom);
            put(at_x(x), bottom + 16.0, number(x, x_step), "text-anchor=\"middle\"");
        }
        const double y_step = tick_step(y_.low, y_.high);
        for (double y = y_.low; y <= y_.high + y_step / 2.0; y += y_step) {
            text_ += fmt::format("<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#e6e6e6\"/>\n",
                                 left, right, at_y(y));
            put(left - 8.0, at_y(y) + 4.0, number(y, y_step), "text-anchor=\"end\"");
        }
        put((left + right) / 2.0, bottom + 36.0, plot_.x_label, "text-anchor=\"middle\"");
        text_ += fmt::format("<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                             (top + bottom) / 2.0, escaped(plot_.y_label));
    }

    /// Returns the number at a tick without the rounding errors in its last digits.
    static std::string number(double value, double step) {
        const double shown = std::fabs(value) < step / 1000.0 ? 0.0 : value;
        return grouped(std::fabs(shown) < 1e5 ? fmt::format("{:.6g}", shown) : fmt::format("{:.0f}", shown));
    }

    /// Draws a curve with a gap where a value is NaN, infinite or above the greatest value that is drawn.
    void draw(const Curve& curve, std::size_t i) {
        const char* colour = colours[i % std::size(colours)];
        std::string path;
        bool drawing = false;
        for (const auto& [x, y] : curve.points) {
            if (!is_drawn(x) || !is_drawn(y)) {
                drawing = false;
                continue;
            }
            path += fmt::format("{}{:.1f} {:.1f}", drawing ? "L" : "M", at_x(x), at_y(y));
            drawing = true;
        }
        const char* dash = dashes[(i / std::size(colours)) % std::size(dashes)];
        text_ +=
            fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\"{}/>\n", path, colour, dash);
        const std::size_t columns = std::min(plot_.curves.size(), legend_columns);
        const double x = left + static_cast<double>(i % columns) * (right - left) / static_cast<double>(columns);
        const double y = legend_top + static_cast<double>(i / columns) * legend_row;
        text_ += fmt::format(
            "<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"3\"{}/>\n", x,
            x + 18.0, y + 2.0, y + 2.0, colour, dash);
        put(x + 24.0, y + 6.0, curve.name, "");
    }

    const LinePlot& plot_;
    AxisRange x_;
    AxisRange y_;
    std::string text_;
};

}  // namespace

double tick_step(double low, double high) {
    const double rough = (high - low) / 8.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (rough <= factor * power) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

std::string plot_words(const LinePlot& plot) {
    std::string curves;
    for (const auto& curve : plot.curves) {
        curves += (curves.empty() ? "" : ", ") + curve.name;
    }
    return fmt::format("{}. Plot of {} against {}: {}.", plot.title, plot.y_label, plot.x_label, curves);
}

std::string write_svg(const LinePlot& plot) {
    return Canvas{plot}.svg();
}

}  // namespace canproof::host
