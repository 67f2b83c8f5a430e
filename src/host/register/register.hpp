// The register in memory: what spec/ says, families and arrays written out. Grammar: spec/README.md.
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

/// A literal of the register; monostate where none is given.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string>;
std::string to_text(const Value& value);

/// What every item of the register has.
struct Item {
    std::string id;
    std::string text;
    std::vector<std::string> sources;
    std::string derived;  ///< why the item stands without a manual's sentence; empty: a source says it
    Place place;
    Place id_place;      ///< of `id`, or of an object's `index`
    Place source_place;  ///< of `source`, or of `derived`
};
/// The sources, and `derived: …` with the reason where the item is derived.
std::vector<std::string> origins(const Item& item);

struct Section {
    std::string ref;
    std::string title;
    bool normative{false};
    std::string reason;
    std::vector<std::string> objects;
    std::vector<std::string> conditions;  ///< of use: what installer and operator must keep, each a sentence
    Place place;

    bool is_condition_of_use() const { return !normative && reason.empty(); }
};

struct Manual {
    std::string key;
    std::string title;
    std::string publisher;
    std::string revision;
    std::string date;
    std::vector<Section> sections;
    Place place;
    std::vector<Statement> statements{};  ///< of all sections; none: coverage of this manual counts by section

    /// The section, table or figure that is called so, or the section that describes this object; nullptr when there is
    /// none.
    const Section* describing(const std::string& ref) const;
};

/// What an item answers to a question that other items answer too. Without a topic it is compared with nothing.
struct Answer {
    std::string topic;      ///< the question: heartbeat.consumer-range
    std::string choice;     ///< the answer, one word
    std::string differs;    ///< why another device of the same maker answers otherwise
    std::string overrides;  ///< why a shared item answers otherwise
    Place place;            ///< of `topic`
};

struct Requirement : Item {
    std::string kind;
    std::vector<std::string> verify;
    std::string retired;
    std::string by;  ///< shared requirement whose code does it for this device; empty: code of the device does it
    Place by_place;
    Answer answer;
};

/// One end of a range.
struct Limit {
    enum class Kind { none, number, object } kind{Kind::none};
    Value number;
    std::uint16_t index{0};
    int subindex{-1};  ///< -1: the sub-index of the entry itself
    std::int64_t add{0};
    Place place;
};

struct Range {
    Limit minimum;
    Limit maximum;
    std::vector<Value> values;  ///< from `values` or, once resolved, from `table`
    std::string table;
    bool zero{false};  ///< 0 is allowed below the minimum
    Place place;
    bool empty() const {
        return minimum.kind == Limit::Kind::none && maximum.kind == Limit::Kind::none && values.empty() &&
               table.empty();
    }
};

struct Entry {
    std::uint8_t subindex{0};
    std::string name;
    std::string type;  ///< CiA word: UNSIGNED16 …
    std::string access;
    Value value;  ///< default; the base when node_id
    bool node_id{false};
    Range range;
    std::string mapping{"none"};
    bool stored{false};
    std::string service{"none"};
    std::size_t length{0};  ///< bytes of a string
    bool factory{false};
    bool live{false};
    Place place;
    Place default_place;  ///< of `default`, or of its element in a list; `place` where there is none
};

struct Object : Item {
    std::uint16_t index{0};
    std::string name;
    std::string family;  ///< the name with {n} of the family that it belongs to; empty: none
    int member{0};       ///< its n in the family
    enum class Kind { var = 7, array = 8, record = 9 } kind{Kind::var};
    bool alike{false};  ///< `array = N` wrote its entries: one type, one field of the firmware
    std::string unit;
    std::vector<Entry> entries;
};

struct Column {
    std::string name;
    std::string enumeration;
    std::string type;  ///< of an output; empty: inferred
    std::string unit;
    std::optional<std::int64_t> minimum;
    std::optional<std::int64_t> maximum;
    std::vector<std::string> words;  ///< domain of a column of words
    Place place;
    enum class Kind { words, integers, booleans, reals } kind{Kind::words};
};

/// What stands in one field of a row: alternatives, each a literal or an inclusive range; none at all means "any".
struct Cell {
    struct Part {
        Value first;
        Value last;
        bool hexadecimal{false};  ///< as spec/ writes it
    };
    std::vector<Part> parts;
    bool any() const { return parts.empty(); }
};

struct Table : Item {
    std::string name;    ///< of its C++ namespace: `name`, or the words of the title up to the first punctuation mark
    std::string errors;  ///< the column whose words are errors of the node; empty: none
    std::vector<Column> inputs;
    std::vector<Column> outputs;
    struct Row {
        std::vector<Cell> cells;
        Place place;
    };
    std::vector<Row> rows;
    bool complete{true};  ///< false when a row could not be read: gaps are not looked for
};

struct Enumeration : Item {
    std::string name;
    std::vector<std::pair<std::string, std::int64_t>> values;
    bool hexadecimal{false};  ///< as spec/ writes its numbers
};

struct Constant : Item {
    std::string name;
    std::string type;
    std::string unit;
    Value value;
    bool hexadecimal{false};  ///< as spec/ writes it
    bool compiled_in{false};  ///< the firmware needs it while it is compiled, as the size of an array is
    Place value_place;
};

struct Signal : Item {
    std::string name;  ///< may hold {n}
    int count{1};
    bool input{false};
    std::string type;
    std::string unit;
    std::optional<double> minimum;
    std::optional<double> maximum;
    Value value;
    Place default_place;
    /// Names of the single signals: aout1, aout2 …
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

/// A way in which what a device puts out can harm, and what prevents it.
struct Hazard : Item {
    struct Failure {
        std::string text;
        std::vector<std::string> prevented_by;  ///< requirements
        std::string reason;                     ///< why nothing prevents it; empty where something does
        Place place;
    };
    std::vector<std::string> at;  ///< signals and objects: outputs and messages
    Place at_place;
    std::string safe_state;
    std::vector<Failure> failures;
    std::vector<std::string> decisions;  ///< that chose the safer failure
    Place decisions_place;
};

/// Someone has read an item together with its code and tests.
struct Review {
    std::string fingerprint;  ///< of the item as it was then
    std::string code;         ///< mark of the functions that implemented it; empty: there were none
    std::string tests;        ///< mark of the tests that claimed it; empty: there were none
    std::string date;         ///< 2026-11-21
    std::string by;
    std::string role;    ///< author or independent; empty: nobody said
    std::string marked;  ///< date on which code and tests were marked and not read; empty: they were read
    Place place;
};

/// What a device says of itself; empty for the shared part.
struct DeviceInfo {
    std::string title;
    std::string vendor;
    std::string manual;
    std::vector<std::string> part_numbers;
    std::vector<std::string> variants;  ///< `AX130771: CAN and outputs isolated`: in what a part number differs
    int node_id{0};
    std::string node_id_note;
    std::int64_t bit_rate{0};
    std::vector<std::int64_t> bit_rates;
    std::vector<std::string> sources;
    Place source_place;
    Place manual_place;
    bool lss{false};
    std::string lss_bit_rates;  ///< id of the table with columns index and bit_rate; empty: the standard's
    bool lss_reset{false};      ///< communication is reset at each switch from LSS configuration to waiting
    bool block_sdo{false};
    std::string limit_abort{"high_low"};
    std::string error_list{"history"};
    std::string emcy_content{"listed_errors"};
    std::string tpdo_trigger{"value_change"};
    std::vector<std::int64_t> rpdos_answering_remote;  ///< from 1
    bool saves_in_pre_operational_only{false};
    Place services_place;
    Place place;
};

/// An object of the standard, by the name that shared code knows it by. Only the shared part has them.
struct StandardObject {
    std::uint16_t index{0};
    std::string name;
    Place place;
};

/// One folder of items: a device, or spec/canopen (name "canopen").
struct Part {
    std::string name;
    std::string prefix;
    DeviceInfo info;
    bool has_device_file{false};
    std::vector<Requirement> requirements;
    std::vector<Object> objects;  ///< ascending by index
    std::vector<Table> tables;
    std::vector<Enumeration> enumerations;
    std::vector<Constant> constants;
    std::vector<Signal> signals;
    std::vector<Decision> decisions;
    std::vector<Hazard> hazards;
    std::vector<StandardObject> standard_objects;  ///< as spec/ lists them
    std::map<std::string, Review> reviews;         ///< by id
    std::vector<std::string> files;
    bool inherited{false};  ///< the shared rules as they come with canproof: proven there, not in this project

    /// `cbx-ao412` as C++ spells it: cbx_ao412.
    std::string cpp_name() const;
    bool is_device() const { return name != "canopen"; }
};

struct Register {
    std::vector<Manual> manuals;
    std::vector<Part> parts;  ///< canopen first, then the devices by name

    const Part* part(const std::string& name) const;
    const Manual* manual(const std::string& key) const;
    /// An enumeration of `part` itself or of the shared part; nullptr when there is none.
    const Enumeration* enumeration(const Part& part, const std::string& id) const;
    /// Calls visit(item, word) for all items that have an id; `word` says what they are: "requirement", "object" …
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

/// Bytes of a fixed-size CiA type; 0 for strings, domains and unknown words.
std::size_t type_size(const std::string& type);
/// Smallest and largest value of an integer type (64-bit unsigned is cut at INT64_MAX).
std::optional<std::pair<std::int64_t, std::int64_t>> integer_limits(const std::string& type);
bool is_string_type(const std::string& type);
bool is_known_type(const std::string& type);

/// `AO CBX-Error mode 2` → `ao_cbx_error_mode_2`; PascalCase for types.
std::string snake_case(const std::string& text);
std::string pascal_case(const std::string& text);

}  // namespace canproof::host
