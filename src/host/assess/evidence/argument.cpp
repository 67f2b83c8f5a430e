// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/argument.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "host/register/toml_records.hpp"

namespace canproof::host {

namespace {

void read_claims(TomlItem& whole, Argument& argument) {
    for (auto& item : whole.items("claim")) {
        const Claim claim{item.text("id"), item.text_or("parent", ""), item.text("text"), item.texts("evidence", false),
                          item.text_or("limits", "")};
        const auto known = [&claim](const Claim& other) { return other.id == claim.parent; };
        if (!claim.parent.empty() && std::none_of(argument.claims.begin(), argument.claims.end(), known)) {
            item.fault(item.place("parent"), fmt::format("there is no claim `{}` above this claim", claim.parent),
                       "name a claim that stands before this claim in the file");
        }
        argument.claims.push_back(claim);
        item.finish();
    }
}

void read_tables(TomlItem& whole, Argument& argument) {
    for (auto& item : whole.items("evidence")) {
        constexpr std::int64_t week = 7 * 24 * 60;
        argument.evidence.push_back({item.text("key"), item.text("title"), item.text("made_by"),
                                     item.text_or("run", ""), item.integer_or("minutes", 0, 0, week)});
        item.finish();
    }
    for (auto& item : whole.items("tool")) {
        argument.tools.push_back(
            {item.text("name"), item.text_or("package", ""), item.text("hides"), item.text("noticed"),
             item.has("class") ? item.word("class", {"T1", "T2", "T3"}, "") : "", item.text_or("defects", "")});
        item.finish();
    }
}

/// Splits a text at each `mark`.
std::vector<std::string> split(const std::string& text, const std::string& mark) {
    std::vector<std::string> parts;
    std::size_t at = 0;
    for (auto end = text.find(mark); end != std::string::npos; end = text.find(mark, at)) {
        parts.push_back(text.substr(at, end - at));
        at = end + mark.size();
    }
    parts.push_back(text.substr(at));
    return parts;
}

/// Sets the state of a technique, and the exhibits on which the state rests, from a field such as
/// `shown: coverage, fuzz`.
void set_state(Technique& technique, const std::string& field) {
    static const std::string mark = ": ";
    const auto colon = field.find(mark);
    technique.state = field.substr(0, colon);
    if (colon != std::string::npos) {
        technique.exhibits = split(field.substr(colon + mark.size()), ", ");
    }
}

void read_rows(TomlItem& item, std::vector<Technique>& into) {
    static const std::array<const char*, 4> states{"shown", "partly", "missing", "not applicable"};
    constexpr std::size_t columns = 5;
    const std::string table = item.text("table");
    const std::string title = item.text("title");
    for (const auto& row : item.texts("rows", true)) {
        const auto fields = split(row, " | ");
        if (fields.size() != columns) {
            item.fault(item.place("rows"), fmt::format("`{}` has {} fields", row, fields.size()),
                       "write five fields: number | technique | level | state | what is here");
            continue;
        }
        Technique made{table, title, fields[0], fields[1], fields[2], "", fields[4]};
        set_state(made, fields[3]);
        if (std::find(states.begin(), states.end(), made.state) == states.end()) {
            item.fault(
                item.place("rows"), fmt::format("`{}` is no state", fields[3]),
                fmt::format("write one of: {}; and the exhibits on which it rests, as in `shown: coverage, fuzz`",
                            fmt::join(states, ", ")));
        } else {
            into.push_back(std::move(made));
        }
    }
    item.finish();
}

}  // namespace

std::vector<Technique> read_techniques(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder)) {
        for (const auto& file : std::filesystem::directory_iterator{folder}) {
            if (file.path().extension() == ".toml") {
                files.push_back(file.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    std::vector<Technique> all;
    for (const auto& file : files) {
        read_toml_records(file, [&all](TomlItem& whole) {
            for (auto& item : whole.items("table")) {
                read_rows(item, all);
            }
        });
    }
    return all;
}

Argument read_argument(const std::filesystem::path& file) {
    Argument argument;
    read_toml_records(file, [&argument](TomlItem& whole) {
        read_claims(whole, argument);
        read_tables(whole, argument);
    });
    return argument;
}

}  // namespace canproof::host
