// SPDX-License-Identifier: Apache-2.0
// Checks the default mapping of each PDO: every entry exists, may be mapped, and has the right length.
#include "host/datasheet/check/mapping_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "host/base/cia301.hpp"
#include "host/datasheet/eds_numbers.hpp"

namespace canproof::host {

namespace {

constexpr auto error = EdsSeverity::error;
constexpr auto warning = EdsSeverity::warning;
constexpr const char* source = "CiA 301, PDO mapping (1600h and 1A00h)";
constexpr const char* access_source = "CiA 306, AccessType; CiA 301, PDO mapping (1600h and 1A00h)";

constexpr unsigned most_bits = 64;
constexpr unsigned first_multiplexed = 254;

class MappingCheck {
  public:
    MappingCheck(const EdsSheet& sheet, const EdsSheetObject& object, EdsFindings& findings)
        : sheet_{sheet}, object_{object}, findings_{findings}, is_rpdo_{object.index < cia301::tpdo_communication} {}

    void run() {
        const EdsSheetEntry* zero = object_.entry(0);
        const auto value = zero == nullptr ? std::nullopt : zero->number();
        const std::uint64_t described = object_.compact != 0 ? object_.compact : highest();
        const std::uint64_t count = value ? value->bits : object_.compact;
        if (count >= first_multiplexed) {
            return;
        }
        if (count > most_bits || count > described) {
            findings_.add("map-count", zero == nullptr ? object_.line() : zero->value_line(),
                          fmt::format("{} maps {} object(s), but {} entries are described and at most 64 can be mapped",
                                      object_.title(), count, described));
        }
        for (const EdsSheetEntry& entry : object_.entries) {
            if (entry.sub == 0) {
                continue;
            }
            if (entry.type != nullptr && entry.type->number != 7) {
                findings_.add("map-type", entry.line_of("DataType"),
                              fmt::format("{} is {} instead of UNSIGNED32", entry.title(), entry.type->name));
            }
            if (entry.sub <= count) {
                check_mapped(entry);
            }
        }
        if (bits_ > most_bits) {
            findings_.add("map-too-long", object_.line(), fmt::format("{} maps {} bits", object_.title(), bits_));
        }
    }

  private:
    unsigned highest() const { return object_.entries.empty() ? 0U : object_.entries.back().sub; }

    void check_mapped(const EdsSheetEntry& at) {
        const auto value = at.number();
        if (!value || value->bits > UINT32_MAX) {
            return;  // the rules for values report an invalid default
        }
        const auto index = static_cast<unsigned>(value->bits >> 16U);
        const auto sub = static_cast<unsigned>((value->bits >> 8U) & 0xFFU);
        const auto length = static_cast<unsigned>(value->bits & 0xFFU);
        bits_ += length;
        if (value->bits == 0) {
            findings_.add(
                "map-empty", at.value_line(),
                fmt::format("{} is 0: sub-index 0 counts this entry, but the entry maps nothing", at.title()));
            return;
        }
        if (index < cia301::first_object) {
            check_dummy(at, index, length);
            return;
        }
        const EdsSheetEntry* target = sheet_.entry(index, sub);
        if (target == nullptr) {
            findings_.add("map-unknown", at.value_line(),
                          fmt::format("{} maps {:04X}h:{:02X}, which is not described", at.title(), index, sub));
            return;
        }
        check_target(at, *target, length);
        if (!mapped_.insert(static_cast<unsigned>(value->bits >> 8U)).second && is_rpdo_) {
            findings_.add("map-twice", at.value_line(), fmt::format("{} maps {} again", at.title(), target->title()));
        }
    }

    void check_target(const EdsSheetEntry& at, const EdsSheetEntry& target, unsigned length) {
        if (!target.mappable) {
            findings_.add("map-not-mappable", at.value_line(),
                          fmt::format("{} maps {}, which has no PDOMapping=1", at.title(), target.title()));
        }
        const bool varies = target.type == nullptr || target.type->bits == 0;
        if (!varies && target.type->bits != length) {
            const bool byte = target.type->bits == 1 && length == 8;
            findings_.add(byte ? "map-boolean-byte" : "map-length", at.value_line(),
                          fmt::format("{} maps {} bit(s) of {}, which has {} bit(s)", at.title(), length,
                                      target.title(), target.type->bits));
        }
        const std::string& access = target.access;
        const bool never = is_rpdo_ ? access == "ro" || access == "const" : access == "wo";
        const bool otherwise = is_rpdo_ ? access == "rwr" : access == "rww";
        if (never) {
            findings_.add("map-access", at.value_line(),
                          fmt::format("{} of a {} PDO maps {}, whose access is {}", at.title(), direction(),
                                      target.title(), access));
        } else if (otherwise) {
            findings_.add("map-direction", at.value_line(),
                          fmt::format("{} of a {} PDO maps {}, whose access is {}", at.title(), direction(),
                                      target.title(), access));
        } else if (access == "rw") {
            findings_.add(
                "map-no-direction", at.value_line(),
                fmt::format("{} maps {}, whose access rw names no direction of the PDO", at.title(), target.title()));
        }
    }

    const char* direction() const { return is_rpdo_ ? "receive" : "transmit"; }

    void check_dummy(const EdsSheetEntry& at, unsigned index, unsigned length) {
        const EdsDataType* type = eds_data_type(index);
        if (type == nullptr || !type->fits_pdo()) {
            findings_.add("map-unknown", at.value_line(),
                          fmt::format("{} maps {}, which is no object and no data type of fixed length", at.title(),
                                      eds_index_text(index)));
            return;
        }
        if (!is_rpdo_) {
            findings_.add("map-dummy-transmit", at.value_line(),
                          fmt::format("{} of a transmit PDO maps the data type {}", at.title(), type->name));
            return;
        }
        if (type->bits != length) {
            findings_.add("map-dummy-length", at.value_line(),
                          fmt::format("{} maps a gap of {} bit(s) with the data type {}, which has {} bit(s)",
                                      at.title(), length, type->name, type->bits));
        }
        const IniSection* usage = sheet_.section("DummyUsage");
        const IniValue* flag = usage == nullptr ? nullptr : usage->filled(fmt::format("Dummy{:04X}", index));
        if (flag == nullptr || eds_unsigned(flag->text).value_or(0) == 0) {
            findings_.add(
                "map-dummy-usage", at.value_line(),
                fmt::format("{} maps the data type {}, but Dummy{:04X} is not 1", at.title(), type->name, index));
        }
    }

    const EdsSheet& sheet_;
    const EdsSheetObject& object_;
    EdsFindings& findings_;
    bool is_rpdo_;
    unsigned bits_{0};
    std::set<unsigned> mapped_;  ///< index and sub-index of the entries that are mapped so far
};

}  // namespace

const std::vector<EdsRule>& mapping_rules() {
    static const std::vector<EdsRule> rules{
        {"map-count", error, "more objects are mapped than mapping entries are described, or more than 64",
         "lower sub-index 0, or describe the missing mapping entries", source},
        {"map-type", error, "a mapping entry is not UNSIGNED32", "write DataType 0x0007", source},
        {"map-too-long", error, "a PDO maps more than 64 bits", "map fewer objects", source},
        {"map-empty", error, "a mapping entry that sub-index 0 counts is 0", "map an object, or lower sub-index 0",
         source},
        {"map-unknown", error, "a mapped object is not described", "describe the object, or map another object",
         source},
        {"map-not-mappable", error, "an object without PDOMapping=1 is mapped",
         "write PDOMapping=1, or map another object", "CiA 306, PDOMapping"},
        {"map-length", error, "the mapped length differs from the data type",
         "write the length of the type in bits into the lowest byte of the mapping entry", source},
        {"map-boolean-byte", warning, "a BOOLEAN is mapped with 8 bits",
         "map 1 bit, or give the object the type UNSIGNED8", source},
        {"map-twice", warning, "a receive PDO maps an object twice", "map the object once: the last value wins",
         source},
        {"map-access", error, "the access of a mapped object forbids the direction of the PDO",
         "map a writable object into a receive PDO, a readable object into a transmit PDO", access_source},
        {"map-direction", error, "the access of a mapped object names the opposite direction of the PDO",
         "write rww for a receive PDO, rwr for a transmit PDO", access_source},
        {"map-no-direction", warning, "the default mapping has an object whose access names no direction of the PDO",
         "write rwr for a transmit PDO, rww for a receive PDO", access_source},
        {"map-dummy-transmit", error, "a transmit PDO maps a data type",
         "map an object: only a receive PDO may have gaps", "CiA 301, dummy mapping"},
        {"map-dummy-length", error, "the length of a gap differs from its data type",
         "write the length of the type in bits", "CiA 301, dummy mapping"},
        {"map-dummy-usage", error, "a receive PDO has a gap whose data type [DummyUsage] does not allow",
         "set the key Dummy… of the data type to 1, or map no gap", "CiA 306, [DummyUsage]"}};
    return rules;
}

void check_mapping(const EdsSheet& sheet, EdsFindings& findings) {
    for (const auto& [index, object] : sheet.objects()) {
        if (cia301::is_pdo_mapping(index)) {
            MappingCheck{sheet, object, findings}.run();
        }
    }
}

}  // namespace canproof::host
