// SPDX-License-Identifier: Apache-2.0
#include "host/register/fingerprint.hpp"

#include <fmt/format.h>

#include "host/base/fnv1a.hpp"
#include "host/base/one_line.hpp"

namespace canproof::host {

namespace {

/// Computes a fingerprint (a hash) from fields. After each field, hashes a separator byte that no text contains.
class Print {
  public:
    Print& add(const std::string& text) {
        hash_ = fnv1a(one_line(text) + '\x1F', hash_);
        return *this;
    }
    Print& add(const Value& value) {
        // Adds the index of the value's type, which distinguishes the text "1" from the number 1.
        return add(fmt::format("{}:{}", value.index(), to_text(value)));
    }
    Print& add(std::int64_t number) { return add(std::to_string(number)); }
    Print& add(const std::optional<double>& number) { return add(number ? fmt::format("{}", *number) : ""); }
    /// Adds the reason of a derived item. A derived item has this reason instead of a manual's section.
    Print& add_origin(const Item& item) { return item.derived.empty() ? *this : add(item.derived); }
    /// Adds an answer to a topic. The check of topics compares answers, so a changed answer needs a new review.
    Print& add_answer(const Answer& answer) {
        return answer.topic.empty() ? *this
                                    : add(answer.topic).add(answer.choice).add(answer.differs).add(answer.overrides);
    }
    std::string text() const { return fmt::format("{:08x}", hash_); }

  private:
    std::uint32_t hash_{fnv1a("")};
};

void add_limit(Print& print, const Limit& limit) {
    print.add(static_cast<std::int64_t>(limit.kind)).add(limit.number).add(std::int64_t{limit.index});
    print.add(std::int64_t{limit.subindex}).add(limit.add);
}

void add_entry(Print& print, const Entry& entry) {
    print.add(std::int64_t{entry.subindex}).add(entry.name).add(entry.type).add(entry.access).add(entry.value);
    print.add(entry.mapping).add(entry.service).add(static_cast<std::int64_t>(entry.length));
    print.add(fmt::format("{}{}{}{}", entry.node_id, entry.stored, entry.factory, entry.live));
    add_limit(print, entry.range.minimum);
    add_limit(print, entry.range.maximum);
    for (const Value& value : entry.range.values) {
        print.add(value);
    }
    if (entry.range.zero) {
        print.add(std::string{"or zero"});
    }
}

void add_column(Print& print, const Column& column) {
    print.add(column.name).add(column.enumeration).add(column.type).add(column.unit);
    print.add(column.minimum.value_or(0)).add(column.maximum.value_or(0));
    for (const auto& word : column.words) {
        print.add(word);
    }
}

void add_row(Print& print, const Table::Row& row) {
    for (const Cell& cell : row.cells) {
        print.add(static_cast<std::int64_t>(cell.parts.size()));
        for (const Cell::Part& part : cell.parts) {
            print.add(part.first).add(part.last);
        }
    }
}

}  // namespace

std::string fingerprint(const Requirement& requirement) {
    return Print{}.add(requirement.text).add_origin(requirement).add_answer(requirement.answer).text();
}

std::string fingerprint(const Object& object) {
    Print print;
    print.add(std::int64_t{object.index}).add(object.name).add(static_cast<std::int64_t>(object.kind));
    print.add(object.text).add(object.unit);
    for (const Entry& entry : object.entries) {
        add_entry(print, entry);
    }
    return print.add_origin(object).text();
}

std::string fingerprint(const Table& table) {
    Print print;
    for (const auto* columns : {&table.inputs, &table.outputs}) {
        print.add(static_cast<std::int64_t>(columns->size()));
        for (const Column& column : *columns) {
            add_column(print, column);
        }
    }
    for (const Table::Row& row : table.rows) {
        add_row(print, row);
    }
    return print.add_origin(table).text();
}

std::string fingerprint(const Enumeration& enumeration) {
    Print print;
    print.add(enumeration.name);
    for (const auto& [word, number] : enumeration.values) {
        print.add(word).add(number);
    }
    return print.add_origin(enumeration).text();
}

std::string fingerprint(const Constant& constant) {
    return Print{}
        .add(constant.name)
        .add(constant.type)
        .add(constant.unit)
        .add(constant.value)
        .add_origin(constant)
        .text();
}

std::string fingerprint(const Signal& signal) {
    Print print;
    print.add(signal.name).add(std::int64_t{signal.count}).add(std::int64_t{signal.input ? 1 : 0});
    print.add(signal.type).add(signal.unit).add(signal.minimum).add(signal.maximum).add(signal.value).add(signal.text);
    return print.add_origin(signal).text();
}

std::string fingerprint(const Decision& decision) {
    Print print;
    print.add(decision.text).add(decision.chosen).add(decision.because).add(decision.none);
    for (const auto& reading : decision.readings) {
        print.add(reading.says).add(reading.source);
    }
    for (const auto& id : decision.affects) {
        print.add(id);
    }
    return print.add_answer(decision.answer).text();
}

std::string fingerprint(const Hazard& hazard) {
    Print print;
    print.add(hazard.text).add(hazard.safe_state);
    for (const auto* ids : {&hazard.at, &hazard.decisions}) {
        print.add(static_cast<std::int64_t>(ids->size()));
        for (const auto& id : *ids) {
            print.add(id);
        }
    }
    for (const auto& failure : hazard.failures) {
        print.add(failure.text).add(failure.reason).add(static_cast<std::int64_t>(failure.prevented_by.size()));
        for (const auto& id : failure.prevented_by) {
            print.add(id);
        }
    }
    return print.text();
}

std::string fingerprint(const Section& section) {
    Print print;
    print.add(std::int64_t{section.normative ? 1 : 0}).add(section.reason);
    for (const auto* texts : {&section.objects, &section.conditions}) {
        print.add(static_cast<std::int64_t>(texts->size()));
        for (const auto& text : *texts) {
            print.add(text);
        }
    }
    return print.text();
}

std::map<std::string, std::string> fingerprints(const Manual& manual) {
    std::map<std::string, std::string> prints;
    for (const auto& section : manual.sections) {
        prints[section.id(manual.key)] = fingerprint(section);
    }
    return prints;
}

std::map<std::string, std::string> fingerprints(const Part& part) {
    std::map<std::string, std::string> prints;
    const auto add_all = [&](const auto& items) {
        for (const auto& item : items) {
            prints[item.id] = fingerprint(item);
        }
    };
    add_all(part.requirements);
    add_all(part.objects);
    add_all(part.tables);
    add_all(part.enumerations);
    add_all(part.constants);
    add_all(part.signals);
    add_all(part.decisions);
    add_all(part.hazards);
    return prints;
}

}  // namespace canproof::host
