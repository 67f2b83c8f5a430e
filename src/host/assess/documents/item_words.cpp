// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/item_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/datasheet/eds_values.hpp"
#include "host/datasheet/entry_words.hpp"

namespace canproof::host {

namespace {

std::string literal_words(const Value& value, const bool hexadecimal) {
    const auto* number = std::get_if<std::int64_t>(&value);
    return hexadecimal && number != nullptr ? fmt::format("{:02X}h", *number) : to_text(value);
}

std::string access_words(const std::string& access) {
    return access == "rw"      ? "read and write"
           : access == "ro"    ? "read only"
           : access == "wo"    ? "write only"
           : access == "const" ? "constant"
                               : access;
}

std::string mapping_words(const std::string& mapping) {
    return mapping == "rpdo"   ? "may be mapped into RPDOs"
           : mapping == "tpdo" ? "may be mapped into TPDOs"
           : mapping == "both" ? "may be mapped into RPDOs and TPDOs"
                               : "cannot be mapped into PDOs";
}

std::string default_words(const Entry& entry) {
    const std::string value = eds_default(entry);
    if (value.empty()) {
        return "no default";
    }
    return fmt::format("default {}{}", value, entry.factory ? " (each single device has a factory value instead)" : "");
}

std::string with_unit(const std::string& text, const std::string& unit) {
    return unit.empty() ? text : text + " " + unit;
}

std::string number_words(const std::optional<double>& number) {
    return number ? fmt::format("{}", *number) : "";
}

/// Returns `Sub 1` or `Sub 1 to 4`.
std::string subs_words(const unsigned first, const unsigned last) {
    return first == last ? fmt::format("Sub {}", first) : fmt::format("Sub {} to {}", first, last);
}

template <typename Items>
auto find_item(const Items& items, const std::string& id) {
    return std::find_if(items.begin(), items.end(), [&id](const auto& item) { return item.id == id; });
}

}  // namespace

std::string entry_words(const Entry& entry) {
    const std::string range = range_words(entry);
    return fmt::format("{}, {}, {}, {}, {}, {}", entry.type, access_words(entry.access),
                       range.empty() ? "every value of the type" : "range " + range, default_words(entry),
                       entry.stored ? "stored by 1010h (store parameters)" : "not stored",
                       mapping_words(entry.mapping));
}

std::string object_words(const Object& object) {
    const Object sheet = as_in_sheet(object);
    if (object.kind == Object::Kind::var) {
        return sheet.entries.empty() ? "" : entry_words(sheet.entries.front()) + ".";
    }
    std::string text = fmt::format("{}.", kind_name(object));
    for (std::size_t first = 0; first < sheet.entries.size();) {
        const std::string words = entry_words(sheet.entries[first]);
        std::size_t last = first;
        while (last + 1 < sheet.entries.size() && entry_words(sheet.entries[last + 1]) == words) {
            ++last;
        }
        text += fmt::format(" {} ({}): {}.", subs_words(sheet.entries[first].subindex, sheet.entries[last].subindex),
                            sheet.entries[first].name, words);
        first = last + 1;
    }
    return text;
}

std::string constant_words(const Constant& constant) {
    return fmt::format("{}: {} = {}.", constant.type, constant.name,
                       with_unit(literal_words(constant.value, constant.hexadecimal), constant.unit));
}

std::string enumeration_words(const Enumeration& enumeration) {
    std::vector<std::string> words;
    for (const auto& [word, number] : enumeration.values) {
        words.push_back(fmt::format("{} = {}", word, literal_words(number, enumeration.hexadecimal)));
    }
    return fmt::format("{}.", fmt::join(words, ", "));
}

std::string cell_words(const Cell& cell) {
    std::vector<std::string> words;
    for (const auto& part : cell.parts) {
        const std::string first = literal_words(part.first, part.hexadecimal);
        const std::string last = literal_words(part.last, part.hexadecimal);
        words.push_back(first == last || last.empty() ? first : first + " … " + last);
    }
    return words.empty() ? "any" : fmt::format("{}", fmt::join(words, " or "));
}

std::string table_words(const Table& table) {
    const auto names = [](const std::vector<Column>& columns) {
        std::vector<std::string> words;
        for (const auto& column : columns) {
            words.push_back(column.unit.empty() ? column.name : fmt::format("{} ({})", column.name, column.unit));
        }
        return fmt::format("{}", fmt::join(words, ", "));
    };
    std::string text = fmt::format("{} → {}:", names(table.inputs), names(table.outputs));
    for (const auto& row : table.rows) {
        std::vector<std::string> cells;
        for (const auto& cell : row.cells) {
            cells.push_back(cell_words(cell));
        }
        const auto middle = cells.begin() + static_cast<std::ptrdiff_t>(std::min(table.inputs.size(), cells.size()));
        text += fmt::format(" {} → {};", fmt::join(cells.begin(), middle, ", "), fmt::join(middle, cells.end(), ", "));
    }
    text.back() = '.';
    return text;
}

std::string signal_words(const Signal& signal) {
    const std::string range = signal.minimum || signal.maximum
                                  ? number_words(signal.minimum) + " … " + number_words(signal.maximum)
                                  : "every value of the type";
    return fmt::format("{}: {}, {}, {}, at power-on {}.", fmt::join(signal.names(), ", "),
                       signal.input ? "input" : "output", signal.type, with_unit(range, signal.unit),
                       with_unit(to_text(signal.value), signal.unit));
}

std::string item_words(const Part& part, const std::string& id) {
    if (const auto found = find_item(part.objects, id); found != part.objects.end()) {
        return object_words(*found);
    }
    if (const auto found = find_item(part.constants, id); found != part.constants.end()) {
        return constant_words(*found);
    }
    if (const auto found = find_item(part.enumerations, id); found != part.enumerations.end()) {
        return enumeration_words(*found);
    }
    if (const auto found = find_item(part.tables, id); found != part.tables.end()) {
        return table_words(*found);
    }
    if (const auto found = find_item(part.signals, id); found != part.signals.end()) {
        return signal_words(*found);
    }
    return "";
}

}  // namespace canproof::host
