// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/eds_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/datasheet/eds_numbers.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

/// Number of bytes that a writable string gets at least, even if its default is shorter.
constexpr std::size_t string_room = 64;
constexpr std::size_t longest_string = 4096;

struct TypeRow {
    unsigned number;
    std::string_view word;
    std::size_t octets;  ///< length in bytes of a type that is read as OCTET_STRING; 0: the firmware supports the type
};

/// The data types of CiA 301, Table 44. Types that the firmware lacks become OCTET_STRING: no service calculates with
/// them.
constexpr std::array<TypeRow, 25> type_rows{{{0x01, "BOOLEAN", 0},
                                             {0x02, "INTEGER8", 0},
                                             {0x03, "INTEGER16", 0},
                                             {0x04, "INTEGER32", 0},
                                             {0x05, "UNSIGNED8", 0},
                                             {0x06, "UNSIGNED16", 0},
                                             {0x07, "UNSIGNED32", 0},
                                             {0x08, "REAL32", 0},
                                             {0x09, "VISIBLE_STRING", 0},
                                             {0x0A, "OCTET_STRING", 0},
                                             {0x0B, "OCTET_STRING", string_room},
                                             {0x0C, "OCTET_STRING", 6},
                                             {0x0D, "OCTET_STRING", 6},
                                             {0x0F, "DOMAIN", 0},
                                             {0x10, "OCTET_STRING", 3},
                                             {0x11, "REAL64", 0},
                                             {0x12, "OCTET_STRING", 5},
                                             {0x13, "OCTET_STRING", 6},
                                             {0x14, "OCTET_STRING", 7},
                                             {0x15, "INTEGER64", 0},
                                             {0x16, "OCTET_STRING", 3},
                                             {0x18, "OCTET_STRING", 5},
                                             {0x19, "OCTET_STRING", 6},
                                             {0x1A, "OCTET_STRING", 7},
                                             {0x1B, "UNSIGNED64", 0}}};

const TypeRow* type_row(unsigned number) {
    const auto found =
        std::find_if(type_rows.begin(), type_rows.end(), [number](const TypeRow& row) { return row.number == number; });
    return found == type_rows.end() ? nullptr : &*found;
}

/// The values of a section that describe an entry. A member is nullptr if its key is absent or empty.
struct EntryKeys {
    const IniValue* name{nullptr};
    const IniValue* object_type{nullptr};
    const IniValue* data_type{nullptr};
    const IniValue* access{nullptr};
    const IniValue* mapping{nullptr};
    const IniValue* standard_value{nullptr};
    const IniValue* configured_value{nullptr};
    const IniValue* low_limit{nullptr};
    const IniValue* high_limit{nullptr};
};

using KeyField = const IniValue* EntryKeys::*;
struct KeyRow {
    std::string_view key;
    KeyField field{nullptr};
};

/// Returns the slot of a key in `keys_by_slot`. No two known keys have the same slot.
constexpr std::size_t key_slot(std::string_view key) {
    constexpr std::size_t slots = 32;
    return key.empty() ? 0 : (key.size() + static_cast<unsigned char>(key.front())) % slots;
}

constexpr std::array<KeyRow, 9> key_rows{{{"parametername", &EntryKeys::name},
                                          {"objecttype", &EntryKeys::object_type},
                                          {"datatype", &EntryKeys::data_type},
                                          {"accesstype", &EntryKeys::access},
                                          {"pdomapping", &EntryKeys::mapping},
                                          {"defaultvalue", &EntryKeys::standard_value},
                                          {"parametervalue", &EntryKeys::configured_value},
                                          {"lowlimit", &EntryKeys::low_limit},
                                          {"highlimit", &EntryKeys::high_limit}}};

constexpr std::array<KeyRow, 32> keys_by_slot = [] {
    std::array<KeyRow, 32> slots{};
    for (const KeyRow& row : key_rows) {
        slots[key_slot(row.key)] = row;
    }
    return slots;
}();

constexpr bool has_each_key_a_slot() {
    for (const KeyRow& row : key_rows) {
        if (keys_by_slot[key_slot(row.key)].key != row.key) {
            return false;
        }
    }
    return true;
}
static_assert(has_each_key_a_slot());

/// Finds the keys in a section in one pass, because a data sheet has thousands of entries.
EntryKeys keys_of(const IniSection& section) {
    EntryKeys keys;
    for (const auto& [key, value] : section.values) {
        const KeyRow& row = keys_by_slot[key_slot(key)];
        if (row.key == key && !value.text.empty()) {
            keys.*(row.field) = &value;
        }
    }
    return keys;
}

void set_place(Place& place, const EdsTelling& tell, unsigned line) {
    place.file = tell.file;
    place.line = line;
}

/// Returns a type for an entry whose DataType is not a number: the type with the name `word`, or a type that fits the
/// sub-index and the value.
std::string assumed_type(const EntryKeys& keys, std::string_view word, bool is_counter) {
    const auto named =
        std::find_if(type_rows.begin(), type_rows.end(), [&](const TypeRow& row) { return word == row.word; });
    if (named != type_rows.end()) {
        return std::string{named->word};
    }
    if (is_counter) {
        return "UNSIGNED8";
    }
    const IniValue* value = keys.standard_value;
    if (value == nullptr) {
        return "UNSIGNED32";
    }
    const auto term = split_node_id(value->text);
    const auto number = term ? eds_value(term->rest, "INTEGER64") : std::nullopt;
    const bool negative = number && std::get<std::int64_t>(*number) < 0;
    return !number ? "VISIBLE_STRING" : negative ? "INTEGER32" : "UNSIGNED32";
}

void read_type(Entry& entry, const IniSection& section, const EntryKeys& keys, bool is_counter,
               const EdsTelling& tell) {
    const IniValue* object_type = keys.object_type;
    const IniValue* given = keys.data_type;
    if (given == nullptr && object_type != nullptr && eds_unsigned(object_type->text) == std::uint64_t{2}) {
        entry.type = "DOMAIN";
        return;
    }
    const auto number = given == nullptr ? std::nullopt : eds_unsigned(given->text);
    if (!number) {
        entry.type = assumed_type(keys, given == nullptr ? "" : given->text, is_counter);
        tell.note(given == nullptr ? section.line : given->line,
                  given == nullptr ? fmt::format("[{}] has no DataType", section.name)
                                   : fmt::format("DataType {} is not a number", given->text),
                  fmt::format("{} is assumed", entry.type));
        return;
    }
    const TypeRow* row = *number <= 0xFFFFU ? type_row(static_cast<unsigned>(*number)) : nullptr;
    entry.type = row == nullptr ? "OCTET_STRING" : row->word;
    entry.length = row == nullptr ? string_room : row->octets;
    if (entry.length != 0) {
        tell.note(given->line, fmt::format("DataType {} is treated as {} octets", given->text, entry.length),
                  "its bytes are not interpreted");
    }
}

/// Reads the access type. An entry with rwr or rww can be read and written by SDO; PDOs may contain it in one direction
/// only: transmit for rwr, receive for rww (CiA 306).
void read_access(Entry& entry, const IniSection& section, const EntryKeys& keys, const EdsTelling& tell) {
    const IniValue* given = keys.access;
    std::string lower;  // remains empty for most sheets, which have the word in lower case already
    std::string_view word = given == nullptr ? std::string_view{} : given->text;
    if (std::any_of(word.begin(), word.end(), [](char c) { return c != lower_case(c); })) {
        lower = lower_case(word);
        word = lower;
    }
    if (word.empty() && entry.type == "DOMAIN") {
        entry.access = "rw";  // CiA 306 allows a DOMAIN without AccessType
        return;
    }
    static constexpr std::array<std::string_view, 6> known{"ro", "wo", "rw", "rwr", "rww", "const"};
    if (std::find(known.begin(), known.end(), word) != known.end()) {
        entry.access = word.substr(0, word.size() == 3 ? 2 : word.size());  // rwr and rww become rw
    }
    if (entry.access.empty()) {
        entry.access = "rw";
        tell.note(given == nullptr ? section.line : given->line,
                  given == nullptr ? fmt::format("[{}] has no AccessType", section.name)
                                   : fmt::format("AccessType {} is unknown", given->text),
                  "rw is assumed");
    }
    const IniValue* mapping = keys.mapping;
    const auto mapped = mapping == nullptr ? std::optional<std::uint64_t>{0} : eds_unsigned(mapping->text);
    if (!mapped || *mapped > 1U) {
        tell.note(mapping->line, fmt::format("PDOMapping {} is neither 0 nor 1", mapping->text),
                  fmt::format("{} is assumed", mapped ? 1 : 0));
    }
    if (mapped.value_or(0U) != 0U) {
        const bool both = std::string_view{entry.access} == "rw" && word != "rwr" && word != "rww";
        entry.mapping = both ? "both" : word == "wo" || word == "rww" ? "rpdo" : "tpdo";
    }
}

/// Reads a limit of an entry. Ignores the limit if `kept` is false: the firmware then cannot compare values of this
/// type.
void read_limit(Limit& limit, const Entry& entry, bool kept, const IniValue* given, const char* key,
                const EdsTelling& tell) {
    if (given == nullptr) {
        return;
    }
    const auto value = kept ? eds_value(given->text, entry.type) : std::nullopt;
    if (!kept) {
        tell.note(given->line, fmt::format("{} of an entry of type {} is ignored", key, entry.type),
                  "every value of the type is accepted");
    } else if (!value) {
        tell.note(given->line, fmt::format("{} {} is no value of type {}", key, given->text, entry.type),
                  "the type alone limits the value");
    } else {
        limit.kind = Limit::Kind::number;
        limit.number = *value;
        set_place(limit.place, tell, given->line);
    }
}

void read_limits(Entry& entry, const IniSection& section, const EntryKeys& keys, const EdsTelling& tell) {
    Range& range = entry.range;
    const std::size_t size = type_size(entry.type);
    const bool kept = size > 0 && size <= 4;
    read_limit(range.minimum, entry, kept, keys.low_limit, "LowLimit", tell);
    read_limit(range.maximum, entry, kept, keys.high_limit, "HighLimit", tell);
    set_place(range.place, tell, section.line);
    const auto low = number_of(range.minimum.number);
    const auto high = number_of(range.maximum.number);
    if (low && high && *low > *high) {
        tell.note(range.minimum.place.line,
                  fmt::format("LowLimit {} is above HighLimit {}", to_text(range.minimum.number),
                              to_text(range.maximum.number)),
                  "the type alone limits the value");
        range.minimum = Limit{};
        range.maximum = Limit{};
        return;
    }
    const auto value = entry.node_id ? std::nullopt : number_of(entry.value);
    if (value && ((low && *value < *low) || (high && *value > *high))) {
        tell.note(entry.default_place.line, fmt::format("value {} is outside its limits", to_text(entry.value)),
                  "the device starts with this value, but refuses a write of it");
    }
}

bool is_integer(const std::string& type) {
    return type != "BOOLEAN" && integer_limits(type).has_value();
}

void set_empty_value(Entry& entry) {
    const std::string_view type{entry.type};
    if (is_string_type(entry.type)) {
        entry.value = std::string{};
    } else if (type == "BOOLEAN") {
        entry.value = false;
    } else if (is_real_type(entry.type)) {
        entry.value = 0.0;
    } else if (type != "DOMAIN") {
        entry.value = std::int64_t{0};
    }
}

void set_string(Entry& entry, const IniValue& given, const EdsTelling& tell) {
    const auto octets = entry.type == "OCTET_STRING" ? eds_octets(given.text) : std::nullopt;
    std::string text = octets ? *octets : std::string{given.text};
    if (text.size() > longest_string) {
        tell.note(given.line, fmt::format("the text has {} characters", text.size()),
                  fmt::format("the first {} are used", longest_string));
        text.resize(longest_string);
    }
    entry.value = text;
}

void set_length(Entry& entry) {
    if (!is_string_type(entry.type)) {
        return;
    }
    const std::size_t used = std::get<std::string>(entry.value).size();
    const bool written = entry.access == "rw" || entry.access == "wo";
    const std::size_t room = entry.length != 0 ? entry.length : written ? string_room : 1U;
    entry.length = std::max(used, room);
}

}  // namespace

void set_eds_value(Entry& entry, const IniValue& given, const EdsTelling& tell) {
    entry.default_place.line = given.line;  // the default is in the same file as the entry, so only the line changes
    const std::string_view type{entry.type};
    if (type == "DOMAIN") {
        return;
    }
    if (is_string_type(entry.type)) {
        set_string(entry, given, tell);
        return;
    }
    // most values have no node-ID; a copy of their text is not necessary
    const bool may_have_node_id = given.text.find('$') != std::string_view::npos;
    const auto term = may_have_node_id ? split_node_id(given.text) : std::nullopt;
    const bool has_node_id = term && term->has_node_id;
    const auto value = !may_have_node_id ? eds_value(given.text, entry.type)
                       : term            ? eds_value(term->rest, entry.type)
                                         : std::nullopt;
    if (!value || (has_node_id && !is_integer(entry.type))) {
        tell.note(given.line, fmt::format("value {} is not of type {}", given.text, entry.type),
                  fmt::format("{} is assumed", to_text(entry.value)));
        return;
    }
    entry.value = *value;
    entry.node_id = has_node_id;
}

void read_eds_entry(Entry& entry, const IniSection& section, std::uint8_t subindex, bool is_counter,
                    const EdsTelling& tell) {
    entry.subindex = subindex;
    set_place(entry.place, tell, section.line);
    set_place(entry.default_place, tell, section.line);
    const EntryKeys keys = keys_of(section);
    entry.name = keys.name == nullptr ? section.name : keys.name->text;
    read_type(entry, section, keys, is_counter, tell);
    read_access(entry, section, keys, tell);
    set_empty_value(entry);
    const IniValue* value = keys.configured_value != nullptr ? keys.configured_value : keys.standard_value;
    if (value != nullptr) {
        set_eds_value(entry, *value, tell);
    }
    read_limits(entry, section, keys, tell);
    set_length(entry);
}

}  // namespace canproof::host
