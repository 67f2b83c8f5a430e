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
h1{font-size:1.9rem;line-height:1.2;margin:1.2rem 0 .6rem;overflow-wrap:anywhere}h2{font-size:1.3rem;margin:2.2rem 0 .6rem}h3{font-size:1.05rem;margin:1.6rem 0 .4rem}
p,main>ul>li,.claim li{max-width:46rem}a{color:var(--link)}code{font-size:.9em;overflow-wrap:anywhere}small,.quiet{color:var(--quiet)}
table{border-collapse:collapse;width:100%;font-size:.9rem;margin:.6rem 0 1.2rem}
th,td{text-align:left;vertical-align:baseline;padding:.4rem .9rem .4rem 0;border-bottom:1px solid var(--line)}th{font-weight:600;background:var(--back);position:sticky;top:0}
td a[href*=".html#"]:not([href*="#L"],[href*="#service-"]){white-space:nowrap}details>p{margin:.3rem 0}
caption{text-align:left;font-weight:600;padding:.4rem 0}h2+div>table>caption,h3+div>table>caption,summary+div>table>caption{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}li,td{overflow-wrap:break-word}.n{font-variant-numeric:tabular-nums}td.n,span.n{white-space:nowrap}td.n,th.n{text-align:right}
.holds,.shown{color:var(--good)}.open,.not{color:var(--bad)}.partly{color:var(--part)}.state{white-space:nowrap;font-weight:600}
.tile{display:inline-block;border-left:.3rem solid;padding:0 .4rem;font-weight:600;white-space:nowrap}.tiles{display:flex;flex-wrap:wrap;gap:.3rem;margin:1rem 0}.tiles a{text-decoration:none;font-size:.8rem}td ul{margin:0;padding-left:1.1rem}td p{margin:.2rem 0}
.proven{color:var(--good);background:#1c6b3a22}.unproven{color:var(--part);background:#7a5a0022}.uncovered{color:var(--bad);background:#a3201622}.aside{color:var(--quiet);background:#8882}
.claim{border-left:3px solid var(--line);padding:.1rem 0 .1rem 1rem;margin:.9rem 0}.claim>p{margin:.25rem 0}.claim .claim{margin-left:.2rem}
input[type=search]{font:inherit;width:min(100% - 6.5rem,26rem);padding:.4rem .6rem;border:1px solid var(--quiet);border-radius:.3rem;background:var(--back);color:inherit}
.filter{display:flex;flex-wrap:wrap;align-items:center;gap:.4rem 1rem;margin:1rem 0}select{font:inherit;padding:.35rem .4rem;border:1px solid var(--quiet);border-radius:.3rem;background:var(--back);color:inherit}
details{border-top:1px solid var(--line)}summary{cursor:pointer;padding:.5rem 0}summary h2,summary h3{display:inline;font-size:1.1rem;margin:0 .6rem 0 .2rem}summary small{margin-right:.4rem}summary .state{margin-right:.8rem}
.source{margin:0;padding-left:3.5rem;font-size:.9rem;line-height:1.4}.source li::marker{color:var(--quiet);font-variant-numeric:tabular-nums}.source code{white-space:pre-wrap}.source li:target{background:#c8a40033}.source a{display:inline-block;min-height:1.5rem}
pre{white-space:pre-wrap;overflow-wrap:anywhere}figure{margin:1rem 0}figcaption{font-weight:600;font-size:.9rem}figure img,figure svg{width:100%;height:auto;background:#fff;border-radius:.3rem}
.wrap{overflow-x:auto}footer{max-width:76rem;margin:0 auto;padding:1rem;color:var(--quiet);font-size:.85rem;overflow-wrap:anywhere}
@media(max-width:44rem){figure a{display:block;overflow-x:auto}figure a img{width:44rem}thead{display:none}tr,td{display:block}tr{border-bottom:1px solid var(--line);padding:.5rem 0}tr[hidden]{display:none}td{border:0;padding:.1rem 0;overflow-wrap:anywhere}td[data-h]::before{content:attr(data-h) ": ";color:var(--quiet);font-size:.85em}td:empty{display:none}td.n{text-align:left;display:inline-block;margin-right:1rem}.wrap tr{display:table-row}.wrap td{display:table-cell;padding:.3rem .9rem .3rem 0;overflow-wrap:normal}}
@media screen{td br+a{display:inline-block;min-height:1.5rem}}
@page{size:A4;margin:10mm 9mm}@page wide{size:A4 landscape}
@media print{:root{--line:#999;--quiet:#444;--good:#14532d;--bad:#8f1a10;--part:#6b4e00;--head:#fff;--back:#fff;--text:#000}html{font-size:8pt}nav,input,.filter,.screen,[role=status],script,footer{display:none}details::details-content{content-visibility:visible;display:block}summary{list-style:none;padding:.2rem 0}details table{font-size:.83rem;line-height:1.1}td p{margin:.1rem 0}td,th{padding-top:.1rem;padding-bottom:.1rem}details table{margin:0 0 .4rem}.source li{break-inside:avoid}body{font-size:1rem;line-height:1.35}main{max-width:none;padding:0}p{max-width:none}h1{margin-top:0}h1,h2,h3{break-after:avoid}th{position:static}tr,.claim>p,figure{break-inside:avoid}a{color:inherit;text-decoration:none}.wide{page:wide}}
)";

constexpr std::size_t many_columns = 4;  ///< a table with more columns is printed in landscape format

const char* const search_script = R"(
for(const field of document.querySelectorAll('input[type=search]')){
const box=field.closest('.filtered')||field.parentElement;
const rows=[...box.querySelectorAll('tbody tr')].map(r=>[r,r.textContent.toLowerCase()]);
const choices=[...box.querySelectorAll('select')],parts=[...box.querySelectorAll('details')];
const counted=field.nextElementSibling;
const show=()=>{const words=field.value.toLowerCase().split(/\s+/).filter(Boolean);let n=0;
const chosen=choices.filter(c=>c.value);
for(const[r,t]of rows){const hit=words.every(w=>t.includes(w))&&chosen.every(c=>r.querySelector(c.dataset.of)?.textContent.endsWith(c.value));r.hidden=!hit;n+=hit}
const asked=words.length+chosen.length>0;
for(const p of parts){const hit=!!p.querySelector('tbody tr:not([hidden])');p.hidden=!hit;
if(asked){p.dataset.was??=p.open?'open':'closed';p.open=hit}else if(p.dataset.was){p.open=p.dataset.was==='open';delete p.dataset.was}}
counted.textContent=n+' of '+rows.length};
field.addEventListener('input',show);for(const c of choices)c.addEventListener('change',show);
const asked=new URLSearchParams(location.search).get('q');if(asked)field.value=asked;show();
}
const reveal=()=>{const part=document.getElementById(location.hash.slice(1))?.closest('details');if(part)part.open=true};
addEventListener('hashchange',reveal);reveal();
addEventListener('beforeprint',()=>{for(const part of document.querySelectorAll('details'))part.open=true});
)";

const char* const search_field =
    "<input type=search aria-label=\"Search the table\" placeholder=\"Search\"> <small role=status></small>";

/// Returns the text with blanks in place of the characters that would end a string in a style sheet.
std::string in_style(const std::string& text) {
    std::string words;
    for (const char c : text) {
        words += c == '"' || c == '\\' || c == '<' || c == '\n' ? ' ' : c;
    }
    return words;
}

/// Returns the style rule for printed sheets: it prints the title of the page at the head, and the page's origin and
/// the number of the sheet at the foot.
std::string printed_origin(const std::string& title, const std::string& origin) {
    return origin.empty()
               ? ""
               : fmt::format(
                     "@page{{@top-left{{content:\"{}\";font-size:7pt}}@bottom-left{{content:\"{}\";font-size:"
                     "7pt}}@bottom-right{{content:counter(page);font-size:7pt}}}}\n",
                     in_style(title), in_style(origin));
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
    const std::string base = frame.way_back.empty() ? "" : fmt::format("<base href=\"{}\">", frame.way_back);
    std::string text = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width,initial-scale=1\">{}\n<title>{} · "
        "canproof</title><style>{}{}</style></head>\n<body>"
        "{}",
        base, escaped(title), style, printed_origin(title, frame.origin),
        frame.navigation.empty() ? "" : "<nav aria-label=\"Pages\">\n");
    for (const auto& entry : frame.navigation) {
        text += fmt::format("<a href=\"{}\"{}>{}</a>\n", escaped(entry.page),
                            entry.page == own_page ? " aria-current=true" : "", escaped(entry.title));
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

std::string html_table(const std::string& caption, const std::vector<HtmlColumn>& head,
                       const std::vector<std::vector<std::string>>& rows, const Search search) {
    std::string text = head.size() > many_columns ? "<div class=wide>" : "<div>";
    if (search == Search::yes) {
        text += search_field;
    }
    text += fmt::format("<table><caption>{}</caption>", escaped(caption));
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

std::string html_figure(const std::string& drawing, const std::string& caption) {
    return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", drawing, escaped(caption));
}

std::string html_judged(const bool good, const std::string& markup) {
    return fmt::format("<span class={}>{} {}</span>", good ? "holds" : "open", good ? "✓" : "✗", markup);
}

std::string html_filter(const std::vector<HtmlChoice>& choices) {
    std::string text = fmt::format("<div class=filter>{}\n", search_field);
    for (const auto& choice : choices) {
        text += fmt::format("<label>{} <select data-of=\"{}\"><option value=\"\">all</option>", escaped(choice.title),
                            escaped(choice.of));
        for (const auto& word : choice.words) {
            text += fmt::format("<option>{}</option>", escaped(word));
        }
        text += "</select></label>\n";
    }
    return text + "</div>\n";
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
