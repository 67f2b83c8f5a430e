// SPDX-License-Identifier: Apache-2.0
// Reads the register. Reading continues after a fault, so that one run reports all faults.
#include "host/register/reader.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "host/base/cia301.hpp"
#include "host/register/parse_file.hpp"
#include "host/register/read_hazard.hpp"
#include "host/register/read_item.hpp"
#include "host/register/read_manual.hpp"
#include "host/register/read_object.hpp"
#include "host/register/read_review.hpp"
#include "host/register/read_table.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

namespace {

const std::vector<std::string> kinds{"functional", "range", "timing", "protocol", "fault", "physical", "storage"};
const std::vector<std::string> verifications{"test", "property", "fuzz", "analysis", "target", "inspection"};

void read_bit_rates(TomlItem& item, DeviceInfo& info) {
    info.bit_rate = item.integer("bit_rate", 1000, 1000000);
    info.bit_rates = item.integers("bit_rates");
    std::set<std::int64_t> known;
    for (const std::int64_t rate : info.bit_rates) {
        if (!known.insert(rate).second) {
            item.fault(item.place("bit_rates"), fmt::format("bit_rates lists {} twice", rate), "keep one of the two");
        }
    }
    if (!known.empty() && known.count(info.bit_rate) == 0) {
        item.fault(item.place("bit_rate"), fmt::format("bit_rate {} is not in bit_rates", info.bit_rate),
                   "correct the bit rate, or add it to bit_rates");
    }
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char one) { return one >= 'A' && one <= 'Z' ? static_cast<char>(one - 'A' + 'a') : one; });
    return text;
}

/// Adds a fault for each part number that another device, or this device, has already. A part number is a name of its
/// device, in any case of letters.
void check_part_numbers(TomlItem& item, const Part& part, const Register& content) {
    std::map<std::string, std::string> owners;
    for (const Part& other : content.parts) {
        for (const std::string& number :
             other.name == part.name ? std::vector<std::string>{} : other.info.part_numbers) {
            owners.emplace(lower(number), other.name);
        }
    }
    for (const std::string& number : part.info.part_numbers) {
        if (const auto [owner, fresh] = owners.emplace(lower(number), part.name); !fresh) {
            item.fault(item.place("part_numbers"),
                       fmt::format("{} is already a part number of {}", number, owner->second),
                       "give each part number to one device, once");
        }
    }
}

void read_device(TomlItem& item, Part& part) {
    DeviceInfo& info = part.info;
    info.place = item.place();
    const std::string name = item.text("name");
    if (name != part.name) {
        item.fault(item.place("name"), fmt::format("name {} is not the name of the folder", name),
                   fmt::format("write {}", part.name));
    }
    info.title = item.text("title");
    info.vendor = item.text("vendor");
    part.prefix = item.text("prefix");
    info.manual = item.text("manual");
    info.manual_place = item.place("manual");
    info.part_numbers = item.texts("part_numbers", true);
    info.variants = item.texts("variants", false);
    info.node_id = static_cast<int>(item.integer("node_id", 1, 127));
    info.node_id_note = item.text_or("node_id_note", "");
    read_bit_rates(item, info);
    info.sources = item.texts("source", true);
    info.source_place = item.place("source");
    if (auto services = item.item("services")) {
        info.lss = services->boolean_or("lss", false);
        info.block_sdo = services->boolean_or("block_sdo", false);
        info.limit_abort = services->word("limit_abort", {"range", "high_low"}, "high_low");
        info.error_list = services->word("error_list", {"history", "active"}, "history");
        info.lss_bit_rates = services->text_or("lss_bit_rates", "");
        info.lss_reset = services->boolean_or("lss_reset", false);
        info.emcy_content = services->word("emcy_content", {"listed_errors", "detail"}, "listed_errors");
        info.tpdo_trigger = services->word("tpdo_trigger", {"value_change", "event_timer"}, "value_change");
        info.rpdos_answering_remote = services->integers("rpdos_answering_remote");
        info.saves_in_pre_operational_only = services->boolean_or("saves_in_pre_operational_only", false);
        info.services_place = services->place();
        services->finish();
    }
    item.finish();
}

/// Returns whether the text consists of words of lower-case letters and digits, such as no-block-transfer. `joints`
/// contains the characters that may separate two words.
bool is_joined_words(const std::string& text, const std::string& joints) {
    bool within = false;
    for (const char c : text) {
        const bool known = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (!known && (!within || joints.find(c) == std::string::npos)) {
            return false;
        }
        within = known;
    }
    return within;
}

Answer read_answer(TomlItem& item) {
    Answer answer;
    answer.topic = item.has("topic") ? item.text("topic") : "";
    answer.place = item.place("topic");
    answer.choice = item.has("topic") ? item.text("choice") : item.text_or("choice", "");
    answer.differs = item.text_or("differs", "");
    answer.overrides = item.text_or("overrides", "");
    for (const char* key : {"choice", "differs", "overrides"}) {
        if (item.has(key) && !item.has("topic")) {
            item.fault(item.place(key), fmt::format("{} has no topic", key), "add `topic = …`, or remove this key");
        }
    }
    if (!answer.topic.empty() && !is_joined_words(answer.topic, "-._")) {
        item.fault(answer.place, fmt::format("topic {} is malformed", answer.topic),
                   "use small letters and digits, such as heartbeat.consumer-range");
        answer.topic.clear();
    }
    if (!answer.choice.empty() && !is_joined_words(answer.choice, "-_")) {
        item.fault(item.place("choice"), fmt::format("choice {} is malformed", answer.choice),
                   "use small letters and digits, such as refused-above-127");
        answer.choice.clear();
    }
    return answer;
}

Requirement read_requirement(TomlItem& item) {
    Requirement requirement;
    read_common(item, requirement, true);
    read_id(item, requirement);
    requirement.kind = item.word("kind", kinds, "");
    requirement.verify = item.texts("verify", true);
    requirement.retired = item.text_or("retired", "");
    requirement.by = item.text_or("by", "");
    requirement.by_place = requirement.by.empty() ? requirement.place : item.place("by");
    requirement.answer = read_answer(item);
    for (const auto& word : requirement.verify) {
        if (std::find(verifications.begin(), verifications.end(), word) == verifications.end()) {
            item.fault(item.place("verify"), fmt::format("verify = \"{}\" is unknown", word),
                       "use test, property, fuzz, analysis, target or inspection");
        }
    }
    item.finish();
    return requirement;
}

Enumeration read_enumeration(TomlItem& item) {
    Enumeration enumeration;
    read_common(item, enumeration, false);
    read_id(item, enumeration);
    enumeration.name = item.text("name");
    const toml::node* values = item.node("values");
    if (const auto list = values == nullptr ? nullptr : values->as_array()) {
        for (const auto& one : *list) {
            const auto number = static_cast<std::int64_t>(enumeration.values.size());
            enumeration.values.emplace_back(to_text(literal(one)), number);
        }
    } else if (const auto table = values == nullptr ? nullptr : values->as_table()) {
        for (const auto& [word, number] : *table) {
            if (const auto* given = number.as_integer()) {
                enumeration.values.emplace_back(std::string{word.str()}, given->get());
                enumeration.hexadecimal = enumeration.hexadecimal || is_hexadecimal(number);
            } else {
                item.fault(item.place("values"), fmt::format("the word {} has no number", word.str()),
                           "write `word = number`");
            }
        }
    }
    if (enumeration.values.empty()) {
        item.fault("the enumeration has no values", "add `values = [\"off\", \"on\"]` or `values = { off = 0 }`");
    }
    item.finish();
    return enumeration;
}

Constant read_constant(TomlItem& item) {
    Constant constant;
    read_common(item, constant, false);
    read_id(item, constant);
    constant.name = item.text("name");
    constant.type = item.text("type");
    constant.unit = item.text_or("unit", "");
    constant.value = item.value("value");
    constant.value_place = item.place("value");
    constant.hexadecimal = item.has("value") && is_hexadecimal(*item.node("value"));
    constant.compiled_in = item.boolean_or("compiled_in", false);
    item.finish();
    return constant;
}

Signal read_signal(TomlItem& item) {
    Signal signal;
    read_common(item, signal, true);
    read_id(item, signal);
    signal.name = item.text("name");
    signal.count = static_cast<int>(item.integer_or("count", 1, 1, 64));
    signal.input = item.word("direction", {"input", "output"}, "") == "input";
    signal.type = item.text("type");
    signal.unit = item.text_or("unit", "");
    signal.minimum = item.number("min");
    signal.maximum = item.number("max");
    signal.value = item.value("default");
    signal.default_place = item.place("default");
    if (signal.count > 1 && signal.name.find("{n}") == std::string::npos) {
        item.fault(fmt::format("signal {} has a count but no {{n}} in its name", signal.name),
                   "write name = \"aout{n}\"");
    }
    item.finish();
    return signal;
}

Decision read_decision(TomlItem& item) {
    Decision decision;
    decision.place = item.place();
    read_id(item, decision);
    decision.text = item.text("question");
    for (TomlItem& one : item.items("readings")) {
        Decision::Reading reading;
        reading.place = one.place();
        reading.says = one.text("says");
        reading.source = one.text("source");
        decision.readings.push_back(reading);
        one.finish();
    }
    decision.chosen = item.text("chosen");
    decision.because = item.text("because");
    decision.affects = item.texts("affects", false);
    decision.affects_place = item.place("affects");
    decision.none = item.text_or("none", "");
    decision.severity = item.word("severity", {"high", "medium", "low"}, "");
    decision.ref = item.text_or("ref", "");
    decision.answer = read_answer(item);
    if (decision.readings.size() < 2) {
        item.fault(fmt::format("{} has {} reading(s)", decision.id, decision.readings.size()),
                   "write at least two readings, each with a source");
    }
    item.finish();
    return decision;
}

StandardObject read_standard_object(TomlItem& item) {
    StandardObject object;
    object.place = item.place();
    object.index =
        static_cast<std::uint16_t>(item.integer("index", cia301::first_object, cia301::last_communication_object));
    object.name = item.text("name");
    item.finish();
    return object;
}

void read_items(TomlItem& file, Part& part) {
    for (TomlItem& item : file.items("requirement"))
        part.requirements.push_back(read_requirement(item));
    for (TomlItem& item : file.items("object")) {
        for (Object& object : read_objects(item, part.prefix))
            part.objects.push_back(std::move(object));
    }
    for (TomlItem& item : file.items("table"))
        part.tables.push_back(read_table(item));
    for (TomlItem& item : file.items("enumeration"))
        part.enumerations.push_back(read_enumeration(item));
    for (TomlItem& item : file.items("constant"))
        part.constants.push_back(read_constant(item));
    for (TomlItem& item : file.items("signal"))
        part.signals.push_back(read_signal(item));
    for (TomlItem& item : file.items("decision"))
        part.decisions.push_back(read_decision(item));
    for (TomlItem& item : file.items("hazard"))
        part.hazards.push_back(read_hazard(item));
    for (TomlItem& item : file.items("standard_object"))
        part.standard_objects.push_back(read_standard_object(item));
    for (TomlItem& item : file.items("review"))
        read_review(item, part);
    file.finish();
}

Part& part_named(Register& content, const std::string& name) {
    for (Part& part : content.parts) {
        if (part.name == name) {
            return part;
        }
    }
    content.parts.push_back({});
    content.parts.back().name = name;
    if (name == "canopen") {
        content.parts.back().prefix = "CO";
    }
    return content.parts.back();
}

/// Returns the name of the part to which a file belongs: NAME for `spec/devices/NAME/…`, canopen for `spec/canopen/…`
/// and `canproof/spec/canopen/…`, and otherwise an empty text.
std::string part_of(const std::string& path) {
    const std::string devices = "spec/devices/";
    if (path.rfind(shared_rules, 0) == 0 || path.rfind(from_package + shared_rules, 0) == 0) {
        return "canopen";
    }
    if (path.rfind(devices, 0) != 0) {
        return {};
    }
    return path.substr(devices.size(), path.find('/', devices.size()) - devices.size());
}

void read_part_file(const std::string& path, const toml::table& root, Register& content, Faults& faults) {
    TomlItem item{root, path, faults};
    const std::string part = part_of(path);
    if (path.rfind(manuals_folder, 0) == 0) {
        read_manual_file(item, content.manuals);
    } else if (part.empty()) {
        faults.push_back(
            {{path, 1}, "the file is in no known folder", "move the file to manuals/, canopen/ or devices/NAME/"});
    } else if (path == "spec/devices/" + part + "/device.toml") {
        read_device(item, part_named(content, part));
        check_part_numbers(item, part_named(content, part), content);
    } else {
        // Generated code does not depend on reviews, so their files are not listed as its sources.
        if (path.size() < 13 || path.substr(path.size() - 13) != "/reviews.toml") {
            part_named(content, part).files.push_back(path);
        }
        read_items(item, part_named(content, part));
        part_named(content, part).inherited = path.rfind(from_package, 0) == 0;
    }
}

}  // namespace

Register read_register(const SpecFiles& files, Faults& faults) {
    Register content;
    part_named(content, "canopen");
    // device.toml is read first, because it contains the prefix of the objects' ids.
    for (const bool device_files : {true, false}) {
        for (const auto& [path, text] : files) {
            const bool is_device = path.size() > 12 && path.substr(path.size() - 12) == "/device.toml";
            if (is_device != device_files) {
                continue;
            }
            if (is_device) {
                part_named(content, part_of(path)).has_device_file = true;
            }
            const std::string& file = path;
            parse_file(file, text, faults,
                       [&](const toml::table& root) { read_part_file(file, root, content, faults); });
        }
    }
    number_statements(content.manuals);
    for (Part& part : content.parts) {
        std::sort(part.objects.begin(), part.objects.end(), [](const Object& a, const Object& b) {
            return std::tie(a.index, a.place.file, a.place.line) < std::tie(b.index, b.place.file, b.place.line);
        });
    }
    std::sort(content.parts.begin() + 1, content.parts.end(),
              [](const Part& a, const Part& b) { return a.name < b.name; });
    return content;
}

}  // namespace canproof::host
