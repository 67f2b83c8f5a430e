// SPDX-License-Identifier: Apache-2.0
// A data sheet as the checks use it: its lines as written, its sections, and its objects with their entries.
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
    /// `empty` also includes comments, and lines that read_ini() ignores because they contain control characters or are
    /// too long.
    enum class Kind { empty, section, value, strange };
    Kind kind{Kind::empty};
    std::string text;    ///< text as written, without its line break
    std::string name;    ///< name of the section, or the key, as written
    std::string behind;  ///< text after the section's name, or the value
    bool crlf{false};    ///< whether the line ends with CR LF
};

/// A number of the sheet: a value, or the sum of a value and the node-ID.
struct EdsNumber {
    std::uint64_t bits{0};
    bool node_id{false};
};

/// One entry of the dictionary.
struct EdsSheetEntry {
    std::uint16_t index{0};
    std::uint8_t sub{0};
    const IniSection* section{nullptr};  ///< section that describes the entry
    const IniValue* value{nullptr};      ///< default of the entry; nullptr: none
    const EdsDataType* type{nullptr};    ///< data type; nullptr: DataType is missing or unknown
    std::string access;                  ///< access type in lower case; empty: missing
    bool mappable{false};                ///< whether PDOMapping is a number other than 0
    bool compact{false};                 ///< whether CompactSubObj describes the entry

    /// Returns the default if it is an unsigned number, also with `$NODEID`; nothing for any other default.
    std::optional<EdsNumber> number() const;
    /// Returns the line of a key; without the key, the line of the section.
    unsigned line_of(const char* key) const;
    /// Returns the line of the default; without a default, the line of the section.
    unsigned value_line() const { return value == nullptr ? section->line : value->line; }
    /// Returns the entry as text: `1018h` or `1018h:01`.
    std::string title() const;
    bool is_single{false};  ///< whether the entry is the whole object (no sub-index)
};

struct EdsSheetObject {
    std::uint16_t index{0};
    const IniSection* section{nullptr};    ///< section of the object; nullptr: only sections of sub-indices describe it
    std::optional<std::uint64_t> code{7};  ///< ObjectType, 7 when it is missing; nothing when it is not a number
    std::uint64_t compact{0};              ///< value of CompactSubObj
    std::map<std::uint8_t, const IniSection*> subs;  ///< sections [XXXXsubY] by sub-index
    std::vector<EdsSheetEntry> entries;              ///< ascending by sub-index

    bool is_single() const { return code == std::uint64_t{7} || code == std::uint64_t{2}; }
    bool is_several() const { return code == std::uint64_t{8} || code == std::uint64_t{9}; }
    /// Returns the line of the object's section; without one, the line of its first sub-section.
    unsigned line() const;
    /// Returns the entry with this sub-index; nullptr when there is none.
    const EdsSheetEntry* entry(unsigned sub) const;
    std::string title() const;
};

class EdsSheet {
  public:
    /// Parses the text. Throws InputError for a text that is no EDS.
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
    /// Returns the line with this number, which counts from 1.
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

/// The meaning of a section's name such as [1018], [1018sub1], [1018Name] or [1018Value].
struct EdsObjectName {
    enum class Kind { object, sub, name, value } kind{Kind::object};
    std::uint16_t index{0};
    std::uint8_t sub{0};
};
std::optional<EdsObjectName> eds_object_name(const std::string& section);

/// Returns an index as text: `1018h`.
std::string eds_index_text(unsigned index);

}  // namespace canproof::host
