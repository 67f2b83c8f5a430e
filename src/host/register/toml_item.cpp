// SPDX-License-Identifier: Apache-2.0
#include "host/register/toml_item.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>

namespace canproof::host {

Value literal(const toml::node& node) {
    if (const auto b = node.as_boolean())
        return b->get();
    if (const auto i = node.as_integer())
        return i->get();
    if (const auto d = node.as_floating_point())
        return d->get();
    if (const auto s = node.as_string())
        return s->get();
    return {};
}

bool is_hexadecimal(const toml::node& node) {
    const auto number = node.as_integer();
    return number != nullptr && (number->flags() & toml::value_flags::format_as_hexadecimal) != toml::value_flags::none;
}

Place TomlItem::place() const {
    return place(table_);
}

Place TomlItem::place(const toml::node& node) const {
    return Place{file_, static_cast<unsigned>(node.source().begin.line)};
}

bool TomlItem::has(const std::string& key) const {
    return table_.contains(key);
}

Place TomlItem::place(const std::string& key) const {
    const toml::node* found = table_.get(key);
    return found == nullptr ? place() : place(*found);
}

const toml::node* TomlItem::node(const std::string& key) {
    asked_.insert(key);
    return table_.get(key);
}

void TomlItem::missing(const std::string& key, const std::string& what) {
    fault(fmt::format("{} is missing", key), fmt::format("add `{} = …` ({})", key, what));
}

void TomlItem::wrong_type(const std::string& key, const std::string& expected) {
    fault(place(key), fmt::format("{} is not {}", key, expected), fmt::format("write {}", expected));
}

std::string TomlItem::text(const std::string& key) {
    const toml::node* found = node(key);
    if (found == nullptr) {
        missing(key, "a string");
        return {};
    }
    const auto string = found->as_string();
    if (string == nullptr || string->get().empty()) {
        wrong_type(key, "a non-empty string");
        return {};
    }
    return string->get();
}

std::string TomlItem::text_or(const std::string& key, const std::string& otherwise) {
    return has(key) ? text(key) : (node(key), otherwise);
}

std::int64_t TomlItem::integer(const std::string& key, std::int64_t minimum, std::int64_t maximum) {
    const toml::node* found = node(key);
    if (found == nullptr) {
        missing(key, "a whole number");
        return minimum;
    }
    const auto number = found->as_integer();
    if (number == nullptr || number->get() < minimum || number->get() > maximum) {
        wrong_type(key, fmt::format("a whole number from {} to {}", minimum, maximum));
        return minimum;
    }
    return number->get();
}

std::int64_t TomlItem::integer_or(const std::string& key, std::int64_t otherwise, std::int64_t minimum,
                                  std::int64_t maximum) {
    return has(key) ? integer(key, minimum, maximum) : (node(key), otherwise);
}

bool TomlItem::boolean_or(const std::string& key, bool otherwise) {
    const toml::node* found = node(key);
    if (found == nullptr) {
        return otherwise;
    }
    if (const auto b = found->as_boolean()) {
        return b->get();
    }
    wrong_type(key, "true or false");
    return otherwise;
}

std::optional<double> TomlItem::number(const std::string& key) {
    const toml::node* found = node(key);
    if (found == nullptr) {
        return std::nullopt;
    }
    if (!found->is_number()) {
        wrong_type(key, "a number");
        return std::nullopt;
    }
    return found->value<double>();
}

std::vector<std::string> TomlItem::texts(const std::string& key, bool required) {
    std::vector<std::string> all;
    const toml::node* found = node(key);
    if (found == nullptr) {
        if (required) {
            missing(key, "a list of strings");
        }
        return all;
    }
    const auto list = found->as_array();
    if (list == nullptr || (required && list->empty())) {
        wrong_type(key, "a list of strings, not empty");
        return all;
    }
    for (const auto& one : *list) {
        if (const auto string = one.as_string()) {
            all.push_back(string->get());
        } else {
            wrong_type(key, "a list of strings");
        }
    }
    return all;
}

std::vector<std::int64_t> TomlItem::integers(const std::string& key) {
    std::vector<std::int64_t> all;
    const toml::node* found = node(key);
    const auto list = found == nullptr ? nullptr : found->as_array();
    if (found != nullptr && list == nullptr) {
        wrong_type(key, "a list of whole numbers");
    }
    if (list != nullptr) {
        for (const auto& one : *list) {
            if (const auto number = one.as_integer()) {
                all.push_back(number->get());
            } else {
                wrong_type(key, "a list of whole numbers");
            }
        }
    }
    return all;
}

std::string TomlItem::word(const std::string& key, const std::vector<std::string>& words,
                           const std::string& otherwise) {
    if (!has(key)) {
        asked_.insert(key);
        if (otherwise.empty()) {
            missing(key, fmt::format("one of {}", fmt::join(words, ", ")));
        }
        return otherwise;
    }
    const std::string given = text(key);
    if (!given.empty() && std::find(words.begin(), words.end(), given) == words.end()) {
        fault(place(key), fmt::format("{} = \"{}\" is unknown", key, given),
              fmt::format("use one of {}", fmt::join(words, ", ")));
    }
    return given;
}

Value TomlItem::value(const std::string& key) {
    const toml::node* found = node(key);
    return found == nullptr ? Value{} : literal(*found);
}

std::vector<TomlItem> TomlItem::items(const std::string& key) {
    std::vector<TomlItem> all;
    const toml::node* found = node(key);
    if (found == nullptr) {
        return all;
    }
    const auto list = found->as_array();
    if (list == nullptr) {
        wrong_type(key, "a list of tables");
        return all;
    }
    for (const auto& one : *list) {
        if (const auto table = one.as_table()) {
            all.emplace_back(*table, file_, faults_);
        } else {
            wrong_type(key, "a list of tables");
        }
    }
    return all;
}

std::optional<TomlItem> TomlItem::item(const std::string& key) {
    const toml::node* found = node(key);
    if (found == nullptr) {
        return std::nullopt;
    }
    if (const auto table = found->as_table()) {
        return TomlItem{*table, file_, faults_};
    }
    wrong_type(key, "a table");
    return std::nullopt;
}

void TomlItem::finish() {
    for (const auto& [key, node] : table_) {
        const std::string name{key.str()};
        if (asked_.count(name) == 0) {
            fault(place(node), fmt::format("the key `{}` is unknown", name),
                  "remove the key or correct its spelling (spec/README.md lists the keys)");
        }
    }
}

}  // namespace canproof::host
