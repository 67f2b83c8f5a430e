// SPDX-License-Identifier: Apache-2.0
#include "host/register/read_manual.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <map>

#include "host/register/written_form.hpp"

namespace canproof::host {

namespace {

Section read_section(TomlItem& item) {
    Section section;
    section.place = item.place();
    section.ref = item.text("ref");
    section.title = item.text("title");
    const std::string disposition = item.word("disposition", {"normative", "informative", "condition-of-use"}, "");
    section.normative = disposition == "normative";
    section.reason = item.text_or("reason", "");
    section.objects = item.texts("objects", false);
    section.conditions = item.texts("conditions", false);
    if (disposition == "condition-of-use" && section.conditions.empty()) {
        item.fault(fmt::format("section {} gives no condition of use", section.ref),
                   "add `conditions = [\"…\"]`, or give the section another disposition");
    } else if (disposition == "informative" && section.reason.empty()) {
        item.fault(fmt::format("informative section {} gives no reason", section.ref),
                   "add `reason = …`, or make the section normative");
    }
    item.finish();
    return section;
}

Manual read_manual(TomlItem& item) {
    Manual manual;
    manual.place = item.place();
    manual.key = item.text("key");
    manual.title = item.text("title");
    manual.publisher = item.text("publisher");
    manual.revision = item.text("revision");
    manual.date = item.text("date");
    if (!manual.date.empty() && !is_date(manual.date)) {
        item.fault(item.place("date"), fmt::format("date {} is no date", manual.date), "write YYYY-MM-DD");
    }
    for (TomlItem& one : item.items("section")) {
        manual.sections.push_back(read_section(one));
    }
    item.finish();
    return manual;
}

/// Returns the passage marks (hashes) in the field `mark`, which contains one mark or a list of marks.
std::vector<Mark> read_marks(TomlItem& item) {
    const toml::node* node = item.node("mark");
    const bool is_list = node != nullptr && node->is_array();
    const std::vector<std::string> words =
        is_list ? item.texts("mark", true) : std::vector<std::string>{item.text("mark")};
    std::vector<Mark> marks;
    for (const std::string& word : words) {
        if (const auto mark = read_mark(word)) {
            marks.push_back(*mark);
        } else if (!word.empty()) {  // the reader has already reported an empty text
            item.fault(item.place("mark"), fmt::format("mark {} is malformed", word),
                       "write LENGTH:HASH, the hash with 12 hexadecimal digits in lower case");
        }
    }
    return marks;
}

Statement read_statement(TomlItem& item) {
    Statement statement;
    statement.place = item.place();
    statement.section = item.text("section");
    statement.section_place = item.place("section");
    statement.text = item.text("text");
    statement.marks = read_marks(item);
    statement.mark_place = item.place("mark");
    statement.covered = item.texts("covered", false);
    statement.covered_place = item.place("covered");
    statement.reason = item.text_or("reason", "");
    if (!statement.covered.empty() && !statement.reason.empty()) {
        item.fault("a statement has both `covered` and `reason`",
                   "keep `covered` if items cover the statement, otherwise keep `reason`");
    }
    item.finish();
    return statement;
}

/// Returns the path without extension: `spec/manuals/NAME` for `spec/manuals/NAME.toml`.
std::string stem_of(const std::string& path) {
    return path.substr(0, path.rfind('.'));
}

Manual* manual_of(const std::string& path, std::vector<Manual>& manuals) {
    const std::string folder = path.substr(0, path.find('/', manuals_folder.size()));
    const auto found = std::find_if(manuals.begin(), manuals.end(),
                                    [&](const Manual& one) { return stem_of(one.place.file) == folder; });
    return found == manuals.end() ? nullptr : &*found;
}

}  // namespace

void read_manual_file(TomlItem& item, std::vector<Manual>& manuals) {
    const bool is_manual = item.file().find('/', manuals_folder.size()) == std::string::npos;
    if (is_manual) {
        manuals.push_back(read_manual(item));
        return;
    }
    Manual* manual = manual_of(item.file(), manuals);
    if (manual == nullptr) {
        item.fault("the folder belongs to no manual",
                   "give the folder the name of the manual's file: spec/manuals/NAME/ beside spec/manuals/NAME.toml");
    }
    for (TomlItem& one : item.items("statement")) {
        Statement statement = read_statement(one);
        if (manual != nullptr) {
            manual->statements.push_back(std::move(statement));
        }
    }
    item.finish();
}

void number_statements(std::vector<Manual>& manuals) {
    for (Manual& manual : manuals) {
        std::map<std::string, unsigned> count;
        for (Statement& statement : manual.statements) {
            statement.number = ++count[statement.section];
        }
    }
}

}  // namespace canproof::host
