// SPDX-License-Identifier: Apache-2.0
#include "host/selection/factory_options.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "devices/catalogue.hpp"
#include "host/base/input_error.hpp"
#include "host/base/number_text.hpp"
#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

std::optional<double> number_of(const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return static_cast<double>(*whole);
    }
    const auto* real = std::get_if<double>(&value);
    return real == nullptr ? std::nullopt : std::optional<double>{*real};
}

FactoryKey key_of(const Object& object, const Entry& entry) {
    FactoryKey key;
    key.name = snake_case(entry.name);
    key.type = entry.type;
    key.unit = object.unit;
    key.length = entry.length;
    if (const auto limits = integer_limits(entry.type)) {
        key.minimum = static_cast<double>(limits->first);
        key.maximum = static_cast<double>(limits->second);
    } else {
        key.minimum = static_cast<double>(std::numeric_limits<float>::lowest());
        key.maximum = static_cast<double>(std::numeric_limits<float>::max());
    }
    key.minimum = number_of(entry.range.minimum.number).value_or(key.minimum);
    key.maximum = number_of(entry.range.maximum.number).value_or(key.maximum);
    key.text = entry.subindex == 0 ? fmt::format("{:04X}h", object.index)
                                   : fmt::format("{:04X}h:{}", object.index, entry.subindex);
    return key;
}

/// Parses a hexadecimal number with 0x, a decimal integer, or, for real types, a decimal number. Returns nothing for
/// any other text.
std::optional<double> number_of(const std::string& text, const std::string& type) {
    const bool is_real = !integer_limits(type).has_value();
    const bool hexadecimal = text.rfind("0x", 0) == 0 || text.rfind("0X", 0) == 0;
    const std::size_t first = !text.empty() && text[0] == '-' ? 1 : 0;
    if (!is_real && !hexadecimal && text.find_first_not_of("0123456789", first) != std::string::npos) {
        return std::nullopt;
    }
    return decimal_or_hexadecimal(text);
}

void put(FactoryValues& values, const FactoryKey& key, const std::string& value, const std::string& whole) {
    const auto refuse = [&] {
        throw InputError{fmt::format("--factory {}: {} takes {}", whole, key.name, key.range())};
    };
    if (!key.words.empty() || is_string_type(key.type)) {
        const bool printable = std::all_of(value.begin(), value.end(), [](char c) { return c >= ' ' && c <= '~'; });
        const bool known = key.words.empty() || std::find(key.words.begin(), key.words.end(), value) != key.words.end();
        if (!known || !printable || value.empty() || (key.words.empty() && value.size() > key.length)) {
            refuse();
        }
        values.set_text(key.name, value);
        return;
    }
    const auto number = number_of(value, key.type);
    if (!number || *number < key.minimum || *number > key.maximum) {
        refuse();
    }
    values.set_number(key.name, number.value_or(0.0));
}

}  // namespace

std::string part_number_of(const std::string& name, const Part& part) {
    const auto lower = [](std::string text) {
        std::transform(text.begin(), text.end(), text.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
        return text;
    };
    const std::string word = lower(name.substr(0, name.find('@')));
    for (const std::string& number : part.info.part_numbers) {
        if (word != part.name && lower(number) == word) {
            return number;
        }
    }
    return {};
}

std::vector<FactoryKey> factory_keys(const Part& part, const std::string& part_number) {
    std::vector<FactoryKey> keys;
    for (const Object& object : part.objects) {
        for (const Entry& entry : object.entries) {
            if (entry.factory) {
                keys.push_back(key_of(object, entry));
            }
        }
    }
    const DeviceModel* const model = find_model(part.name);
    if (model != nullptr && model->further_factory_keys != nullptr) {
        for (FactoryKey& key : model->further_factory_keys(part_number.empty() ? part.name : part_number)) {
            keys.push_back(std::move(key));
        }
    }
    return keys;
}

FactoryOptions::FactoryOptions(const std::vector<std::string>& given) {
    for (const std::string& whole : given) {
        const auto equals = whole.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw InputError{
                fmt::format("--factory {}: write KEY=VALUE, or DEVICE.KEY=VALUE for one of several devices", whole)};
        }
        Given one;
        one.whole = whole;
        one.key = whole.substr(0, equals);
        one.value = whole.substr(equals + 1);
        const auto point = one.key.rfind('.');
        if (point != std::string::npos) {
            one.device = one.key.substr(0, point);
            one.key = one.key.substr(point + 1);
        }
        given_.push_back(one);
    }
}

FactoryValues FactoryOptions::for_device(const std::string& name, const Part& part) {
    FactoryValues values;
    values.set_part_number(part_number_of(name, part));
    const std::vector<FactoryKey> keys = factory_keys(part, values.part_number());
    for (Given& one : given_) {
        if (!one.device.empty() && one.device != name && one.device != name.substr(0, name.find('@'))) {
            continue;
        }
        const auto key = std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return k.name == one.key; });
        if (key != keys.end()) {
            put(values, *key, one.value, one.whole);
            one.used = true;
            continue;
        }
        for (const FactoryKey& other : keys) {
            if (std::find(one.others.begin(), one.others.end(), other.name) == one.others.end()) {
                one.others.push_back(other.name);
            }
        }
    }
    return values;
}

void FactoryOptions::check_used() const {
    for (const Given& one : given_) {
        if (!one.used && one.others.empty()) {
            throw InputError{
                fmt::format("--factory {}: no device of this run takes it; correct the name before the point, or run a "
                            "device with factory data (`canproof signals NAME` lists the keys)",
                            one.whole)};
        }
        if (!one.used) {
            throw InputError{fmt::format("--factory {}: there is no {} in the factory data; use one of {}", one.whole,
                                         one.key, fmt::join(one.others, ", "))};
        }
    }
}

}  // namespace canproof::host
