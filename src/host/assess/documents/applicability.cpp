// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/applicability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

/// The objects that a text such as `1400h-15FFh:05` names.
struct ObjectRange {
    unsigned first{0};
    unsigned last{0};
    std::optional<unsigned> sub{};
};

/// Returns the number that `digits` hexadecimal digits form at `at`; nothing when there are fewer digits.
std::optional<unsigned> hexadecimal_at(const std::string& text, const std::size_t at, const std::size_t digits) {
    constexpr int base = 16;
    const auto is_digit = [](const char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
    if (text.size() < at + digits || !std::all_of(text.begin() + static_cast<std::ptrdiff_t>(at),
                                                  text.begin() + static_cast<std::ptrdiff_t>(at + digits), is_digit)) {
        return std::nullopt;
    }
    return static_cast<unsigned>(std::stoul(text.substr(at, digits), nullptr, base));
}

std::optional<ObjectRange> range_in(const std::string& text) {
    constexpr std::size_t index_digits = 4;
    constexpr std::size_t sub_digits = 2;
    const auto first = hexadecimal_at(text, 0, index_digits);
    if (!first || text.compare(index_digits, 1, "h") != 0) {
        return std::nullopt;
    }
    ObjectRange range{*first, *first};
    std::size_t at = index_digits + 1;
    if (text.compare(at, 1, "-") == 0) {
        const auto last = hexadecimal_at(text, at + 1, index_digits);
        if (!last || text.compare(at + 1 + index_digits, 1, "h") != 0) {
            return std::nullopt;
        }
        range.last = *last;
        at += index_digits + 2;
    }
    if (text.compare(at, 1, ":") == 0) {
        range.sub = hexadecimal_at(text, at + 1, sub_digits);
        at += range.sub ? 1 + sub_digits : 0;
    }
    return at == text.size() ? std::optional{range} : std::nullopt;
}

bool has(const Part& device, const std::string& objects) {
    const auto range = range_in(objects);
    return range && std::any_of(device.objects.begin(), device.objects.end(), [&range](const Object& object) {
               const auto is_meant = [&range](const Entry& entry) {
                   return !range->sub || entry.subindex == *range->sub;
               };
               return object.index >= range->first && object.index <= range->last &&
                      std::any_of(object.entries.begin(), object.entries.end(), is_meant);
           });
}

/// Returns whether `name` is the id, or its group: the id without its number.
bool means(const std::string& name, const std::string& id) {
    return name == id || name == id.substr(0, id.rfind('-'));
}

bool names(const SharedCondition& record, const std::string& id) {
    return std::any_of(record.items.begin(), record.items.end(),
                       [&id](const std::string& name) { return means(name, id); });
}

template <typename Items>
void keep_concerning(Items& items, const std::vector<SharedCondition>& shared, const Part& device) {
    items.erase(
        std::remove_if(items.begin(), items.end(), [&](const auto& one) { return !concerns(shared, one.id, device); }),
        items.end());
}

/// Returns whether the text contains the id as a whole: neither inside a longer id nor inside a longer number.
bool contains_id(const std::string& text, const std::string& id) {
    const auto continues = [](const char c) { return c == '-' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
    for (auto at = text.find(id); at != std::string::npos; at = text.find(id, at + 1)) {
        const std::size_t end = at + id.size();
        if ((at == 0 || !continues(text[at - 1])) && (end == text.size() || !continues(text[end]))) {
            return true;
        }
    }
    return false;
}

std::vector<std::string> texts_of(const Document& document) {
    std::vector<std::string> texts;
    for (const auto& chapter : document.chapters) {
        texts.insert(texts.end(), chapter.text.begin(), chapter.text.end());
        for (const auto& table : chapter.tables) {
            for (const auto& row : table.rows) {
                texts.insert(texts.end(), row.begin(), row.end());
            }
        }
    }
    return texts;
}

/// Returns the ids of the shared requirements and decisions that do not concern the device.
std::vector<std::string> foreign_ids(const Part& rules, const std::vector<SharedCondition>& shared,
                                     const Part& device) {
    std::vector<std::string> ids;
    const auto add = [&](const Item& item) {
        if (!concerns(shared, item.id, device)) {
            ids.push_back(item.id);
        }
    };
    std::for_each(rules.requirements.begin(), rules.requirements.end(), add);
    std::for_each(rules.decisions.begin(), rules.decisions.end(), add);
    return ids;
}

}  // namespace

bool names_objects(const std::string& text) {
    return range_in(text).has_value();
}

bool holds(const Condition& condition, const Part& device) {
    const auto in_device = [&device](const std::string& objects) { return has(device, objects); };
    return (condition.objects.empty() || std::any_of(condition.objects.begin(), condition.objects.end(), in_device)) &&
           std::none_of(condition.without.begin(), condition.without.end(), in_device) &&
           (!condition.lss || device.info.lss) && (!condition.block || device.info.block_sdo);
}

bool is_named(const std::vector<SharedCondition>& shared, const std::string& id) {
    return std::any_of(shared.begin(), shared.end(), [&id](const SharedCondition& one) { return names(one, id); });
}

bool concerns(const std::vector<SharedCondition>& shared, const std::string& id, const Part& device) {
    return std::all_of(shared.begin(), shared.end(), [&](const SharedCondition& one) {
        return !names(one, id) || (one.elsewhere.empty() && holds(one.condition, device));
    });
}

Part shared_rules_of(const Register& content, const std::vector<SharedCondition>& shared, const Part& device) {
    const Part* rules = content.part("canopen");
    Part kept = rules == nullptr ? Part{} : *rules;
    keep_concerning(kept.requirements, shared, device);
    keep_concerning(kept.decisions, shared, device);
    return kept;
}

void check_shared_items(const Document& document, const Register& content, const std::vector<SharedCondition>& shared,
                        const Part& device) {
    const Part* rules = content.part("canopen");
    if (rules == nullptr) {
        return;
    }
    const auto texts = texts_of(document);
    for (const auto& id : foreign_ids(*rules, shared, device)) {
        for (const auto& text : texts) {
            if (contains_id(text, id)) {
                throw InputError{
                    fmt::format("the document {} of {} names {}, which does not concern this device by [[shared]] of "
                                "reports/analysis; correct the record or the text `{}`",
                                document.name, device.name, id, text)};
            }
        }
    }
}

}  // namespace canproof::host
