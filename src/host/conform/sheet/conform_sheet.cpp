// SPDX-License-Identifier: Apache-2.0
#include "host/conform/sheet/conform_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/cia301.hpp"
#include "host/base/input_error.hpp"
#include "host/base/sha256.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/datasheet/write_eds.hpp"

namespace canproof::host::conform {

namespace {

constexpr unsigned pdos_of_a_kind = 0x200U;

std::string faults_text(const Faults& faults) {
    std::string text;
    for (const Fault& one : faults) {
        text += one.text() + "\n";
    }
    return text;
}

std::optional<std::int64_t> number_of(const Limit& limit) {
    const auto* number = std::get_if<std::int64_t>(&limit.number);
    return limit.kind == Limit::Kind::number && number != nullptr ? std::optional{*number} : std::nullopt;
}

}  // namespace

const Object* ConformSheet::object(std::uint16_t index) const {
    const auto found = std::find_if(part.objects.begin(), part.objects.end(),
                                    [index](const Object& one) { return one.index == index; });
    return found == part.objects.end() ? nullptr : &*found;
}

SheetEntry ConformSheet::find(std::uint16_t index, std::uint8_t subindex) const {
    const Object* const holder = object(index);
    if (holder == nullptr) {
        return {};
    }
    const auto found = std::find_if(holder->entries.begin(), holder->entries.end(),
                                    [subindex](const Entry& one) { return one.subindex == subindex; });
    return found == holder->entries.end() ? SheetEntry{} : SheetEntry{holder, &*found};
}

std::vector<unsigned> ConformSheet::pdos(bool transmit) const {
    const unsigned first = transmit ? cia301::tpdo_communication : cia301::rpdo_communication;
    std::vector<unsigned> all;
    for (const Object& one : part.objects) {
        if (one.index >= first && one.index < first + pdos_of_a_kind) {
            all.push_back(one.index - first + 1U);
        }
    }
    return all;
}

std::optional<std::string> ConformSheet::key(const std::string& section, const std::string& key) const {
    const IniSection* const found = ini.find(section);
    const IniValue* const value = found == nullptr ? nullptr : found->find(key);
    return value == nullptr ? std::nullopt : std::optional{std::string{value->text}};
}

ConformSheet read_sheet(const std::string& text, const std::string& name, std::uint8_t node_id) {
    EdsResult read = read_eds(text, name);
    if (!read.faults.empty()) {
        throw InputError{fmt::format("{} is no valid data sheet:\n{}", name, faults_text(read.faults))};
    }
    ConformSheet sheet;
    sheet.name = name;
    sheet.text = text;
    sheet.checksum = sha256(text);
    sheet.part = std::move(read.part);
    sheet.notes = faults_text(read.notes);
    sheet.node_id = node_id;
    Faults faults;
    Faults notes;
    if (text.find("<?xml") == std::string::npos) {
        sheet.ini = read_ini(text, EdsTelling{name, faults, notes});
    }
    return sheet;
}

ConformSheet sheet_of(const Register& content, const Part& part) {
    return read_sheet(write_eds(content, part, Reals::decimal), part.name + ".eds",
                      static_cast<std::uint8_t>(part.info.node_id));
}

ConformSheet sheet_of(const Part& part) {
    Register alone;
    Manual manual;  // write_eds() takes the date of the manual, because CiA 306 requires a date in an EDS
    manual.key = part.info.manual;
    manual.title = part.info.title;
    manual.revision = "1";
    manual.date = "2000-01-01";
    alone.manuals.push_back(manual);
    alone.parts.push_back(part);
    return sheet_of(alone, part);
}

std::size_t entry_size(const Entry& entry) {
    const std::size_t fixed = type_size(entry.type);
    if (fixed != 0) {
        return fixed;
    }
    const auto* text = std::get_if<std::string>(&entry.value);
    return std::max(entry.length, text == nullptr ? std::size_t{0} : text->size());
}

bool is_readable(const Entry& entry) {
    return entry.access != "wo";
}

bool is_writable(const Entry& entry) {
    return entry.access == "rw" || entry.access == "wo";
}

std::optional<std::int64_t> highest_of(const Entry& entry) {
    const auto limits = integer_limits(entry.type);
    if (const auto given = number_of(entry.range.maximum)) {
        return given;
    }
    return limits ? std::optional{limits->second} : std::nullopt;
}

std::optional<std::int64_t> lowest_of(const Entry& entry) {
    const auto limits = integer_limits(entry.type);
    if (const auto given = number_of(entry.range.minimum)) {
        return given;
    }
    return limits ? std::optional{limits->first} : std::nullopt;
}

std::string entry_words(const SheetEntry& one) {
    return fmt::format("{:04X}h sub {:02X}h ({})", one.object->index, one.entry->subindex, one.entry->name);
}

}  // namespace canproof::host::conform
