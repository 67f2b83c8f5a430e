// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/check/eds_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/input_error.hpp"
#include "host/base/trimmed.hpp"
#include "host/datasheet/eds_numbers.hpp"
#include "host/datasheet/read_xdd.hpp"

namespace canproof::host {

namespace {

constexpr unsigned highest_subindex = 0xFE;
/// Greatest number of entries that are read from a sheet and checked. A dictionary of the firmware cannot contain more.
constexpr std::size_t most_entries = 0x10000;
/// Greatest number of lines; a full dictionary needs fewer.
constexpr std::size_t most_lines = 1000000;

EdsLine read_line(std::string_view raw) {
    EdsLine line;
    line.crlf = !raw.empty() && raw.back() == '\r';
    line.text = std::string{line.crlf ? raw.substr(0, raw.size() - 1) : raw};
    const std::string text = trimmed(raw, ini_blanks);
    const bool has_control = std::any_of(text.begin(), text.end(),
                                         [](char c) { return static_cast<unsigned char>(c) < 0x20U && c != '\t'; });
    if (text.empty() || text.front() == ';' || text.front() == '#' || has_control || raw.size() > longest_ini_line) {
        return line;
    }
    const auto cut = text.find(text.front() == '[' ? ']' : '=');
    const bool is_section = text.front() == '[';
    line.name = trimmed(text.substr(is_section ? 1 : 0, cut == std::string::npos ? cut : cut - (is_section ? 1 : 0)),
                        ini_blanks);
    line.behind = cut == std::string::npos ? "" : trimmed(text.substr(cut + 1), ini_blanks);
    line.kind = cut == std::string::npos || line.name.empty() ? EdsLine::Kind::strange
                : is_section                                  ? EdsLine::Kind::section
                                                              : EdsLine::Kind::value;
    return line;
}

std::optional<unsigned> hex_number(const std::string& digits, std::size_t most) {
    const bool is_number =
        !digits.empty() && digits.size() <= most && digits.find_first_not_of("0123456789abcdef") == std::string::npos;
    return is_number ? std::optional{static_cast<unsigned>(eds_unsigned("0x" + digits).value_or(0))} : std::nullopt;
}

}  // namespace

std::optional<EdsNumber> EdsSheetEntry::number() const {
    const auto term = value == nullptr ? std::nullopt : split_node_id(value->text);
    const auto bits = term ? eds_unsigned(term->rest) : std::nullopt;
    return bits ? std::optional{EdsNumber{*bits, term->has_node_id}} : std::nullopt;
}

unsigned EdsSheetEntry::line_of(const char* key) const {
    const IniValue* found = section->find(key);
    return found == nullptr ? section->line : found->line;
}

std::string EdsSheetEntry::title() const {
    return is_single ? eds_index_text(index) : fmt::format("{:04X}h:{:02X}", index, sub);
}

unsigned EdsSheetObject::line() const {
    return section != nullptr ? section->line : subs.empty() ? 1U : subs.begin()->second->line;
}

const EdsSheetEntry* EdsSheetObject::entry(unsigned sub) const {
    const auto found = std::lower_bound(entries.begin(), entries.end(), sub,
                                        [](const EdsSheetEntry& one, unsigned s) { return one.sub < s; });
    return found == entries.end() || found->sub != sub ? nullptr : &*found;
}

std::string EdsSheetObject::title() const {
    return eds_index_text(index);
}

std::string eds_index_text(unsigned index) {
    return fmt::format("{:04X}h", index);
}

std::optional<EdsObjectName> eds_object_name(const std::string& section) {
    using Kind = EdsObjectName::Kind;
    const std::string name = lower_case(section);
    const auto index = hex_number(name.substr(0, 4), 4);
    if (!index || name.size() < 4) {
        return std::nullopt;
    }
    const auto number = static_cast<std::uint16_t>(*index);
    const std::string rest = name.substr(4);
    if (rest.empty()) {
        return EdsObjectName{Kind::object, number, 0};
    }
    if (rest == "name" || rest == "value") {
        return EdsObjectName{rest == "name" ? Kind::name : Kind::value, number, 0};
    }
    const auto sub = rest.rfind("sub", 0) == 0 ? hex_number(rest.substr(3), 3) : std::nullopt;
    return sub && *sub <= highest_subindex
               ? std::optional{EdsObjectName{Kind::sub, number, static_cast<std::uint8_t>(*sub)}}
               : std::nullopt;
}

EdsSheet::EdsSheet(std::string_view text, std::string_view name) : name_{name} {
    if (is_xml(std::string{text})) {
        throw InputError{fmt::format("{} is XML, which this command does not check; name an EDS or DCF file",
                                     name_.empty() ? "the text" : name_)};
    }
    Faults faults;
    Faults notes;  // not used: the rules report the same faults in more detail
    ini_ = read_ini(std::string{text}, EdsTelling{name_, faults, notes});
    if (!faults.empty() || ini_.sections().empty()) {
        throw InputError{fmt::format("{} is no EDS: {}", name_.empty() ? "the text" : name_,
                                     faults.empty() ? "it has no section" : faults.front().what)};
    }
    read_lines(text);
    const std::string lower = lower_case(name_);
    is_dcf_ = (lower.size() > 4 && lower.compare(lower.size() - 4, 4, ".dcf") == 0) ||
              ((lower.size() <= 4 || lower.compare(lower.size() - 4, 4, ".eds") != 0) &&
               section("DeviceComissioning") != nullptr);
    find_objects();
}

void EdsSheet::read_lines(std::string_view text) {
    marked_ = text.rfind("\xEF\xBB\xBF", 0) == 0;  // UTF-8 byte order mark
    for (std::size_t at = marked_ ? 3 : 0; at < text.size();) {
        const auto end = std::min(text.find('\n', at), text.size());
        if (lines_.size() == most_lines) {
            throw InputError{
                fmt::format("{} is no EDS: it has more than {} lines", name_.empty() ? "the text" : name_, most_lines)};
        }
        lines_.push_back(read_line(text.substr(at, end - at)));
        at = end + 1;
    }
}

void EdsSheet::find_objects() {
    for (const auto& [name, section] : ini_.sections()) {
        const auto found = eds_object_name(name);
        if (!found) {
            continue;
        }
        if (found->kind == EdsObjectName::Kind::object) {
            EdsSheetObject& object = objects_[found->index];
            object.index = found->index;
            object.section = &section;
            const IniValue* type = section.filled("ObjectType");
            object.code = type == nullptr ? std::optional<std::uint64_t>{7} : eds_unsigned(type->text);
            const IniValue* compact = section.filled("CompactSubObj");
            const auto count = compact == nullptr ? std::nullopt : eds_unsigned(compact->text);
            object.compact = count && *count <= highest_subindex ? *count : 0;
        } else if (found->kind == EdsObjectName::Kind::sub) {
            EdsSheetObject& object = objects_[found->index];
            object.index = found->index;
            const IniSection*& place = object.subs[found->sub];
            place = place == nullptr || section.line < place->line ? &section : place;
        }
    }
    for (auto& [index, object] : objects_) {
        add_entries(object);
    }
}

void EdsSheet::add_entries(EdsSheetObject& object) {
    const auto add = [&](const IniSection& section, unsigned sub, bool is_single, bool compact) {
        if (++entries_ > most_entries) {
            return;
        }
        EdsSheetEntry entry;
        entry.index = object.index;
        entry.sub = static_cast<std::uint8_t>(sub);
        entry.section = &section;
        entry.is_single = is_single;
        entry.compact = compact;
        entry.value = section.filled("DefaultValue");
        const IniValue* type = section.filled("DataType");
        const auto number = type == nullptr ? std::nullopt : eds_unsigned(type->text);
        entry.type = number ? eds_data_type(*number) : nullptr;
        const IniValue* access = section.filled("AccessType");
        entry.access = access == nullptr ? "" : lower_case(access->text);
        const IniValue* mapping = section.filled("PDOMapping");
        entry.mappable = mapping != nullptr && eds_unsigned(mapping->text).value_or(0) != 0;
        object.entries.push_back(std::move(entry));
    };
    if (object.section != nullptr && object.subs.empty() && object.compact == 0) {
        if (!object.is_several()) {
            add(*object.section, 0, true, false);
        }
        return;
    }
    const IniSection* values = ini_.find(fmt::format("{:04X}Value", object.index));
    for (unsigned sub = 0; sub <= highest_subindex; ++sub) {
        const auto described = object.subs.find(static_cast<std::uint8_t>(sub));
        if (described != object.subs.end()) {
            add(*described->second, sub, false, false);
        } else if (sub != 0 && sub <= object.compact && object.section != nullptr) {
            add(*object.section, sub, false, true);
            const IniValue* own = values == nullptr ? nullptr : values->filled(std::to_string(sub));
            if (own != nullptr && !object.entries.empty() && object.entries.back().sub == sub) {
                object.entries.back().value = own;
            }
        }
    }
}

const EdsSheetObject* EdsSheet::object(unsigned index) const {
    const auto found = objects_.find(static_cast<std::uint16_t>(index));
    return found == objects_.end() ? nullptr : &found->second;
}

const EdsSheetEntry* EdsSheet::entry(unsigned index, unsigned sub) const {
    const EdsSheetObject* found = object(index);
    return found == nullptr ? nullptr : found->entry(sub);
}

}  // namespace canproof::host
