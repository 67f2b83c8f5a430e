// SPDX-License-Identifier: Apache-2.0
// The dictionary of a device as JSON for tools and as Markdown for readers.
#include "host/datasheet/write_dictionary.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/base/one_line.hpp"
#include "host/datasheet/eds_values.hpp"
#include "host/datasheet/entry_words.hpp"

namespace canproof::host {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Value& value) {
    return std::visit(
        [](const auto& one) -> Json {
            if constexpr (std::is_same_v<std::decay_t<decltype(one)>, std::monostate>) {
                return nullptr;
            } else {
                return one;
            }
        },
        value);
}

Json limit_json(const Entry& entry, const Limit& limit) {
    return limit.kind == Limit::Kind::object ? Json(limit_name(entry, limit)) : json_of(limit.number);
}

Json entry_json(const Entry& entry) {
    Json json{{"subindex", entry.subindex}, {"name", entry.name}, {"type", entry.type}, {"access", entry.access}};
    json["default"] = entry.node_id ? Json(eds_default(entry)) : json_of(entry.value);
    json["minimum"] = limit_json(entry, entry.range.minimum);
    json["maximum"] = limit_json(entry, entry.range.maximum);
    Json values = Json::array();
    for (const Value& value : entry.range.values) {
        values.push_back(json_of(value));
    }
    json["values"] = values;
    json["zero"] = entry.range.zero;
    json["mapping"] = entry.mapping;
    json["stored"] = entry.stored;
    json["factory"] = entry.factory;
    json["service"] = entry.service;
    return json;
}

/// Returns the text as a cell of a Markdown table: without line breaks and with escaped bars.
std::string cell(const std::string& text) {
    std::string out;
    for (const char c : one_line(text)) {
        out += c == '|' ? std::string{"\\|"} : std::string{c};
    }
    return out;
}

}  // namespace

std::string write_object_json(const Part& part) {
    Json objects = Json::array();
    for (const Object& object : part.objects) {
        Json json{{"index", fmt::format("0x{:04X}", object.index)},
                  {"id", object.id},
                  {"name", object.name},
                  {"kind", kind_name(object)},
                  {"text", one_line(object.text)},
                  {"unit", object.unit},
                  {"source", object.sources}};
        const Object sheet = as_in_sheet(object);
        for (const Entry& entry : sheet.entries) {
            json["entries"].push_back(entry_json(entry));
        }
        objects.push_back(json);
    }
    const Json json{
        {"device", part.name}, {"title", part.info.title}, {"vendor", part.info.vendor}, {"objects", objects}};
    return json.dump(2) + "\n";
}

std::string write_object_markdown(const Part& part) {
    std::string text = fmt::format("# Object dictionary of {}\n\n", part.info.title);
    text += "| Index | Sub | Name | Type | Access | Default | Range | PDO | Stored | Id |\n";
    text += "|---|---|---|---|---|---|---|---|---|---|\n";
    for (const Object& object : part.objects) {
        const Object sheet = as_in_sheet(object);
        for (const Entry& entry : sheet.entries) {
            const std::string name = object.kind == Object::Kind::var ? object.name : object.name + ": " + entry.name;
            text +=
                fmt::format("| {:04X}h | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", object.index, entry.subindex,
                            cell(name), entry.type, entry.access, cell(eds_default(entry)), cell(range_words(entry)),
                            entry.mapping == "none" ? "" : entry.mapping, entry.stored ? "yes" : "", object.id);
        }
    }
    return text;
}

}  // namespace canproof::host
