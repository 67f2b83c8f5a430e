// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/argument_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host/assess/evidence/argument_page.hpp"
#include "host/assess/evidence/exhibit.hpp"
#include "host/report/markup.hpp"

namespace canproof::host {

namespace {

constexpr int box_width = 118;
constexpr int gap = 10;
constexpr int between = 18;  ///< vertical distance between two boxes
constexpr int margin = 8;    ///< distance between the edge of a box and its text
constexpr int line_height = 14;
constexpr int solution_corner = 20;  // corner radius of the boxes for evidence; a greater one would cut off the text
constexpr std::size_t most_in_line = 15;  ///< characters of a title that fit into a line

/// Returns the colour for a claim or evidence in this state. The graph also shows the state as a word, for readers who
/// cannot see colours.
const char* outline_of(const Exhibit::State state) {
    switch (state) {
        case Exhibit::State::holds:
            return "#1c6b3a";
        case Exhibit::State::absent:
            return "#5a625f";
        case Exhibit::State::stale:
            return "#7a5a00";
        default:
            return "#a32016";
    }
}

/// Returns the number of characters of a text in UTF-8.
std::size_t characters_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](const char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Returns the words of a title in lines that fit into a box. A word that is longer than a line has a line alone.
std::vector<std::string> lines_of(const std::string& title) {
    std::vector<std::string> lines{""};
    std::istringstream words{title};
    for (std::string word; words >> word;) {
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (lines.back().empty() || characters_of(longer) <= most_in_line) {
            lines.back() = longer;
        } else {
            lines.push_back(word);
        }
    }
    return lines;
}

struct Box {
    int x;
    int y;
    std::string link;
    std::vector<std::string> lines;
    Exhibit::State state;

    int height() const { return (static_cast<int>(lines.size()) + 1) * line_height + margin + 4; }
    int bottom() const { return y + height(); }
};

/// Returns a box of the graph as SVG. `corner` is the radius of its corners: 0 for a claim, more for evidence.
std::string box_svg(const Box& box, const int corner) {
    std::string shown = fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"{}\" fill=\"#fff\" stroke=\"{}\" stroke-width=\"2\"/>",
        box.x, box.y, box_width, box.height(), corner, outline_of(box.state));
    int y = box.y + margin + line_height / 2;
    for (const auto& line : box.lines) {
        shown += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"11\" font-weight=\"600\" fill=\"#1b2220\">{}</text>",
                             box.x + margin, y, escaped(line));
        y += line_height;
    }
    shown += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"11\" fill=\"{}\">{}</text>", box.x + margin, y,
                         outline_of(box.state), word_of(box.state));
    return box.link.empty() ? shown : fmt::format("<a href=\"{}\">{}</a>\n", escaped(box.link), shown);
}

std::string line_svg(const int x1, const int y1, const int x2, const int y2) {
    return fmt::format("<path d=\"M{} {}V{}H{}V{}\" fill=\"none\" stroke=\"#5a625f\"/>\n", x1, y1, (y1 + y2) / 2, x2,
                       y2);
}

std::vector<const Claim*> children_of(const Argument& argument, const std::string& id) {
    std::vector<const Claim*> all;
    for (const auto& claim : argument.claims) {
        if (claim.parent == id) {
            all.push_back(&claim);
        }
    }
    return all;
}

/// Draws one column of the graph: a claim and, below it, its evidence. Returns the y coordinate of the column's bottom
/// edge.
int draw_column(std::string& text, const Claim& claim, const Argument& argument, const Exhibits& exhibits, const int x,
                const int y) {
    const Box goal{x, y, "#" + claim.id, {claim.id}, state_of_claim(claim, argument, exhibits)};
    text += box_svg(goal, 0);
    int bottom = goal.bottom();
    for (const auto& key : claim.evidence) {
        const int middle = x + box_width / 2;
        text += line_svg(middle, bottom, middle, bottom + between);
        const auto found = exhibits.find(key);
        const Box solution =
            found == exhibits.end()
                ? Box{x, bottom + between, "", lines_of(key), Exhibit::State::absent}
                : Box{x, bottom + between, found->second.page, lines_of(found->second.title), found->second.state};
        text += box_svg(solution, solution_corner);
        bottom = solution.bottom();
    }
    return bottom;
}

}  // namespace

std::string write_argument_json(const Argument& argument, const Exhibits& exhibits) {
    using Json = nlohmann::ordered_json;
    Json goals = Json::array();
    for (const auto& claim : argument.claims) {
        goals.push_back({{"id", claim.id},
                         {"supports", claim.parent.empty() ? Json(nullptr) : Json(claim.parent)},
                         {"statement", claim.text},
                         {"state", word_of(state_of_claim(claim, argument, exhibits))},
                         {"context", claim.limits},
                         {"solutions", claim.evidence}});
    }
    Json solutions = Json::object();
    for (const auto& [key, one] : exhibits) {
        solutions[key] = {{"title", one.title}, {"state", word_of(one.state)}, {"says", one.says}, {"open", one.open}};
    }
    const Json json{{"notation", "GSN"}, {"goals", goals}, {"solutions", solutions}};
    return json.dump(2) + "\n";
}

std::string argument_graph(const Argument& argument, const Exhibits& exhibits) {
    std::string text;
    int x = 2;
    int lowest = 0;
    for (const Claim* root : children_of(argument, "")) {
        const auto children = children_of(argument, root->id);
        const int columns = std::max(1, static_cast<int>(children.size()));
        const int middle = x + (columns * (box_width + gap) - gap) / 2 - box_width / 2;
        const int own = draw_column(text, *root, argument, exhibits, middle, 2);
        for (const Claim* child : children) {
            text += line_svg(middle + box_width / 2, own, x + box_width / 2, own + between);
            lowest = std::max(lowest, draw_column(text, *child, argument, exhibits, x, own + between));
            x += box_width + gap;
        }
        lowest = std::max(lowest, own);
        x += children.empty() ? box_width + gap : 0;
    }
    return fmt::format(
        "<figure class=wrap><svg viewBox=\"0 0 {0} {1}\" style=\"min-width:{0}px\" role=\"group\" aria-label=\"Graph "
        "of the claims, each with the evidence below it; the list below has the same content\" "
        "font-family=\"system-ui,sans-serif\">\n{2}</svg><figcaption>Square boxes are claims, round boxes are "
        "evidence. A box links to its claim, or to the page of its evidence.</figcaption></figure>\n",
        std::max(x, box_width) + 4, lowest + 4, text);
}

}  // namespace canproof::host
