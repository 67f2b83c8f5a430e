// SPDX-License-Identifier: Apache-2.0
// Writes an electronic data sheet (CiA 306). Tools read reals in two ways: python-canopen and CANopenEditor expect
// decimal numbers; Lely's tools expect the bits of IEEE 754 and refuse a decimal limit. All three accept a sheet with
// decimal defaults and without limits of reals, which is the usual sheet. The sheet for Lely contains defaults and
// limits as bits.
#include "host/datasheet/write_eds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/cia301.hpp"
#include "host/datasheet/eds_values.hpp"

namespace canproof::host {

namespace {

constexpr const char* end = "\r\n";

class EdsWriter {
  public:
    EdsWriter(const Register& content, const Part& device, Reals reals)
        : content_{content}, device_{device}, reals_{reals} {}

    std::string text() {
        file_info();
        device_info();
        dummy_usage();
        comments();
        const auto mandatory = [](unsigned i) {
            return i == cia301::device_type || i == cia301::error_register || i == cia301::identity;
        };
        objects("MandatoryObjects", mandatory);
        objects("OptionalObjects", [&](unsigned i) { return !mandatory(i) && !cia301::is_of_manufacturer(i); });
        objects("ManufacturerObjects", cia301::is_of_manufacturer);
        return out_;
    }

  private:
    void section(const std::string& name) { out_ += fmt::format("{}[{}]{}", out_.empty() ? "" : end, name, end); }
    template <typename T>
    void line(const std::string& key, const T& value) {
        out_ += fmt::format("{}={}{}", key, value, end);
    }

    void file_info() {
        const Date date = manual_date(content_, device_);
        const std::string day = fmt::format("{:02}-{:02}-{:04}", date.month, date.day, date.year);
        section("FileInfo");
        line("FileName", device_.name + ".eds");
        line("FileVersion", 1);
        line("FileRevision", 0);
        line("EDSVersion", "4.0");
        line("Description", device_.info.title);
        for (const char* what : {"Creation", "Modification"}) {
            line(fmt::format("{}Time", what), "12:00AM");
            line(fmt::format("{}Date", what), day);
        }
        line("CreatedBy", "canproof");
        line("ModifiedBy", "canproof");
    }

    void device_info() {
        constexpr std::array<int, 8> rates{10, 20, 50, 125, 250, 500, 800, 1000};
        const DeviceInfo& info = device_.info;
        section("DeviceInfo");
        line("VendorName", info.vendor);
        line("VendorNumber", fmt::format("0x{:X}", whole_default(device_, cia301::identity, 1)));
        line("ProductName", info.title);
        line("ProductNumber", fmt::format("0x{:X}", whole_default(device_, cia301::identity, 2)));
        line("RevisionNumber", fmt::format("0x{:X}", whole_default(device_, cia301::identity, 3)));
        line("OrderCode", info.part_numbers.empty() ? "" : info.part_numbers.front());
        for (const int rate : rates) {
            const bool has = std::count(info.bit_rates.begin(), info.bit_rates.end(), rate * 1000) > 0;
            line(fmt::format("BaudRate_{}", rate), has ? 1 : 0);
        }
        line("SimpleBootUpMaster", 0);
        line("SimpleBootUpSlave", 1);
        line("Granularity", granularity(device_));
        line("DynamicChannelsSupported", 0);
        line("GroupMessaging", 0);
        line("NrOfRXPDO", count_objects(device_, cia301::rpdo_communication, cia301::last_rpdo_communication));
        line("NrOfTXPDO", count_objects(device_, cia301::tpdo_communication, cia301::last_tpdo_communication));
        line("LSS_Supported", info.lss ? 1 : 0);
    }

    void dummy_usage() {
        // A receive PDO has a gap where its mapping contains a data type, with a number from 1 to 7, instead of an
        // entry. A gap needs a mapping that can be changed.
        const int usable = granularity(device_) == 0 ? 0 : 1;
        section("DummyUsage");
        for (unsigned type = 1; type <= 7; ++type) {
            line(fmt::format("Dummy{:04X}", type), usable);
        }
    }

    void comments() {
        const Manual* manual = content_.manual(device_.info.manual);
        section("Comments");
        line("Lines", manual == nullptr ? 1 : 2);
        line("Line1", "Written by canproof from its register of requirements");
        if (manual != nullptr) {
            line("Line2", fmt::format("after {}, revision {} of {}", manual->title, manual->revision, manual->date));
        }
    }

    template <typename Chosen>
    void objects(const std::string& name, const Chosen& chosen) {
        std::vector<const Object*> list;
        for (const Object& object : device_.objects) {
            if (chosen(object.index)) {
                list.push_back(&object);
            }
        }
        section(name);
        line("SupportedObjects", list.size());
        for (std::size_t i = 0; i < list.size(); ++i) {
            line(fmt::format("{}", i + 1), fmt::format("0x{:04X}", list[i]->index));
        }
        for (const Object* one : list) {
            object(as_in_sheet(*one));
        }
    }

    void object(const Object& object) {
        const std::string index = fmt::format("{:04X}", object.index);
        section(index);
        line("ParameterName", object.name);
        line("ObjectType", fmt::format("0x{:X}", object_code(object)));
        if (object.kind == Object::Kind::var) {
            entry(object.entries.front());
            return;
        }
        line("SubNumber", object.entries.size());
        for (const Entry& one : object.entries) {
            section(fmt::format("{}sub{:X}", index, one.subindex));
            line("ParameterName", one.name);
            line("ObjectType", one.type == "DOMAIN" ? "0x2" : "0x7");
            entry(one);
        }
    }

    void entry(const Entry& entry) {
        line("DataType", fmt::format("0x{:04X}", data_type_number(entry.type)));
        line("AccessType", eds_access(entry));
        if (entry.type == "DOMAIN") {
            return;  // a DOMAIN has neither default nor mapping in CiA 306
        }
        line("DefaultValue", eds_default(entry, reals_));
        if (const auto low = eds_low_limit(entry, reals_)) {
            line("LowLimit", *low);
        }
        if (const auto high = eds_high_limit(entry, reals_)) {
            line("HighLimit", *high);
        }
        line("PDOMapping", entry.mapping == "none" ? 0 : 1);
    }

    const Register& content_;
    const Part& device_;
    Reals reals_;
    std::string out_;
};

}  // namespace

std::string write_eds(const Register& content, const Part& part, Reals reals) {
    return EdsWriter{content, part, reals}.text();
}

}  // namespace canproof::host
