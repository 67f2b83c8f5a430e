// SPDX-License-Identifier: Apache-2.0
#include "host/register/read_object.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <tuple>

#include "host/base/cia301.hpp"
#include "host/register/object_family.hpp"
#include "host/register/read_item.hpp"
#include "host/register/service_words.hpp"
#include "host/register/written_form.hpp"

namespace canproof::host {

namespace {

const std::vector<std::string> access_words{"ro", "wo", "rw", "const"};
const std::vector<std::string> mapping_words{"none", "rpdo", "tpdo", "both"};
const std::string node_id_mark = "$NODEID+";

std::string numbered(std::string text, std::int64_t n) {
    const auto at = text.find("{n}");
    if (at != std::string::npos) {
        text.replace(at, 3, std::to_string(n));
    }
    return text;
}

/// Parses a reference to an object in hexadecimal: `"4020"` or `"4020:1"`. Returns false for any other text.
bool parse_reference(const std::string& text, Limit& limit) {
    const auto colon = text.find(':');
    const std::string index = text.substr(0, colon);
    const std::string sub = colon == std::string::npos ? "" : text.substr(colon + 1);
    const auto is_hex = [](const std::string& s) {
        return !s.empty() && s.size() <= 4 && s.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
    };
    if (!is_hex(index) || (!sub.empty() && !is_hex(sub)) || (colon != std::string::npos && sub.empty())) {
        return false;
    }
    limit.kind = Limit::Kind::object;
    limit.index = static_cast<std::uint16_t>(std::stoul(index, nullptr, 16));
    limit.subindex = sub.empty() ? -1 : std::stoi(sub, nullptr, 16);
    return true;
}

Limit read_limit(TomlItem& range, const std::string& key) {
    Limit limit;
    const toml::node* node = range.node(key);
    if (node == nullptr) {
        return limit;
    }
    limit.place = range.place(key);
    if (node->is_number()) {
        limit.kind = Limit::Kind::number;
        limit.number = literal(*node);
        return limit;
    }
    std::string reference;
    if (const auto table = node->as_table()) {
        TomlItem item{*table, range.file(), range.faults()};
        reference = item.text("object");
        limit.add = item.integer_or("add", 0, INT32_MIN, INT32_MAX);
        item.finish();
    } else if (const auto text = node->as_string()) {
        reference = text->get();
    }
    if (!parse_reference(reference, limit)) {
        range.fault(range.place(key), fmt::format("limit {} is neither a number nor an object", key),
                    "write a number, \"4020\", \"4020:1\" or { object = \"4020\", add = -100 }");
    }
    return limit;
}

/// Returns the range in the TOML table `range = { … }` of an item.
Range read_range(TomlItem& item, TomlItem& table_item, const Place& place) {
    Range range;
    TomlItem* const table = &table_item;
    range.place = place;
    range.minimum = read_limit(*table, "min");
    range.maximum = read_limit(*table, "max");
    range.table = table->text_or("table", "");
    range.zero = table->boolean_or("zero", false);
    if (const auto* list = table->node("values")) {
        if (const auto array = list->as_array()) {
            for (const auto& one : *array) {
                range.values.push_back(literal(one));
            }
        }
        if (range.values.empty()) {
            table->fault(table->place("values"), "the list `values` is empty", "list the values that may be written");
        }
    }
    if (table->table().empty()) {
        item.fault(item.place("range"), "range is empty", "give min, max, values or table, or leave range out");
    }
    table->finish();
    return range;
}

Range read_range(TomlItem& item) {
    const toml::node* node = item.node("range");
    if (node != nullptr && node->is_array() && item.has("array")) {
        return Range{};  // read_element_ranges() reads a list with one range for each element
    }
    auto table = item.item("range");
    return table ? read_range(item, *table, item.place("range")) : Range{};
}

void set_default(Entry& entry, const toml::node& node) {
    // If the default is a list, it becomes an invalid value here, which the check of the defaults reports.
    const bool list = !node.is_value() && !is_string_type(entry.type);
    const Value value = list ? Value{std::string{"[list]"}} : literal(node);
    const auto* text = std::get_if<std::string>(&value);
    if (text != nullptr && !is_string_type(entry.type) && text->rfind(node_id_mark, 0) == 0) {
        try {
            std::size_t used = 0;
            const std::int64_t base = std::stoll(text->substr(node_id_mark.size()), &used, 0);
            if (node_id_mark.size() + used == text->size()) {
                entry.value = base;
                entry.node_id = true;
                return;
            }
        } catch (const std::exception&) {
            // The check of the default's type reports a text that is not a number.
        }
    }
    entry.value = value;
}

/// Reads the fields that [[object]] and [[object.entry]] have in common.
Entry read_entry_fields(TomlItem& item) {
    Entry entry;
    entry.place = item.place();
    entry.default_place = item.place("default");
    entry.type = item.text("type");
    if (!entry.type.empty() && !is_known_type(entry.type)) {
        item.fault(item.place("type"), fmt::format("type {} is unknown", entry.type),
                   "use a CiA 301 type in capitals, such as UNSIGNED16, REAL32 or VISIBLE_STRING");
    }
    entry.access = item.word("access", access_words, "");
    entry.range = read_range(item);
    entry.mapping = item.word("mapping", mapping_words, "none");
    entry.stored = item.boolean_or("stored", entry.access == "rw");
    entry.service = item.word("service", service_words(), "none");
    entry.factory = item.boolean_or("factory", false);
    entry.live = item.boolean_or("live", false);
    entry.length = static_cast<std::size_t>(item.integer_or("length", 0, 1, 250));
    return entry;
}

Entry sub_zero(const Place& place, std::size_t highest) {
    Entry entry;
    entry.name = "Highest sub-index";
    entry.type = "UNSIGNED8";
    entry.access = "const";
    entry.value = static_cast<std::int64_t>(highest);
    entry.place = place;
    entry.default_place = place;
    return entry;
}

const toml::node* default_for(const toml::node* node, std::int64_t n) {
    const auto table = node == nullptr ? nullptr : node->as_table();
    if (table == nullptr) {
        return node;
    }
    // A member without a value gets the value of another member here, because check_family_default() already reports
    // the missing value.
    const toml::node* own = table->get(std::to_string(n));
    return own != nullptr || table->empty() ? own : &table->begin()->second;
}

/// Returns the text of a key, and adds a fault unless it is printable ASCII.
std::string read_name(TomlItem& item, const std::string& key, const std::string& name) {
    if (!is_printable_ascii(name)) {
        item.fault(item.place(key), fmt::format("{} \"{}\" is not printable ASCII", key, name),
                   "write the name in ASCII, because an EDS has no other characters");
    }
    return name;
}

/// Returns the names in the field `element`: a list with one name for each element, or one name in which {n} stands for
/// the number.
std::vector<std::string> read_element_names(TomlItem& item, const std::string& object, std::size_t count) {
    const toml::node* node = item.node("element");
    if (node == nullptr || !node->is_array()) {
        const std::string name =
            item.has("element") ? read_name(item, "element", item.text("element")) : object + " {n}";
        if (count > 1 && name.find("{n}") == std::string::npos) {
            item.fault(item.place("element"), fmt::format("{} elements have the name \"{}\"", count, name),
                       "write {n} in the name for the number of the element, or a list of names");
        }
        return std::vector<std::string>(count, name);
    }
    std::vector<std::string> names = item.texts("element", true);
    for (const std::string& name : names) {
        read_name(item, "element", name);
    }
    if (names.size() != count) {
        item.fault(item.place("element"), fmt::format("element lists {} names for {} elements", names.size(), count),
                   "give one name for all elements, or one name for each element");
        names.resize(count, object);
    }
    return names;
}

/// Returns the ranges in the field `range`: one for all elements, or a list with one for each element.
std::vector<Range> read_element_ranges(TomlItem& item, const Entry& pattern, std::size_t count) {
    std::vector<Range> ranges(count, pattern.range);
    const toml::node* node = item.node("range");
    const auto list = node == nullptr ? nullptr : node->as_array();
    if (list == nullptr) {
        return ranges;
    }
    if (list->size() != count) {
        item.fault(item.place("range"), fmt::format("range lists {} ranges for {} elements", list->size(), count),
                   "give one range for all elements, or one range for each element");
    }
    for (std::size_t i = 0; i < std::min(count, list->size()); ++i) {
        const toml::node& one = *list->get(i);
        if (const auto table = one.as_table()) {
            TomlItem range{*table, item.file(), item.faults()};
            ranges[i] = read_range(item, range, item.place(one));
        } else {
            item.fault(item.place(one), fmt::format("range of element {} is no table", i + 1),
                       "write { min = …, max = … }");
        }
    }
    return ranges;
}

void read_elements(TomlItem& item, Object& object, std::int64_t n, std::size_t count) {
    const Entry pattern = read_entry_fields(item);
    const std::vector<std::string> elements = read_element_names(item, object.name, count);
    const std::vector<Range> ranges = read_element_ranges(item, pattern, count);
    const toml::node* defaults = default_for(item.node("default"), n);
    const auto list = defaults == nullptr ? nullptr : defaults->as_array();
    if (list != nullptr && list->size() != count) {
        item.fault(item.place("default"), fmt::format("default lists {} values for {} elements", list->size(), count),
                   "give one value for all elements, or one value for each element");
    }
    for (std::size_t sub = 1; sub <= count; ++sub) {
        Entry entry = pattern;
        entry.subindex = static_cast<std::uint8_t>(sub);
        entry.name = numbered(elements[sub - 1], static_cast<std::int64_t>(sub));
        entry.range = ranges[sub - 1];
        if (list != nullptr) {
            const toml::node* one = list->get(std::min(sub, list->size()) - 1);
            if (one != nullptr) {
                set_default(entry, *one);
                entry.default_place = item.place(*one);
            }
        } else if (defaults != nullptr) {
            set_default(entry, *defaults);
        }
        object.entries.push_back(entry);
    }
}

void read_var(TomlItem& item, Object& object, std::int64_t n) {
    Entry entry = read_entry_fields(item);
    entry.name = object.name;
    if (const auto* node = default_for(item.node("default"), n)) {
        set_default(entry, *node);
        entry.default_place = item.place(*node);
    }
    object.entries.push_back(entry);
}

void read_listed_entries(TomlItem& item, Object& object, const FamilyMember& member) {
    for (TomlItem& sub : item.items("entry")) {
        Entry entry = read_entry_fields(sub);
        entry.subindex = static_cast<std::uint8_t>(sub.integer("sub", 0, 254));
        if (object.alike && entry.subindex != 0) {
            sub.fault(sub.place("sub"), fmt::format("an object with `array` also lists entry {}", entry.subindex),
                      "list entry 0 only, or list all entries without `array`");
        }
        entry.name = numbered(read_name(sub, "name", sub.text("name")), member.n);
        check_family_default(sub, member);
        if (const auto* node = default_for(sub.node("default"), member.n)) {
            set_default(entry, *node);
            entry.default_place = sub.place(*node);
        }
        sub.finish();
        object.entries.push_back(entry);
    }
}

void add_sub_zero(Object& object) {
    const auto zero = [](const Entry& e) { return e.subindex == 0; };
    if (std::none_of(object.entries.begin(), object.entries.end(), zero)) {
        std::size_t highest = 0;
        for (const auto& entry : object.entries) {
            highest = std::max<std::size_t>(highest, entry.subindex);
        }
        object.entries.push_back(sub_zero(object.place, highest));
    }
    std::sort(object.entries.begin(), object.entries.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.subindex, a.place.line) < std::tie(b.subindex, b.place.line);
    });
}

/// Returns the object code of CiA 301 in the field `kind`, which is "array" or "record". Returns `usual` when the field
/// is missing. Adds a fault for any other word.
Object::Kind read_kind(TomlItem& item, Object::Kind usual) {
    const std::string word = item.text_or("kind", usual == Object::Kind::array ? "array" : "record");
    if (word != "array" && word != "record") {
        item.fault(item.place("kind"), fmt::format("kind \"{}\" is unknown", word), "write \"array\" or \"record\"");
    }
    return word == "array" ? Object::Kind::array : Object::Kind::record;
}

Object read_one(TomlItem& item, const std::string& prefix, std::int64_t index, const FamilyMember& member) {
    Object object;
    read_common(item, object, false);
    object.id_place = item.place("index");
    object.index = static_cast<std::uint16_t>(index);
    object.id = fmt::format("{}-OD-{:04X}", prefix, object.index);
    const std::string name = read_name(item, "name", item.text("name"));
    object.name = numbered(name, member.n);
    if (item.has("repeat")) {
        object.family = name;
        object.member = static_cast<int>(member.n);
    }
    object.unit = item.text_or("unit", "");
    const auto count = static_cast<std::size_t>(item.integer_or("array", 0, 1, 254));
    if (count > 0) {
        object.alike = true;
        object.kind = read_kind(item, Object::Kind::array);
        read_elements(item, object, member.n, count);
        read_listed_entries(item, object, member);
        add_sub_zero(object);
    } else if (item.has("entry")) {
        object.kind = read_kind(item, Object::Kind::record);
        read_listed_entries(item, object, member);
        add_sub_zero(object);
    } else {
        object.kind = Object::Kind::var;
        read_var(item, object, member.n);
    }
    return object;
}

}  // namespace

std::vector<Object> read_objects(TomlItem& item, const std::string& prefix) {
    ObjectFamily family = read_family(item);
    const std::size_t before_index = item.faults().size();
    const std::int64_t base = item.integer("index", cia301::first_object, 0xFFFF);
    const bool has_index = item.faults().size() == before_index;
    if (const std::int64_t highest = base + family.offset(family.last); highest > 0xFFFF) {
        item.fault(item.place("repeat"), fmt::format("family reaches index {:X}h", highest),
                   "lower `last` or `step`: the greatest index is FFFFh");
        family.last = family.first;
    }
    check_family_default(item, FamilyMember{family.first, family.first, family.last});
    std::vector<Object> all;
    // All members of a family have the same faults, so only the faults of the first member are kept.
    const std::size_t faults_before = item.faults().size();
    std::size_t faults_after = faults_before;
    for (std::int64_t n = family.first; n <= family.last; ++n) {
        all.push_back(read_one(item, prefix, base + family.offset(n), FamilyMember{n, family.first, family.last}));
        if (n == family.first) {
            faults_after = item.faults().size();
        }
    }
    item.faults().erase(item.faults().begin() + static_cast<std::ptrdiff_t>(faults_after), item.faults().end());
    item.finish();
    if (!has_index) {
        all.clear();  // the missing index is already reported; an assumed index would only cause further faults
    }
    return all;
}

}  // namespace canproof::host
