// SPDX-License-Identifier: Apache-2.0
// Writes the device description of CiA 311 as ISO 15745 profile containers.
#include "host/datasheet/write_xdd.hpp"

#include <fmt/format.h>

#include <pugixml.hpp>
#include <sstream>

#include "host/base/cia301.hpp"
#include "host/datasheet/eds_values.hpp"

namespace canproof::host {

namespace {

constexpr const char* name_space = "http://www.canopen.org/xml/1.0";

void add_text(pugi::xml_node& node, const char* name, const std::string& text) {
    node.append_child(name).text().set(text.c_str());
}

void add(pugi::xml_node& node, const char* name, const std::string& value) {
    node.append_attribute(name).set_value(value.c_str());
}

void add_header(pugi::xml_node& profile, const char* name, const char* revision, const char* reference) {
    auto header = profile.append_child("ProfileHeader");
    add_text(header, "ProfileIdentification", "CAN_CANopen");
    add_text(header, "ProfileRevision", revision);
    add_text(header, "ProfileName", name);
    add_text(header, "ProfileSource", "");
    add_text(header, "ProfileClassID", name);
    auto iso = header.append_child("ISO15745Reference");
    add_text(iso, "ISO15745Part", "1");
    add_text(iso, "ISO15745Edition", "1");
    add_text(iso, "ProfileTechnology", reference);
}

/// Adds the body of a profile of this kind (`Device` or `CommunicationNetwork`), with the file data that CiA 311
/// requires.
pugi::xml_node add_body(pugi::xml_node& root, const Register& content, const Part& device, const std::string& kind) {
    const Date date = manual_date(content, device);
    auto profile = root.append_child("ISO15745Profile");
    add_header(profile, kind == "Device" ? "Device" : "CommunicationNetwork", "1", "CANopen");
    auto body = profile.append_child("ProfileBody");
    add(body, "xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance");
    add(body, "xsi:type", fmt::format("ProfileBody_{}_CANopen", kind));
    add(body, "fileName", device.name + ".xdd");
    add(body, "fileCreator", "canproof");
    add(body, "fileCreationDate", fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day));
    add(body, "fileVersion", "1.0");
    return body;
}

void add_identity(pugi::xml_node& body, const Part& device) {
    auto identity = body.append_child("DeviceIdentity");
    add_text(identity, "vendorName", device.info.vendor);
    add_text(identity, "vendorID", fmt::format("0x{:08X}", whole_default(device, cia301::identity, 1)));
    add_text(identity, "productName", device.info.title);
    add_text(identity, "productID", fmt::format("0x{:08X}", whole_default(device, cia301::identity, 2)));
    for (const auto& number : device.info.part_numbers) {
        add_text(identity, "orderNumber", number);
    }
}

/// Adds the device function. CiA 311 requires at least one characteristic, so the manual of the device is given as one.
void add_function(pugi::xml_node& body, const Register& content, const Part& device) {
    const Manual* manual = content.manual(device.info.manual);
    auto characteristic = body.append_child("DeviceFunction")
                              .append_child("capabilities")
                              .append_child("characteristicsList")
                              .append_child("characteristic");
    auto name = characteristic.append_child("characteristicName").append_child("label");
    add(name, "lang", "en");
    name.text().set("Manual");
    auto said = characteristic.append_child("characteristicContent").append_child("label");
    add(said, "lang", "en");
    const std::string text = manual == nullptr
                                 ? "none"
                                 : fmt::format("{}, revision {} of {}", manual->title, manual->revision, manual->date);
    said.text().set(text.c_str());
}

/// Adds the attributes that both an object with a single value and a sub-object have.
void add_entry(pugi::xml_node& node, const Entry& entry) {
    add(node, "dataType", fmt::format("{:04X}", data_type_number(entry.type)));
    add(node, "accessType", entry.access);
    if (entry.type != "DOMAIN") {
        add(node, "defaultValue", eds_default(entry));
    }
    if (const auto low = eds_low_limit(entry, Reals::decimal)) {
        add(node, "lowLimit", *low);
    }
    if (const auto high = eds_high_limit(entry, Reals::decimal)) {
        add(node, "highLimit", *high);
    }
    const bool both = entry.mapping == "both";
    add(node, "PDOmapping",
        entry.mapping == "none"   ? "no"
        : both                    ? "optional"
        : entry.mapping == "tpdo" ? "TPDO"
                                  : "RPDO");
}

void add_object(pugi::xml_node& list, const Object& object) {
    auto node = list.append_child("CANopenObject");
    add(node, "index", fmt::format("{:04X}", object.index));
    add(node, "name", object.name);
    add(node, "objectType", fmt::format("{}", object_code(object)));
    if (object.kind == Object::Kind::var) {
        add_entry(node, object.entries.front());
        return;
    }
    add(node, "subNumber", fmt::format("{}", object.entries.size()));
    for (const Entry& entry : object.entries) {
        auto sub = node.append_child("CANopenSubObject");
        add(sub, "subIndex", fmt::format("{:02X}", entry.subindex));
        add(sub, "name", entry.name);
        add(sub, "objectType", entry.type == "DOMAIN" ? "2" : "7");
        add_entry(sub, entry);
    }
}

void add_network(pugi::xml_node& body, const Part& device) {
    const DeviceInfo& info = device.info;
    auto rates = body.append_child("TransportLayers").append_child("PhysicalLayer").append_child("baudRate");
    add(rates, "defaultValue", fmt::format("{} Kbps", info.bit_rate / 1000));
    for (const auto rate : info.bit_rates) {
        auto node = rates.append_child("supportedBaudRate");
        add(node, "value", fmt::format("{} Kbps", rate / 1000));
    }
    auto general = body.append_child("NetworkManagement").append_child("CANopenGeneralFeatures");
    add(general, "granularity", fmt::format("{}", granularity(device)));
    add(general, "nrOfRxPDO",
        fmt::format("{}", count_objects(device, cia301::rpdo_communication, cia301::last_rpdo_communication)));
    add(general, "nrOfTxPDO",
        fmt::format("{}", count_objects(device, cia301::tpdo_communication, cia301::last_tpdo_communication)));
    add(general, "layerSettingServiceSlave", info.lss ? "true" : "false");
    add(general, "bootUpSlave", "true");
}

}  // namespace

std::string write_xdd(const Register& content, const Part& part) {
    pugi::xml_document document;
    auto declaration = document.append_child(pugi::node_declaration);
    add(declaration, "version", "1.0");
    add(declaration, "encoding", "UTF-8");
    auto root = document.append_child("ISO15745ProfileContainer");
    add(root, "xmlns", name_space);
    auto device_body = add_body(root, content, part, "Device");
    add_identity(device_body, part);
    add_function(device_body, content, part);
    auto network_body = add_body(root, content, part, "CommunicationNetwork");
    auto layers = network_body.append_child("ApplicationLayers");
    auto list = layers.append_child("CANopenObjectList");
    const std::size_t mandatory = count_objects(part, cia301::device_type, cia301::error_register) +
                                  count_objects(part, cia301::identity, cia301::identity);
    const std::size_t manufacturer =
        count_objects(part, cia301::first_manufacturer_object, cia301::last_manufacturer_object);
    add(list, "mandatoryObjects", fmt::format("{}", mandatory));
    add(list, "optionalObjects", fmt::format("{}", part.objects.size() - mandatory - manufacturer));
    add(list, "manufacturerObjects", fmt::format("{}", manufacturer));
    for (const Object& object : part.objects) {
        add_object(list, as_in_sheet(object));
    }
    add_network(network_body, part);
    std::ostringstream out;
    document.save(out, "  ");
    return out.str();
}

}  // namespace canproof::host
