// SPDX-License-Identifier: Apache-2.0
#include "host/assess/change/register_diff.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/one_line.hpp"

namespace canproof::host {

namespace {

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string limit_text(const Limit& limit) {
    if (limit.kind != Limit::Kind::object) {
        return to_text(limit.number);
    }
    const std::string sub = limit.subindex < 0 ? "" : fmt::format(":{}", limit.subindex);
    const std::string sum = limit.add == 0 ? "" : fmt::format(" {:+}", limit.add);
    return fmt::format("{:04X}h{}{}", limit.index, sub, sum);
}

std::string cell_text(const Cell& cell) {
    std::vector<std::string> parts;
    for (const auto& part : cell.parts) {
        const std::string first = to_text(part.first);
        parts.push_back(part.first == part.last ? first : first + ".." + to_text(part.last));
    }
    return cell.any() ? "*" : fmt::format("{}", fmt::join(parts, " or "));
}

void add(Facets& facets, const Answer& answer) {
    facets["topic"] = answer.topic;
    facets["choice"] = answer.choice;
    facets["differs"] = answer.differs;
    facets["overrides"] = answer.overrides;
}

void add(Facets& facets, const Requirement& item) {
    add(facets, item.answer);
    facets["kind"] = item.kind;
    facets["verify"] = joined(item.verify);
    facets["retired"] = item.retired;
}

void add(Facets& facets, const Object& item) {
    facets["name"] = item.name;
    facets["unit"] = item.unit;
    for (const Entry& entry : item.entries) {
        const std::string sub = fmt::format("sub {} ", entry.subindex);
        facets[sub + "name"] = entry.name;
        facets[sub + "type"] = entry.type;
        facets[sub + "access"] = entry.access;
        facets[sub + "default"] = (entry.node_id ? "node-ID + " : "") + to_text(entry.value);
        facets[sub + "minimum"] = limit_text(entry.range.minimum);
        facets[sub + "maximum"] = limit_text(entry.range.maximum);
        std::vector<std::string> values;
        for (const Value& value : entry.range.values) {
            values.push_back(to_text(value));
        }
        facets[sub + "values"] = joined(values);
        facets[sub + "zero allowed"] = entry.range.zero ? "yes" : "";
        facets[sub + "mapping"] = entry.mapping;
        facets[sub + "stored"] = entry.stored ? "yes" : "no";
        facets[sub + "service"] = entry.service;
        facets[sub + "length"] = fmt::format("{}", entry.length);
    }
}

void add(Facets& facets, const Table& item) {
    std::vector<std::string> columns;
    for (const auto* side : {&item.inputs, &item.outputs}) {
        for (const Column& column : *side) {
            columns.push_back(column.name + (column.type.empty() ? "" : " " + column.type));
        }
    }
    facets["columns"] = joined(columns);
    for (std::size_t i = 0; i < item.rows.size(); ++i) {
        std::vector<std::string> cells;
        for (const Cell& cell : item.rows[i].cells) {
            cells.push_back(cell_text(cell));
        }
        facets[fmt::format("row {:3}", i + 1)] = joined(cells);
    }
}

void add(Facets& facets, const Enumeration& item) {
    facets["name"] = item.name;
    for (const auto& [word, number] : item.values) {
        facets["value " + word] = fmt::format("{}", number);
    }
}

void add(Facets& facets, const Constant& item) {
    facets["name"] = item.name;
    facets["type"] = item.type;
    facets["unit"] = item.unit;
    facets["value"] = to_text(item.value);
}

void add(Facets& facets, const Signal& item) {
    facets["name"] = fmt::format("{} ({}, {})", item.name, item.count, item.input ? "input" : "output");
    facets["type"] = item.type;
    facets["unit"] = item.unit;
    facets["minimum"] = item.minimum ? fmt::format("{}", *item.minimum) : "";
    facets["maximum"] = item.maximum ? fmt::format("{}", *item.maximum) : "";
    facets["default"] = to_text(item.value);
}

void add(Facets& facets, const Decision& item) {
    add(facets, item.answer);
    facets["chosen"] = item.chosen;
    facets["because"] = item.because;
    facets["affects"] = item.affects.empty() ? item.none : joined(item.affects);
    facets["severity"] = item.severity;
    for (std::size_t i = 0; i < item.readings.size(); ++i) {
        facets[fmt::format("reading {}", i + 1)] = item.readings[i].says + " [" + item.readings[i].source + "]";
    }
}

template <typename Items>
void describe_all(const Items& items, const char* word, std::map<std::string, DescribedItem>& all) {
    for (const auto& item : items) {
        DescribedItem& described = all[item.id];
        described.word = word;
        described.facets["text"] = one_line(item.text);
        described.facets["source"] = joined(origins(item));
        add(described.facets, item);
    }
}

/// Adds the statements of a manual. The key of a statement contains the mark (a hash) of its first passage in the
/// manual, not its number: a new statement changes the numbers of the following statements, but not their marks.
void describe_statements(const Manual& manual, std::map<std::string, DescribedItem>& all) {
    for (const Statement& statement : manual.statements) {
        const std::string mark = statement.marks.empty() ? "" : statement.marks.front().text();
        DescribedItem& described = all[fmt::format("{}:{} {}", manual.key, statement.section, mark)];
        described.word = "statement";
        described.facets["text"] = one_line(statement.text);
        described.facets["covered"] = joined(statement.covered);
        described.facets["reason"] = one_line(statement.reason);
    }
}

/// Returns `NAME: old -> new` for each facet that differs. A facet is a named part of an item, such as `text` or `row
/// 3`. A missing value appears as `none`.
std::vector<std::string> differences(const Facets& before, const Facets& after) {
    Facets all = before;
    all.insert(after.begin(), after.end());
    std::vector<std::string> details;
    const auto value = [](const Facets& facets, const std::string& facet) {
        const auto found = facets.find(facet);
        return found == facets.end() ? std::string{} : found->second;
    };
    for (const auto& [facet, unused] : all) {
        const std::string old = value(before, facet);
        const std::string now = value(after, facet);
        if (old != now) {
            details.push_back(
                fmt::format("{}: {} -> {}", facet, old.empty() ? "none" : old, now.empty() ? "none" : now));
        }
    }
    return details;
}

}  // namespace

std::map<std::string, DescribedItem> describe(const Register& content) {
    std::map<std::string, DescribedItem> all;
    for (const auto& part : content.parts) {
        describe_all(part.requirements, "requirement", all);
        describe_all(part.objects, "object", all);
        describe_all(part.tables, "table", all);
        describe_all(part.enumerations, "enumeration", all);
        describe_all(part.constants, "constant", all);
        describe_all(part.signals, "signal", all);
        describe_all(part.decisions, "decision", all);
    }
    for (const auto& manual : content.manuals) {
        describe_statements(manual, all);
    }
    return all;
}

std::vector<ItemChange> compare(const Register& before, const Register& after) {
    const auto old = describe(before);
    const auto now = describe(after);
    auto all = old;
    all.insert(now.begin(), now.end());
    std::vector<ItemChange> changes;
    for (const auto& [id, item] : all) {
        const auto was = old.find(id);
        const auto is = now.find(id);
        if (was == old.end()) {
            changes.push_back({ItemChange::Kind::added, id, item.word, {}});
        } else if (is == now.end()) {
            changes.push_back({ItemChange::Kind::removed, id, item.word, {}});
        } else if (auto details = differences(was->second.facets, is->second.facets); !details.empty()) {
            changes.push_back({ItemChange::Kind::changed, id, item.word, std::move(details)});
        }
    }
    return changes;
}

}  // namespace canproof::host
