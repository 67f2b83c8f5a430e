// SPDX-License-Identifier: Apache-2.0
#include "host/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/report/markup.hpp"

namespace canproof::host {

namespace {

const char* const style = R"(
:root{color-scheme:light dark;--line:#8883;--quiet:#5a625f;--good:#1c6b3a;--bad:#a32016;--part:#7a5a00;--link:#0b6e6e;--head:#f1f4f2;--back:#fdfdfb;--text:#1b2220}
@media(prefers-color-scheme:dark){:root{--quiet:#a3aeaa;--good:#7fd39b;--bad:#ff9b8e;--part:#e2c16a;--link:#6fcfcb;--head:#232a28;--back:#171c1b;--text:#e6ebe8}}
*{box-sizing:border-box}
body{margin:0;background:var(--back);color:var(--text);font:16px/1.55 system-ui,sans-serif}
nav{display:flex;flex-wrap:wrap;gap:.2rem 1.1rem;padding:.7rem max(1rem,calc(50vw - 37rem));background:var(--head);border-bottom:1px solid var(--line)}
nav a{color:inherit;text-decoration:none;padding:.15rem 0}nav a[aria-current]{font-weight:650;box-shadow:0 2px var(--link)}
main{max-width:76rem;margin:0 auto;padding:1rem}
h1{font-size:1.9rem;line-height:1.2;margin:1.2rem 0 .6rem}h2{font-size:1.3rem;margin:2.2rem 0 .6rem}h3{font-size:1.05rem;margin:1.6rem 0 .4rem}
p{max-width:46rem}a{color:var(--link)}code{font-size:.9em;overflow-wrap:anywhere}small,.quiet{color:var(--quiet)}
table{border-collapse:collapse;width:100%;font-size:.9rem;margin:.6rem 0 1.2rem}
th,td{text-align:left;vertical-align:top;padding:.4rem .9rem .4rem 0;border-bottom:1px solid var(--line)}th{font-weight:600;background:var(--back);position:sticky;top:0}
caption{text-align:left;font-weight:600;padding:.4rem 0}li,td{overflow-wrap:anywhere}td a{display:inline-block;min-width:1.5rem;padding:.2rem 0}.n{font-variant-numeric:tabular-nums}td.n,span.n{white-space:nowrap}td.n,th.n{text-align:right}
.holds,.shown{color:var(--good)}.open,.not{color:var(--bad)}.partly{color:var(--part)}.state{white-space:nowrap;font-weight:600}
.tile{display:inline-block;border-left:.3rem solid;padding:0 .4rem;font-weight:600;white-space:nowrap}.tiles{display:flex;flex-wrap:wrap;gap:.3rem;margin:1rem 0}.tiles a{text-decoration:none;font-size:.8rem}td ul{margin:0;padding-left:1.1rem}td p{margin:.2rem 0}
.proven{color:var(--good);background:#1c6b3a22}.unproven{color:var(--part);background:#7a5a0022}.uncovered{color:var(--bad);background:#a3201622}.aside{color:var(--quiet);background:#8882}
.claim{border-left:3px solid var(--line);padding:.1rem 0 .1rem 1rem;margin:.9rem 0}.claim>p{margin:.25rem 0}.claim .claim{margin-left:.2rem}
input[type=search]{font:inherit;width:min(100% - 6.5rem,26rem);padding:.4rem .6rem;border:1px solid var(--quiet);border-radius:.3rem;background:var(--back);color:inherit}
figure{margin:1rem 0}figure img,figure svg{width:100%;height:auto;background:#fff;border-radius:.3rem}
.wrap{overflow-x:auto}footer{max-width:76rem;margin:0 auto;padding:1rem;color:var(--quiet);font-size:.85rem;overflow-wrap:anywhere}
.grid{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,22rem),1fr));gap:1rem}
@media(max-width:44rem){thead{display:none}tr,td{display:block}tr{border-bottom:1px solid var(--line);padding:.5rem 0}tr[hidden]{display:none}td{border:0;padding:.1rem 0}td[data-h]::before{content:attr(data-h) ": ";color:var(--quiet);font-size:.85em}td:empty{display:none}td.n{text-align:left}.wrap tr{display:table-row}.wrap td{display:table-cell;padding:.3rem .9rem .3rem 0;overflow-wrap:normal}}
@page{size:A4;margin:14mm 12mm}@page wide{size:A4 landscape}
@media print{:root{--line:#999;--quiet:#444;--good:#14532d;--bad:#8f1a10;--part:#6b4e00;--head:#fff;--back:#fff;--text:#000}html{font-size:8.5pt}nav,input,[role=status],script,footer{display:none}body{font-size:1rem;line-height:1.35}main{max-width:none;padding:0}p{max-width:none}h1{margin-top:0}h1,h2,h3{break-after:avoid}th{position:static}tr,.claim>p,figure{break-inside:avoid}a{color:inherit;text-decoration:none}.wide{page:wide}.grid{grid-template-columns:1fr 1fr}}
)";

constexpr std::size_t many_columns = 4;  ///< a table with more columns is printed in landscape format

const char* const search_script = R"(
for(const field of document.querySelectorAll('input[type=search]')){
const rows=[...field.parentElement.querySelectorAll('tbody tr')].map(r=>[r,r.textContent.toLowerCase()]);
const counted=field.nextElementSibling;
const show=()=>{const words=field.value.toLowerCase().split(/\s+/).filter(Boolean);let n=0;
for(const[r,t]of rows){const hit=words.every(w=>t.includes(w));r.hidden=!hit;n+=hit}
counted.textContent=n+' of '+rows.length};
field.addEventListener('input',show);
const asked=new URLSearchParams(location.search).get('q');if(asked)field.value=asked;show();
}
)";

/// Returns the style rule that prints the origin of a page and the page number at the foot of each sheet.
std::string printed_origin(const std::string& origin) {
    if (origin.empty()) {
        return "";
    }
    std::string words;
    for (const char c : origin) {
        words += c == '"' || c == '\\' || c == '<' || c == '\n' ? ' ' : c;
    }
    return fmt::format(
        "@page{{@bottom-left{{content:\"{}\";font-size:7pt}}@bottom-right{{content:counter(page);font-size:7pt}}}}\n",
        words);
}

bool is_number(const std::string& cell) {
    const bool digits_alone = cell.find_first_not_of("0123456789.") == std::string::npos;
    return digits_alone && std::count(cell.begin(), cell.end(), '.') <= 1 && cell.find_first_of("0123456789") == 0;
}

/// Returns whether the column has at least one cell with text and all such cells are numbers. Section numbers ("2.1.1")
/// are no numbers here.
bool holds_numbers(const std::vector<std::vector<std::string>>& rows, const std::size_t column) {
    bool any = false;
    for (const auto& row : rows) {
        const bool says_nothing = column >= row.size() || row[column].empty();
        if (!says_nothing && !is_number(row[column])) {
            return false;
        }
        any = any || !says_nothing;
    }
    return any;
}

}  // namespace

std::string html_page(const std::string& title, const std::string& own_page, const PageFrame& frame,
                      const std::string& body) {
    std::string text = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width,initial-scale=1\">\n<title>{} · "
        "canproof</title><style>{}{}</style></head>\n<body>"
        "{}",
        escaped(title), style, printed_origin(frame.origin),
        frame.navigation.empty() ? "" : "<nav aria-label=\"Pages\">\n");
    for (const auto& entry : frame.navigation) {
        text += fmt::format("<a href=\"{}\"{}>{}</a>\n", escaped(entry.page),
                            entry.page == own_page ? " aria-current=\"page\"" : "", escaped(entry.title));
    }
    text += fmt::format("{}<main><h1>{}</h1>\n{}</main>\n", frame.navigation.empty() ? "" : "</nav>\n", escaped(title),
                        body);
    if (!frame.origin.empty()) {
        text += fmt::format("<footer>{}</footer>\n", escaped(frame.origin));
    }
    if (body.find("type=search") != std::string::npos) {
        text += fmt::format("<script>{}</script>\n", search_script);
    }
    return text + "</body></html>\n";
}

std::string html_table(const std::vector<HtmlColumn>& head, const std::vector<std::vector<std::string>>& rows,
                       const Search search, const std::string& caption) {
    std::string text = head.size() > many_columns ? "<div class=wide>" : "<div>";
    if (search == Search::yes) {
        text +=
            "<input type=search aria-label=\"Search the table\" placeholder=\"Search\"> <small role=status></small>";
    }
    text += caption.empty() ? "<table>" : fmt::format("<table><caption>{}</caption>", escaped(caption));
    text += "<thead><tr>";
    std::vector<bool> numbers;
    for (const auto& column : head) {
        numbers.push_back(holds_numbers(rows, numbers.size()));
        text += numbers.back() ? "<th scope=col class=n" : "<th scope=col";
        text += column.share == 0 ? ">" : fmt::format(" style=\"width:{}%\">", column.share);
        text += column.title;
    }
    text += "</thead><tbody>\n";
    for (const auto& row : rows) {
        text += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            text += row[i].empty() ? "<td>"
                                   : fmt::format("<td{} data-h=\"{}\">{}", numbers[i] ? " class=n" : "", head[i].title,
                                                 numbers[i] ? grouped(row[i]) : row[i]);
        }
        text += "\n";
    }
    return text + "</tbody></table></div>\n";
}

std::string html_state(const std::string& word) {
    struct Look {
        const char* name;
        const char* mark;
    };
    const bool good = word == "holds" || word == "shown";
    const bool bad = word == "open" || word == "failed" || word == "missing";
    const bool grey = word == "not measured" || word == "not applicable";
    const Look look = good   ? Look{"holds", "✓"}
                      : bad  ? Look{"open", "✗"}
                      : grey ? Look{"quiet", "○"}
                             : Look{"partly", "◐"};
    return fmt::format("<span class=\"state {}\">{} {}</span>", look.name, look.mark, word);
}

}  // namespace canproof::host
