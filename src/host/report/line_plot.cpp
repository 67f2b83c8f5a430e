// SPDX-License-Identifier: Apache-2.0
#include "host/report/line_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/report/markup.hpp"

namespace canproof::host {

namespace {

constexpr double width = 960.0;
constexpr double left = 84.0;
constexpr double right = 940.0;
constexpr double top = 44.0;
constexpr double title_height = 32.0;  // part above `top` that only the title uses
constexpr double bottom = 360.0;
constexpr double legend_top = 416.0;
constexpr double legend_row = 20.0;
constexpr std::size_t legend_columns = 6;
// length of the line sample in the legend, long enough to show each dash pattern
constexpr double legend_sample = 34.0;

constexpr const char* colours[]{"#1b6ca8", "#d1495b", "#2e8b57", "#8e44ad", "#b06c00", "#127c7c", "#5d5d5d", "#a0522d"};

/// Each of the first eight curves has a dash pattern of its own, so that readers who cannot see colours can distinguish
/// them. Each further eight curves have the same patterns in wider lines.
constexpr const char* dashes[]{"none", "8 3", "2 3", "10 3 2 3", "5 5", "14 3", "8 3 2 3 2 3", "1 6"};
constexpr double thinnest = 1.6;
constexpr double wider = 1.6;  ///< width added to a curve each time all dash patterns have been used

/// Greatest magnitude of a value that is drawn, so that the difference of two drawn values is finite.
constexpr double greatest = 1e300;
/// Smallest range of an axis, so that its ticks differ as floating-point numbers.
constexpr double least_range = 1e-300;
/// Smallest range of an axis, as a share of its greatest value.
constexpr double least_share = 1e-12;

bool is_drawn(double value) {
    return std::isfinite(value) && std::fabs(value) <= greatest;
}

struct DrawnRange {
    double low;
    double high;
};

/// Returns the least and the greatest value that is drawn; nothing when there is none.
std::optional<DrawnRange> range_of(const std::vector<Curve>& curves, bool of_x) {
    std::optional<DrawnRange> range;
    for (const Curve& curve : curves) {
        for (const auto& [x, y] : curve.points) {
            const double value = of_x ? x : y;
            if (is_drawn(value)) {
                range = {range ? std::min(range->low, value) : value, range ? std::max(range->high, value) : value};
            }
        }
    }
    return range;
}

/// Returns the range in words, with a space before them: ` from 0 to 10`, or ` constant at 5`.
std::string words_of(const DrawnRange& range) {
    return range.low < range.high ? fmt::format(" from {:.4g} to {:.4g}", range.low, range.high)
                                  : fmt::format(" constant at {:.4g}", range.low);
}

struct AxisRange {
    double low{0.0};
    double high{1.0};

    /// Returns the range of all points, extended to whole ticks. The range is never empty.
    static AxisRange of(const std::vector<Curve>& curves, bool of_x) {
        const DrawnRange found = range_of(curves, of_x).value_or(DrawnRange{0.0, 1.0});
        AxisRange range{found.low, found.high};
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

    std::string svg(const DrawnTitle title) {
        const double first = title == DrawnTitle::yes ? 0.0 : title_height;
        const std::size_t rows = (plot_.curves.size() + legend_columns - 1) / legend_columns;
        const double height = legend_top + legend_row * static_cast<double>(std::max<std::size_t>(rows, 1)) + 4.0;
        text_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 {0} {1} {2}\" width=\"{1}\" height=\"{2}\" "
            "role=\"img\" aria-label=\"{3}\" font-family=\"sans-serif\" font-size=\"12\">\n<title>{4}</title>\n<rect "
            "y=\"{0}\" width=\"{1}\" height=\"{2}\" fill=\"#ffffff\"/>\n",
            first, width, height - first, escaped(plot_words(plot_)), escaped(plot_.title));
        if (title == DrawnTitle::yes) {
            put(left, 24.0, plot_.title, "font-size=\"15\" font-weight=\"bold\"");
        }
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
        const std::string line = fmt::format(
            "stroke=\"{}\" stroke-width=\"{:.1f}\" stroke-dasharray=\"{}\"", colours[i % std::size(colours)],
            thinnest + wider * static_cast<double>(i / std::size(dashes)), dashes[i % std::size(dashes)]);
        text_ += fmt::format("<path d=\"{}\" fill=\"none\" {}/>\n", path, line);
        const std::size_t columns = std::min(plot_.curves.size(), legend_columns);
        const double x = left + static_cast<double>(i % columns) * (right - left) / static_cast<double>(columns);
        const double y = legend_top + static_cast<double>(i / columns) * legend_row + 2.0;
        text_ += fmt::format("<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x,
                             x + legend_sample, y, y, line);
        put(x + legend_sample + 6.0, y + 4.0, curve.name, "");
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
        const auto range = range_of({curve}, false);
        curves += fmt::format("{}{}{}", curves.empty() ? "" : ", ", curve.name, range ? words_of(*range) : "");
    }
    std::string marks;
    for (const auto& mark : plot.marks) {
        marks += fmt::format("{}“{}” at {:.4g}", marks.empty() ? " Marked: " : ", ", mark.word, mark.x);
    }
    const auto x = range_of(plot.curves, true);
    return fmt::format("{}. Plot of {} against {}{}: {}.{}", plot.title, plot.y_label, plot.x_label,
                       x ? words_of(*x) : "", curves, marks.empty() ? "" : marks + ".");
}

std::string write_svg(const LinePlot& plot, const DrawnTitle title) {
    return Canvas{plot}.svg(title);
}

}  // namespace canproof::host
