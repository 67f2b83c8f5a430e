// A data sheet as the checks see it: its lines as they stand, its sections, and its objects with their entries.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/datasheet/check/eds_types.hpp"
#include "host/datasheet/ini.hpp"

namespace canproof::host {

struct EdsLine {
    /// empty: a comment as well, and what read_ini() passes over: control characters, too long a line.
    enum class Kind { empty, section, value, strange };
    Kind kind{Kind::empty};
    std::string text;    ///< as it stands, without its end
    std::string name;    ///< of the section, or the key, as written
    std::string behind;  ///< behind the section, or the value
    bool crlf{false};    ///< ends with CR LF
};

/// A number of the sheet: its value, or the sum of it and the node-ID.
struct EdsNumber {
    std::uint64_t bits{0};
    bool node_id{false};
};

/// One entry of the dictionary.
struct EdsSheetEntry {
    std::uint16_t index{0};
    std::uint8_t sub{0};
    const IniSection* section{nullptr};  ///< describes it
    const IniValue* value{nullptr};      ///< its default; nullptr: it has none
    const EdsDataType* type{nullptr};    ///< nullptr: it is missing or unknown
    std::string access;                  ///< in lower case; empty: none is given
    bool mappable{false};                ///< PDOMapping is not 0
    bool compact{false};                 ///< described by CompactSubObj

    /// Default of an entry that holds an unsigned number.
    std::optional<EdsNumber> number() const;
    /// Line of a key, or of the section when it lacks the key.
    unsigned line_of(const char* key) const;
    /// Line of the default, or of the section.
    unsigned value_line() const { return value == nullptr ? section->line : value->line; }
    /// `1018h` or `1018h:01`.
    std::string title() const;
    bool is_single{false};  ///< it is the whole object
};

struct EdsSheetObject {
    std::uint16_t index{0};
    const IniSection* section{nullptr};              ///< nullptr: sub-sections alone describe it
    std::optional<std::uint64_t> code{7};            ///< ObjectType; nothing when it is no number
    std::uint64_t compact{0};                        ///< CompactSubObj
    std::map<std::uint8_t, const IniSection*> subs;  ///< [XXXXsubY]
    std::vector<EdsSheetEntry> entries;              ///< ascending by sub-index

    bool is_single() const { return code == std::uint64_t{7} || code == std::uint64_t{2}; }
    bool is_several() const { return code == std::uint64_t{8} || code == std::uint64_t{9}; }
    /// Line of its section, or of the first sub-section.
    unsigned line() const;
    /// nullptr when there is none.
    const EdsSheetEntry* entry(unsigned sub) const;
    std::string title() const;
};

class EdsSheet {
  public:
    /// Throws InputError for a text that is no EDS at all.
    EdsSheet(std::string_view text, std::string_view name);
    EdsSheet(const EdsSheet&) = delete;
    EdsSheet& operator=(const EdsSheet&) = delete;

    const std::string& name() const { return name_; }
    bool is_dcf() const { return is_dcf_; }
    const std::vector<EdsLine>& lines() const { return lines_; }
    bool has_byte_order_mark() const { return marked_; }
    const IniFile& ini() const { return ini_; }
    const IniSection* section(const char* name) const { return ini_.find(name); }
    const std::map<std::uint16_t, EdsSheetObject>& objects() const { return objects_; }
    const EdsSheetObject* object(unsigned index) const;
    const EdsSheetEntry* entry(unsigned index, unsigned sub) const;
    /// Line of a key of a section that is there.
    const EdsLine& line(unsigned number) const { return lines_[number - 1]; }

  private:
    void read_lines(std::string_view text);
    void find_objects();
    void add_entries(EdsSheetObject& object);

    std::string name_;
    bool is_dcf_{false};
    bool marked_{false};
    std::vector<EdsLine> lines_;
    IniFile ini_;
    std::map<std::uint16_t, EdsSheetObject> objects_;
    std::size_t entries_{0};
};

/// What a section's name describes: [1018], [1018sub1], [1018Name], [1018Value]. Nothing for any other name.
struct EdsObjectName {
    enum class Kind { object, sub, name, value } kind{Kind::object};
    std::uint16_t index{0};
    std::uint8_t sub{0};
};
std::optional<EdsObjectName> eds_object_name(const std::string& section);

/// `1018h`.
std::string eds_index_text(unsigned index);

}  // namespace canproof::host
