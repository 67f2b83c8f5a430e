// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/read_eds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <tuple>

#include "host/base/cia301.hpp"
#include "host/datasheet/eds_cob_ids.hpp"
#include "host/datasheet/eds_entry.hpp"
#include "host/datasheet/eds_numbers.hpp"
#include "host/datasheet/eds_services.hpp"
#include "host/datasheet/eds_sub_sections.hpp"
#include "host/datasheet/read_xdd.hpp"

namespace canproof::host {

namespace {

/// Greatest number of entries. The rows of the dictionary have 16 bits for the number of entries and for the position
/// of a value.
constexpr std::size_t most_entries = 0xFFFF;
constexpr std::size_t most_bytes = 0xFFFF;

std::string index_text(std::uint16_t index) {
    return fmt::format("{:04X}", index);
}

class EdsReader {
  public:
    EdsReader(const std::string& text, const std::string& name)
        : file_{name},
          tell_{file_, result_.faults, result_.notes},
          ini_{is_xml(text) ? read_xdd(text, tell_) : read_ini(text, tell_)} {}

    EdsResult read() {
        Part& part = result_.part;
        part.name = std::filesystem::path{file_}.stem().string();
        part.prefix = "EDS";
        part.has_device_file = true;
        if (!result_.faults.empty()) {
            return std::move(result_);
        }
        read_device_info();
        subs_ = find_sub_sections(ini_, tell_);
        for (const char* list : {"MandatoryObjects", "OptionalObjects", "ManufacturerObjects"}) {
            read_list(list);
        }
        read_unlisted();
        for (auto& [index, object] : objects_) {
            part.objects.push_back(std::move(object));
        }
        check_whole();
        read_commissioning();
        mend_cob_ids(part, tell_);
        assign_services(part);
        for (Faults* all : {&result_.faults, &result_.notes}) {
            std::sort(all->begin(), all->end(), [](const Fault& a, const Fault& b) {
                return std::tie(a.place.line, a.what) < std::tie(b.place.line, b.what);
            });
        }
        return std::move(result_);
    }

  private:
    std::string text_of(const IniSection* section, const char* key) const {
        const IniValue* value = section == nullptr ? nullptr : section->filled(key);
        return value == nullptr ? std::string{} : std::string{value->text};
    }

    bool flag_of(const IniSection* section, const char* key) const {
        const IniValue* value = section == nullptr ? nullptr : section->filled(key);
        const auto number = value == nullptr ? std::optional<std::uint64_t>{0} : eds_unsigned(value->text);
        if (!number || *number > 1U) {
            tell_.note(value->line, fmt::format("{} {} is neither 0 nor 1", key, value->text),
                       fmt::format("{} is assumed", number ? 1 : 0));
        }
        return number.value_or(0U) != 0U;
    }

    void read_device_info() {
        constexpr std::array<int, 8> rates{10, 20, 50, 125, 250, 500, 800, 1000};
        const IniSection* section = ini_.find("DeviceInfo");
        if (section == nullptr) {
            tell_.note(1, "there is no section [DeviceInfo]", "name, bit rates and LSS are taken as missing");
        }
        DeviceInfo& info = result_.part.info;
        info.title = text_of(section, "ProductName");
        info.vendor = text_of(section, "VendorName");
        const std::string order = text_of(section, "OrderCode");
        if (!order.empty()) {
            info.part_numbers = {order};
        }
        for (const int rate : rates) {
            if (flag_of(section, fmt::format("BaudRate_{}", rate).c_str())) {
                info.bit_rates.push_back(std::int64_t{rate} * 1000);
            }
        }
        info.lss = flag_of(section, "LSS_Supported");
        info.block_sdo = true;
        info.node_id = 1;
        constexpr std::int64_t usual = 125000;
        const bool offers_usual = std::count(info.bit_rates.begin(), info.bit_rates.end(), usual) > 0;
        info.bit_rate = info.bit_rates.empty() || offers_usual ? usual : info.bit_rates.front();
    }

    /// Reads node-ID and bit rate of a DCF. CiA 306 spells the section with one m.
    void read_commissioning() {
        for (const char* name : {"DeviceComissioning", "DeviceCommissioning"}) {
            const IniSection* section = ini_.find(name);
            if (section == nullptr) {
                continue;
            }
            DeviceInfo& info = result_.part.info;
            info.node_id =
                static_cast<int>(number_in(*section, "NodeID", 1, 127, static_cast<std::uint64_t>(info.node_id)));
            info.bit_rate = static_cast<std::int64_t>(number_in(*section, "BaudRate", 10, 1000,
                                                                static_cast<std::uint64_t>(info.bit_rate / 1000))) *
                            1000;
        }
    }

    std::uint64_t number_in(const IniSection& section, const char* key, std::uint64_t low, std::uint64_t high,
                            std::uint64_t otherwise) const {
        const IniValue* value = section.filled(key);
        if (value == nullptr) {
            return otherwise;
        }
        const auto number = eds_unsigned(value->text);
        if (!number || *number < low || *number > high) {
            tell_.note(value->line, fmt::format("{} {} is not a number from {} to {}", key, value->text, low, high),
                       fmt::format("{} is assumed", otherwise));
            return otherwise;
        }
        return *number;
    }

    void read_list(const char* name) {
        const IniSection* list = ini_.find(name);
        if (list == nullptr) {
            return;
        }
        std::size_t listed = 0;
        std::uint64_t said = 0;
        for (const auto& [key, value] : list->values) {
            if (key == "supportedobjects") {
                said = eds_unsigned(value.text).value_or(UINT64_MAX);
                continue;
            }
            ++listed;
            const auto index = eds_unsigned(value.text);
            if (!index || *index > 0xFFFFU || *index == 0) {
                tell_.note(value.line, fmt::format("{} is no index", value.text), "it is ignored");
            } else if (*index >= cia301::first_object) {
                read_object(static_cast<std::uint16_t>(*index), value.line);
            }
        }
        if (said != listed) {
            tell_.note(list->line,
                       fmt::format("[{}] lists {} object(s), but SupportedObjects has another number", name, listed),
                       "the listed objects are used");
        }
    }

    void read_object(std::uint16_t index, unsigned listed_in) {
        const IniSection* section = ini_.find(index_text(index));
        if (section == nullptr) {
            tell_.note(listed_in, fmt::format("object {:04X}h is listed but not described", index),
                       "the device runs without it");
            return;
        }
        if (entries_ > most_entries) {
            return;  // check_whole() reports that there are too many entries
        }
        if (!seen_.emplace(index, listed_in).second) {
            tell_.note(listed_in, fmt::format("object {:04X}h is already listed in line {}", index, seen_[index]),
                       "the second line is ignored");
            return;
        }
        Object object;
        object.index = index;
        object.id = fmt::format("EDS-OD-{:04X}", index);
        object.place = Place{file_, section->line};
        object.name = text_of(section, "ParameterName");
        if (object.name.empty()) {
            object.name = fmt::format("Object {:04X}h", index);
            tell_.note(section->line, fmt::format("[{}] has no ParameterName", section->name),
                       "the object is named after its index");
        }
        read_entries(object, *section);
        entries_ += object.entries.size();
        if (entries_ <= most_entries && !object.entries.empty()) {
            objects_.emplace(index, std::move(object));
        }
    }

    /// Reads objects that have a description but are in none of the lists.
    void read_unlisted() {
        for (const auto& [name, section] : ini_.sections()) {
            const auto index = name.size() == 4 ? eds_hexadecimal(name) : std::nullopt;
            if (index && *index >= cia301::first_object && seen_.count(static_cast<std::uint16_t>(*index)) == 0) {
                tell_.note(section.line, fmt::format("[{}] is in none of the lists of objects", section.name),
                           "the device has the object");
                read_object(static_cast<std::uint16_t>(*index), section.line);
            }
        }
    }

    /// Returns the object type of a description. In CiA 306, an object without ObjectType is a VAR. For a type that
    /// contradicts the description, adds a note and returns a type that fits; 0 when none fits.
    std::uint64_t object_type(const Object& object, const IniSection& section, bool has_subs) const {
        const IniValue* given = section.filled("ObjectType");
        const auto code = given == nullptr ? std::optional<std::uint64_t>{7} : eds_unsigned(given->text);
        const bool has_type = section.filled("DataType") != nullptr;
        const bool single = code == std::uint64_t{2} || code == std::uint64_t{7};
        const bool several = code == std::uint64_t{8} || code == std::uint64_t{9};
        const bool none = code == std::uint64_t{0} || code == std::uint64_t{5} || code == std::uint64_t{6};
        if (none || (several && (has_subs || section.filled("CompactSubObj") != nullptr)) ||
            (single && (has_type || !has_subs))) {
            return *code;
        }
        const std::string what = single    ? fmt::format("[{}] is a single value without DataType", section.name)
                                 : several ? fmt::format("[{}] has no sub-objects", section.name)
                                           : fmt::format("ObjectType {} is unknown", given->text);
        tell_.note(given == nullptr ? section.line : given->line, what,
                   has_subs   ? "a RECORD of its sub-objects is assumed"
                   : has_type ? "a VAR is assumed"
                              : fmt::format("the device runs without object {:04X}h", object.index));
        return has_subs ? 9U : has_type ? 7U : 0U;
    }

    void read_entries(Object& object, const IniSection& section) {
        const auto [first_sub, end_of_subs] = subs_of(subs_, object.index);
        const bool has_subs = first_sub != end_of_subs;
        const std::uint64_t code = object_type(object, section, has_subs);
        if (code == 2 || code == 7) {
            object.kind = Object::Kind::var;
            read_eds_entry(object.entries.emplace_back(), section, 0, false, tell_);
            object.entries.front().name = object.name;
            if (has_subs) {
                tell_.note(section.line, fmt::format("[{}] is a single value but has sub-objects", section.name),
                           "the sub-objects are ignored");
            }
        } else if (code == 8 || code == 9) {
            object.kind = code == 8 ? Object::Kind::array : Object::Kind::record;
            const std::uint64_t compact = number_in(section, "CompactSubObj", 0, last_subindex, 0);
            if (compact != 0) {
                add_compact(object, section, static_cast<unsigned>(compact));
            }
            if (has_subs) {
                add_subs(object);
            }
            complete(object, section);
        }
    }

    /// Adds the entries 1 to `count` that CompactSubObj describes. The section of the object describes them all; two
    /// other sections can contain their names and values.
    void add_compact(Object& object, const IniSection& section, unsigned count) {
        const IniSection* names = ini_.find(index_text(object.index) + "Name");
        const IniSection* values = ini_.find(index_text(object.index) + "Value");
        Entry pattern;
        read_eds_entry(pattern, section, 1, false, tell_);
        for (unsigned sub = 1; sub <= count; ++sub) {
            Entry entry = pattern;
            entry.subindex = static_cast<std::uint8_t>(sub);
            const IniValue* name = names == nullptr ? nullptr : names->filled(std::to_string(sub));
            entry.name = name != nullptr ? name->text : fmt::format("{}{}", object.name, sub);
            const IniValue* value = values == nullptr ? nullptr : values->filled(std::to_string(sub));
            if (value != nullptr) {
                set_eds_value(entry, *value, tell_);
            }
            object.entries.push_back(std::move(entry));
        }
    }

    void add_subs(Object& object) {
        const auto compact_end = static_cast<std::ptrdiff_t>(object.entries.size());
        const auto [first_sub, end_of_subs] = subs_of(subs_, object.index);
        const auto count = static_cast<std::size_t>(end_of_subs - first_sub);
        object.entries.reserve(object.entries.size() + count + 1);  // one element more for sub-index 0
        for (auto one = first_sub; one != end_of_subs; ++one) {
            const auto end = object.entries.begin() + compact_end;
            const auto same = std::find_if(object.entries.begin(), end,
                                           [sub = one->subindex](const Entry& other) { return other.subindex == sub; });
            // An entry's own section has priority over CompactSubObj.
            Entry& entry = same == end ? object.entries.emplace_back() : (*same = Entry{});
            read_eds_entry(entry, *one->section, one->subindex, one->subindex == 0, tell_);
        }
    }

    void complete(Object& object, const IniSection& section) {
        const auto before = [](const Entry& a, const Entry& b) { return a.subindex < b.subindex; };
        if (!std::is_sorted(object.entries.begin(), object.entries.end(), before)) {
            std::sort(object.entries.begin(), object.entries.end(), before);
        }
        if (object.entries.empty()) {
            tell_.note(section.line, fmt::format("[{}] has no sub-objects", section.name),
                       fmt::format("the device runs without object {:04X}h", object.index));
            return;
        }
        if (object.entries.front().subindex != 0) {
            Entry zero;
            zero.name = "Highest sub-index supported";
            zero.type = "UNSIGNED8";
            zero.access = "ro";
            zero.value = std::int64_t{object.entries.back().subindex};
            zero.place = object.place;
            zero.default_place = object.place;
            object.entries.insert(object.entries.begin(), zero);
        }
        const IniValue* said = section.filled("SubNumber");
        if (said != nullptr && eds_unsigned(said->text) != object.entries.size() &&
            section.filled("CompactSubObj") == nullptr) {
            tell_.note(
                said->line,
                fmt::format("SubNumber {} is not the number of sub-objects, {}", said->text, object.entries.size()),
                "the described sub-objects are used");
        }
    }

    void check_whole() {
        Part& part = result_.part;
        if (entries_ > most_entries) {
            tell_.fault(1, fmt::format("the file describes {} entries", entries_),
                        fmt::format("remove objects: a device can have at most {} entries", most_entries));
        }
        if (part.objects.empty() && result_.faults.empty()) {
            tell_.fault(1, "the file describes no objects", "name an EDS, DCF or XDD file");
        }
        std::size_t bytes = 0;
        for (const Object& object : part.objects) {
            for (const Entry& entry : object.entries) {
                bytes += is_string_type(entry.type) ? entry.length : type_size(entry.type);
            }
        }
        if (bytes > most_bytes) {
            tell_.fault(1, fmt::format("the values of all entries take {} bytes", bytes),
                        fmt::format("remove objects: a device can have at most {} bytes of values", most_bytes));
        }
        for (const unsigned index : {cia301::device_type, cia301::error_register, cia301::identity}) {
            if (seen_.count(static_cast<std::uint16_t>(index)) == 0) {
                tell_.note(1, fmt::format("object {:04X}h, which every device must have, is not described", index),
                           "the device runs without it");
            }
        }
    }

    EdsResult result_;
    std::string file_;
    EdsTelling tell_;
    IniFile ini_;
    SubSections subs_;
    std::map<std::uint16_t, unsigned> seen_;  ///< by index of an object: number of the line that lists the object
    std::map<std::uint16_t, Object> objects_;
    std::size_t entries_{0};
};

}  // namespace

EdsResult read_eds(const std::string& text, const std::string& name) {
    return EdsReader{text, name}.read();
}

}  // namespace canproof::host
