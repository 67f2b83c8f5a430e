// SPDX-License-Identifier: Apache-2.0
// The requirements register in memory: the content of spec/, in which each family and array is expanded to single
// objects and entries. spec/README.md describes the grammar.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "host/register/fault.hpp"
#include "host/register/statement.hpp"

namespace canproof::host {

/// A literal of the register; monostate means that there is none.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string>;
std::string to_text(const Value& value);

/// The fields that every item of the register has.
struct Item {
    std::string id;
    std::string text;
    std::vector<std::string> sources;
    std::string derived;  ///< reason for an item that no sentence of a manual demands; empty: the item has a source
    Place place;
    Place id_place;      ///< place of `id`, or of an object's `index`
    Place source_place;  ///< place of `source`, or of `derived`
};
/// Returns the sources of the item. For a derived item, also returns `derived: …` with the reason.
std::vector<std::string> origins(const Item& item);

struct Section {
    std::string ref;
    std::string title;
    bool normative{false};
    std::string reason;
    std::vector<std::string> objects;
    std::vector<std::string> conditions;  ///< conditions that installers and operators must meet, one sentence each
    Place place;

    bool is_condition_of_use() const { return !normative && reason.empty(); }
    /// Returns the id of the section, such as `AX188001:3.2.8`. `key` is the key of the manual.
    std::string id(const std::string& key) const { return key + ":" + ref; }
};

struct Manual {
    std::string key;
    std::string title;
    std::string publisher;
    std::string revision;
    std::string date;
    std::vector<Section> sections;
    Place place;
    /// statements of all sections; if there are none, the audit counts covered sections instead of covered statements
    std::vector<Statement> statements{};

    /// Returns the section, table or figure with this name, or the section that describes the object with this name;
    /// nullptr when there is none.
    const Section* describing(const std::string& ref) const;
};

/// The answer of an item to a topic, that is, to a question that other items answer as well. An answer without a topic
/// is not compared.
struct Answer {
    std::string topic;      ///< name of the question, for example heartbeat.consumer-range
    std::string choice;     ///< the answer, as one word
    std::string differs;    ///< reason for a difference from another device of the same manufacturer
    std::string overrides;  ///< reason for a difference from a shared item
    Place place;            ///< place of `topic`
};

struct Requirement : Item {
    std::string kind;
    std::vector<std::string> verify;
    std::string retired;
    std::string by;  ///< id of the shared requirement whose code implements this one; empty: the device has its own
                     ///< code
    Place by_place;
    Answer answer;
};

/// The minimum or maximum of a range.
struct Limit {
    enum class Kind { none, number, object } kind{Kind::none};
    Value number;
    std::uint16_t index{0};
    int subindex{-1};  ///< -1: the same sub-index as the entry that has the limit
    std::int64_t add{0};
    Place place;
};

struct Range {
    Limit minimum;
    Limit maximum;
    std::vector<Value> values;  ///< allowed values, from `values` or, after resolve_ranges(), from `table`
    std::string table;
    bool zero{false};  ///< whether 0 is allowed in addition to the range
    Place place;
    bool empty() const {
        return minimum.kind == Limit::Kind::none && maximum.kind == Limit::Kind::none && values.empty() &&
               table.empty();
    }
};

struct Entry {
    std::uint8_t subindex{0};
    std::string name;
    std::string type;  ///< CiA type such as UNSIGNED16
    std::string access;
    Value value;  ///< default; if `node_id` is true, the node-ID is added to it
    bool node_id{false};
    Range range;
    std::string mapping{"none"};
    bool stored{false};
    std::string service{"none"};
    std::size_t length{0};  ///< length of a string in bytes
    bool factory{false};
    bool live{false};
    Place place;
    /// place of `default`, or of this entry's value in a list of defaults; without a default, equal to `place`
    Place default_place;
};

struct Object : Item {
    std::uint16_t index{0};
    std::string name;
    std::string family;  ///< name of the family with {n} in place of the number; empty: no family
    int member{0};       ///< number of the object in its family
    enum class Kind { var = 7, array = 8, record = 9 } kind{Kind::var};
    /// whether `array = N` defines the entries, so that they have one type and are one array in the firmware
    bool alike{false};
    std::string unit;
    std::vector<Entry> entries;
};

struct Column {
    std::string name;
    std::string enumeration;
    std::string type;  ///< type of an output column; empty: inferred from the values
    std::string unit;
    std::optional<std::int64_t> minimum;
    std::optional<std::int64_t> maximum;
    std::vector<std::string> words;  ///< allowed words, if the cells of the column are words
    Place place;
    enum class Kind { words, integers, booleans, reals } kind{Kind::words};
};

/// The content of one cell in a row. It is a list of alternatives, each of which is a literal or an inclusive range. An
/// empty list means "any".
struct Cell {
    struct Part {
        Value first;
        Value last;
        bool hexadecimal{false};  ///< whether spec/ contains the value as a hexadecimal number
    };
    std::vector<Part> parts;
    bool any() const { return parts.empty(); }
};

struct Table : Item {
    /// name of its C++ namespace: `name`, or the title in snake_case up to the first of the characters `,:;(`
    std::string name;
    std::string errors;  ///< name of the input column whose words are errors of the node; empty: none
    std::vector<Column> inputs;
    std::vector<Column> outputs;
    struct Row {
        std::vector<Cell> cells;
        Place place;
    };
    std::vector<Row> rows;
    bool complete{true};  ///< whether all rows could be read; if not, gaps in the table are not checked
};

struct Enumeration : Item {
    std::string name;
    std::vector<std::pair<std::string, std::int64_t>> values;
    bool hexadecimal{false};  ///< whether spec/ writes at least one number of `values` in hexadecimal
};

struct Constant : Item {
    std::string name;
    std::string type;
    std::string unit;
    Value value;
    bool hexadecimal{false};  ///< whether spec/ contains the value in hexadecimal
    /// whether the firmware needs the constant at compile time, for example as the size of an array
    bool compiled_in{false};
    Place value_place;
};

struct Signal : Item {
    std::string name;  ///< name of the signal; may contain {n}
    int count{1};
    bool input{false};
    std::string type;
    std::string unit;
    std::optional<double> minimum;
    std::optional<double> maximum;
    Value value;
    Place default_place;
    /// Returns the name of each single signal: aout1, aout2 …
    std::vector<std::string> names() const;
};

struct Decision : Item {
    struct Reading {
        std::string says;
        std::string source;
        Place place;
    };
    std::vector<Reading> readings;
    std::string chosen;
    std::string because;
    std::vector<std::string> affects;
    Place affects_place;
    std::string none;
    std::string severity;
    std::string ref;
    Answer answer;
};

/// Harm that outputs or messages of a device can cause, and its prevention.
struct Hazard : Item {
    struct Failure {
        std::string text;
        std::vector<std::string> prevented_by;  ///< ids of the requirements that prevent the failure
        std::string reason;                     ///< reason why nothing prevents the failure; empty when something does
        Place place;
    };
    std::vector<std::string> at;  ///< signals and objects: the outputs and messages that the hazard concerns
    Place at_place;
    std::string safe_state;
    std::vector<Failure> failures;
    std::vector<std::string> decisions;  ///< ids of the decisions that chose a behaviour to reduce this hazard
    Place decisions_place;
};

/// The review of an item with its code and tests, or of the classification of a manual's section.
struct Review {
    std::string fingerprint;  ///< fingerprint of the item when it was reviewed
    std::string code;         ///< hash of the functions that implemented the item; empty: there were none
    std::string tests;        ///< hash of the tests that verified the item; empty: there were none
    std::string date;         ///< YYYY-MM-DD
    std::string by;
    std::string role;  ///< author or independent; empty: not recorded
    /// date on which the hashes of code and tests were renewed without a reader; empty: a reader has read code and
    /// tests
    std::string marked;
    Place place;
};

/// The content of device.toml; empty for the shared rules (spec/canopen).
struct DeviceInfo {
    std::string title;
    std::string vendor;
    std::string manual;
    std::vector<std::string> part_numbers;
    /// differences between the part numbers, such as `AX130771: CAN and outputs isolated`
    std::vector<std::string> variants;
    int node_id{0};
    std::string node_id_note;
    std::int64_t bit_rate{0};
    std::vector<std::int64_t> bit_rates;
    std::vector<std::string> sources;
    Place source_place;
    Place manual_place;
    bool lss{false};
    std::string lss_bit_rates;  ///< id of the table with the columns index and bit_rate; empty: the table of CiA 305
    /// whether each change from the LSS configuration state to the waiting state resets the communication
    bool lss_reset{false};
    bool block_sdo{false};
    std::string limit_abort{"high_low"};
    std::string error_list{"history"};
    std::string emcy_content{"listed_errors"};
    std::string tpdo_trigger{"value_change"};
    std::vector<std::int64_t> rpdos_answering_remote;  ///< numbers, from 1, of the RPDOs that answer a remote frame
    bool saves_in_pre_operational_only{false};
    Place services_place;
    Place place;
};

/// A standard object of CiA with its name in shared code. Only the shared rules (spec/canopen) have such objects.
struct StandardObject {
    std::uint16_t index{0};
    std::string name;
    Place place;
};

/// The items of one folder: a device, or spec/canopen (name "canopen").
struct Part {
    std::string name;
    std::string prefix;
    DeviceInfo info;
    bool has_device_file{false};
    std::vector<Requirement> requirements;
    std::vector<Object> objects;  ///< in ascending order of the index
    std::vector<Table> tables;
    std::vector<Enumeration> enumerations;
    std::vector<Constant> constants;
    std::vector<Signal> signals;
    std::vector<Decision> decisions;
    std::vector<Hazard> hazards;
    std::vector<StandardObject> standard_objects;  ///< in the order of spec/
    std::map<std::string, Review> reviews;         ///< reviews by the id of the item or section
    /// earlier reviews by independent readers, of items whose review in `reviews` is the author's
    std::map<std::string, Review> independent_reviews;
    std::vector<std::string> files;
    /// whether these are shared rules of an installed canproof, which canproof's own project tests
    bool inherited{false};

    /// Returns the name of the part in C++: cbx_ao412 for `cbx-ao412`.
    std::string cpp_name() const;
    bool is_device() const { return name != "canopen"; }
};

struct Register {
    std::vector<Manual> manuals;
    std::vector<Part> parts;  ///< the shared rules (`canopen`) first, then the devices by name

    const Part* part(const std::string& name) const;
    const Manual* manual(const std::string& key) const;
    /// Returns the enumeration with this id from `part` or from the shared rules; nullptr when there is none.
    const Enumeration* enumeration(const Part& part, const std::string& id) const;
    /// Calls visit(item, word) for each requirement, object, table, enumeration, constant and signal of `part`. `word`
    /// is the kind of the item: "requirement", "object" …
    template <typename Visit>
    void for_each_item(const Part& part, const Visit& visit) const {
        for (const auto& item : part.requirements)
            visit(static_cast<const Item&>(item), "requirement");
        for (const auto& item : part.objects)
            visit(static_cast<const Item&>(item), "object");
        for (const auto& item : part.tables)
            visit(static_cast<const Item&>(item), "table");
        for (const auto& item : part.enumerations)
            visit(static_cast<const Item&>(item), "enumeration");
        for (const auto& item : part.constants)
            visit(static_cast<const Item&>(item), "constant");
        for (const auto& item : part.signals)
            visit(static_cast<const Item&>(item), "signal");
    }
};

/// Returns the size of a CiA type in bytes; 0 for strings, domains and unknown types.
std::size_t type_size(const std::string& type);
/// Returns the smallest and the largest value of an integer type or of BOOLEAN; nothing for any other type. The largest
/// value of UNSIGNED64 is INT64_MAX here.
std::optional<std::pair<std::int64_t, std::int64_t>> integer_limits(const std::string& type);
bool is_string_type(const std::string& type);
bool is_known_type(const std::string& type);

/// Returns the text in snake_case: `ao_cbx_error_mode_2` for `AO CBX-Error mode 2`. pascal_case() returns it in
/// PascalCase, for types.
std::string snake_case(const std::string& text);
std::string pascal_case(const std::string& text);

}  // namespace canproof::host
