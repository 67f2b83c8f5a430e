// SPDX-License-Identifier: Apache-2.0
#include "host/conform/language/filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "host/base/cia301.hpp"
#include "host/conform/language/object_reference.hpp"
#include "host/datasheet/eds_values.hpp"

namespace canproof::host::conform {

namespace {

using Test = std::function<bool(const SheetEntry&)>;

bool is_integer(const Entry& entry) {
    return integer_limits(entry.type) && entry.type != "BOOLEAN";
}

/// Returns whether the entry is an integer of at most four bytes whose upper limit is below that of its type. A test
/// can then write a value above the limit.
bool has_upper_limit(const SheetEntry& one) {
    const auto type = integer_limits(one.entry->type);
    const auto highest = highest_of(*one.entry);
    return is_integer(*one.entry) && type_size(one.entry->type) <= 4 && highest && *highest < type->second;
}

bool has_lower_limit(const SheetEntry& one) {
    const auto type = integer_limits(one.entry->type);
    const auto lowest = lowest_of(*one.entry);
    return is_integer(*one.entry) && type_size(one.entry->type) <= 4 && lowest && *lowest > type->first;
}

/// Returns whether a write to the entry does more than store a value: whether the entry is a COB-ID, a mapping, a
/// parameter of a communication service, or a DOMAIN.
bool is_special(const SheetEntry& one) {
    const unsigned index = one.object->index;
    static const std::set<unsigned> special{cia301::error_list,
                                            cia301::sync_cob_id,
                                            cia301::sync_period,
                                            cia301::sync_window,
                                            cia301::store_parameters,
                                            cia301::restore_parameters,
                                            cia301::time_cob_id,
                                            cia301::emcy_cob_id,
                                            cia301::emcy_inhibit_time,
                                            cia301::consumer_heartbeat_time,
                                            cia301::producer_heartbeat_time,
                                            cia301::sync_counter_overflow,
                                            cia301::verify_configuration,
                                            cia301::guard_time,
                                            cia301::life_time_factor,
                                            cia301::error_behaviour,
                                            cia301::nmt_startup};
    const bool servers_and_pdos = index >= cia301::sdo_server_parameter && index < cia301::first_manufacturer_object;
    return special.count(index) != 0 || servers_and_pdos || one.entry->type == "DOMAIN";
}

const std::map<std::string, Test>& word_tests() {
    const auto access = [](const char* word) {
        return [word](const SheetEntry& one) { return one.entry->access == word; };
    };
    const auto type = [](const char* word) {
        return [word](const SheetEntry& one) { return one.entry->type == word; };
    };
    const auto mapping = [](const char* word) {
        return [word](const SheetEntry& one) { return one.entry->mapping == word || one.entry->mapping == "both"; };
    };
    static const std::map<std::string, Test> tests{
        {"readable", [](const SheetEntry& one) { return is_readable(*one.entry); }},
        {"writable", [](const SheetEntry& one) { return is_writable(*one.entry); }},
        {"ro", [](const SheetEntry& one) { return one.entry->access == "ro" || one.entry->access == "const"; }},
        {"rw", access("rw")},
        {"wo", access("wo")},
        {"const", access("const")},
        {"u8", type("UNSIGNED8")},
        {"u16", type("UNSIGNED16")},
        {"u32", type("UNSIGNED32")},
        {"u64", type("UNSIGNED64")},
        {"i8", type("INTEGER8")},
        {"i16", type("INTEGER16")},
        {"i32", type("INTEGER32")},
        {"i64", type("INTEGER64")},
        {"boolean", type("BOOLEAN")},
        {"domain", type("DOMAIN")},
        {"real", [](const SheetEntry& one) { return one.entry->type.rfind("REAL", 0) == 0; }},
        {"string", [](const SheetEntry& one) { return is_string_type(one.entry->type); }},
        {"integer", [](const SheetEntry& one) { return is_integer(*one.entry); }},
        {"unsigned", [](const SheetEntry& one) { return one.entry->type.rfind("UNSIGNED", 0) == 0; }},
        {"default", [](const SheetEntry& one) { return one.entry->value.index() != 0; }},
        {"upper limit", has_upper_limit},
        {"lower limit", has_lower_limit},
        {"mappable", [](const SheetEntry& one) { return one.entry->mapping != "none"; }},
        {"unmappable", [](const SheetEntry& one) { return one.entry->mapping == "none"; }},
        {"mappable tpdo", mapping("tpdo")},
        {"mappable rpdo", mapping("rpdo")},
        {"application", [](const SheetEntry& one) { return one.object->index >= cia301::first_manufacturer_object; }},
        {"communication",
         [](const SheetEntry& one) {
             return one.object->index >= cia301::first_object && one.object->index < cia301::first_manufacturer_object;
         }},
        {"rpdo only", [](const SheetEntry& one) { return one.entry->mapping == "rpdo"; }},
        {"tpdo only", [](const SheetEntry& one) { return one.entry->mapping == "tpdo"; }},
        {"plain", [](const SheetEntry& one) { return !is_special(one); }},
    };
    return tests;
}

std::string known_words() {
    std::string text;
    for (const auto& [word, test] : word_tests()) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text + ", size > 4, index 1000..1FFF, sub 01, not 1003 1010, not writable";
}

unsigned hex_number(Scanner& line) {
    const std::string word = line.word();
    if (word.empty() || word.size() > 4 || word.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
        line.fail(fmt::format("`{}` is no index or sub-index", word), "write one to four hexadecimal digits");
    }
    return static_cast<unsigned>(std::stoul(word, nullptr, 16));
}

Test range_test(Scanner& line, bool index) {
    const unsigned first = hex_number(line);
    const unsigned last = line.take("..") ? hex_number(line) : first;
    return [first, last, index](const SheetEntry& one) {
        const unsigned number = index ? one.object->index : one.entry->subindex;
        return number >= first && number <= last;
    };
}

/// Parses the rest of a filter after `not`: a word such as `writable`, or indices of objects such as `1003 1010`.
Test negated_test(Scanner& line) {
    const std::size_t start = line.position();
    const auto word = word_tests().find(line.rest());
    if (word != word_tests().end()) {
        return [test = word->second](const SheetEntry& one) { return !test(one); };
    }
    line.go_back(start);
    std::set<unsigned> left_out;
    while (!line.at_end()) {
        left_out.insert(hex_number(line));
    }
    return [left_out](const SheetEntry& one) { return left_out.count(one.object->index) == 0; };
}

Test size_test(Scanner& line) {
    std::string sign;
    for (const char* one : {">=", "<=", ">", "<", "="}) {
        if (sign.empty() && line.take(one)) {
            sign = one;
        }
    }
    const std::string word = line.word();
    if (sign.empty() || word.empty() || word.size() > 6 || word.find_first_not_of("0123456789") != std::string::npos) {
        line.fail("a size needs a comparison and a number of bytes", "write size > 4");
    }
    return [sign, size = static_cast<std::size_t>(std::stoul(word))](const SheetEntry& one) {
        const std::size_t has = entry_size(*one.entry);
        return (sign == ">" && has > size) || (sign == ">=" && has >= size) || (sign == "<" && has < size) ||
               (sign == "<=" && has <= size) || (sign == "=" && has == size);
    };
}

/// Parses alternatives such as `u8|u16`, of which an entry must have one.
Test any_of_words(Scanner& line, const std::string& text) {
    std::vector<Test> any;
    std::size_t start = 0;
    while (start <= text.size()) {
        const std::size_t end = std::min(text.find('|', start), text.size());
        std::string word = text.substr(start, end - start);
        word.erase(0, std::min(word.find_first_not_of(' '), word.size()));
        word.erase(word.find_last_not_of(' ') + 1);
        const auto found = word_tests().find(word);
        if (found == word_tests().end()) {
            line.fail(fmt::format("`{}` is no filter for entries", word), "use " + known_words());
        }
        any.push_back(found->second);
        start = end + 1;
    }
    return [any](const SheetEntry& one) {
        return std::any_of(any.begin(), any.end(), [&](const Test& test) { return test(one); });
    };
}

Test parse_condition(const std::string& text, const Place& place) {
    Scanner part{text, place};
    Test test;
    if (part.take_word("size")) {
        test = size_test(part);
    } else if (part.take_word("index")) {
        test = range_test(part, true);
    } else if (part.take_word("subs") || part.take_word("sub")) {
        test = range_test(part, false);
    } else if (part.take_word("not")) {
        test = negated_test(part);
    } else {
        return any_of_words(part, text);
    }
    part.finish();
    return test;
}

}  // namespace

bool Filter::passes(const SheetEntry& one) const {
    return std::all_of(tests.begin(), tests.end(), [&](const Test& test) { return test(one); });
}

std::vector<SheetEntry> Filter::select(const ConformSheet& sheet) const {
    std::vector<SheetEntry> found;
    for (const Object& object : sheet.part.objects) {
        for (const Entry& entry : object.entries) {
            const SheetEntry one{&object, &entry};
            if (passes(one)) {
                found.push_back(one);
            }
        }
    }
    return found;
}

Filter parse_filter(Scanner& line, const std::string& end) {
    Filter filter;
    filter.words = line.up_to(end);
    std::size_t start = 0;
    while (start <= filter.words.size()) {
        const std::size_t comma = std::min(filter.words.find(',', start), filter.words.size());
        filter.tests.push_back(parse_condition(filter.words.substr(start, comma - start), line.place()));
        start = comma + 1;
    }
    return filter;
}

namespace {

/// Returns the default value of the entry, as a read should return it. Adds the node-ID if the data sheet says so.
Value default_value(const ConformSheet& sheet, const Entry& entry) {
    if (const auto* text = std::get_if<std::string>(&entry.value)) {
        return Value{Bytes(text->begin(), text->end())};
    }
    if (const auto* real = std::get_if<double>(&entry.value)) {
        Bytes bytes(type_size(entry.type));
        const auto single = static_cast<float>(*real);
        const auto* const first = bytes.size() == sizeof single ? reinterpret_cast<const std::uint8_t*>(&single)
                                                                : reinterpret_cast<const std::uint8_t*>(real);
        std::copy_n(first, bytes.size(), bytes.begin());
        return Value{bytes};
    }
    const auto* truth = std::get_if<bool>(&entry.value);
    const auto* number = std::get_if<std::int64_t>(&entry.value);
    const std::int64_t base = number != nullptr ? *number : truth != nullptr && *truth ? 1 : 0;
    return Value{little_endian(base + (entry.node_id ? sheet.node_id : 0), type_size(entry.type))};
}

}  // namespace

Value entry_value(const ConformSheet& sheet, const SheetEntry& one) {
    Value value{std::int64_t{one.object->index}};
    value.fields = [&sheet, one](const std::string& field) -> std::optional<Value> {
        const Entry& entry = *one.entry;
        const auto size = static_cast<std::int64_t>(entry_size(entry));
        const std::map<std::string, std::int64_t> numbers{
            {"index", one.object->index},
            {"sub", entry.subindex},
            {"size", size},
            {"bits", entry.type == "BOOLEAN" ? 1 : size * 8},
            {"type", static_cast<std::int64_t>(data_type_number(entry.type))},
            {"code", static_cast<std::int64_t>(object_code(*one.object))},
            {"readable", is_readable(entry) ? 1 : 0},
            {"writable", is_writable(entry) ? 1 : 0},
            {"high", highest_of(entry).value_or(0)},
            {"low", lowest_of(entry).value_or(0)}};
        if (field == "default") {
            return default_value(sheet, entry);
        }
        const auto found = numbers.find(field);
        return found == numbers.end() ? std::nullopt : std::optional{Value{found->second}};
    };
    return value;
}

}  // namespace canproof::host::conform
