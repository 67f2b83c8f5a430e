#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "host/speccompiler/checker.hpp"

namespace canproof::host {

namespace {

bool is_real(const std::string& type) {
    return type == "REAL32" || type == "REAL64";
}

std::optional<double> as_number(const Value& value) {
    if (const auto* i = std::get_if<std::int64_t>(&value))
        return static_cast<double>(*i);
    if (const auto* d = std::get_if<double>(&value))
        return *d;
    if (const auto* b = std::get_if<bool>(&value))
        return *b ? 1.0 : 0.0;
    return std::nullopt;
}

class ObjectCheck {
  public:
    ObjectCheck(Part& part, Faults& faults) : part_{part}, faults_{faults} {}

    void run() {
        for (Object& object : part_.objects) {
            objects_.emplace(object.index, &object);
        }
        for (Object& object : part_.objects) {
            check_subindices(object);
            for (Entry& entry : object.entries) {
                if (is_known_type(entry.type)) {
                    check_type(object, entry);
                    resolve_table(object, entry);
                    check_limits(object, entry);
                    check_default(object, entry);
                }
            }
        }
    }

  private:
    void fault(const Entry& entry, const std::string& what, const std::string& mend) {
        faults_.push_back({entry.place, what, mend});
    }
    static std::string name(const Object& object, const Entry& entry) {
        return fmt::format("{:04X}h:{}", object.index, entry.subindex);
    }

    void check_subindices(const Object& object) {
        for (std::size_t i = 1; i < object.entries.size(); ++i) {
            if (object.entries[i].subindex == object.entries[i - 1].subindex) {
                fault(object.entries[i], fmt::format("{} stands twice", name(object, object.entries[i])),
                      "give each entry its own sub-index");
            }
        }
        const bool mapping = (object.index & 0xFE00U) == 0x1600U || (object.index & 0xFE00U) == 0x1A00U;
        if (mapping && object.entries.size() > 65) {
            fault(object.entries.front(),
                  fmt::format("{:04X}h has {} mapping entries", object.index, object.entries.size() - 1),
                  "a PDO carries at most 64");
        }
    }

    void check_type(const Object& object, const Entry& entry) {
        const bool sized = type_size(entry.type) > 0;
        if (entry.length > 0 && sized) {
            fault(entry, fmt::format("{} has a length, but {} has its own", name(object, entry), entry.type),
                  "remove length");
        }
        if (entry.mapping != "none" && !sized) {
            fault(entry, fmt::format("{} of type {} cannot be mapped", name(object, entry), entry.type),
                  "set mapping = \"none\"");
        }
        const bool writes = entry.access == "rw" || entry.access == "wo";
        if ((entry.mapping == "rpdo" || entry.mapping == "both") && !writes) {
            fault(entry, fmt::format("{} is {} and cannot be received", name(object, entry), entry.access),
                  "set mapping = \"tpdo\" or access = \"rw\"");
        }
        if (entry.stored && !writes) {
            fault(entry, fmt::format("{} is {} and cannot be stored", name(object, entry), entry.access),
                  "remove stored");
        }
    }

    void resolve_table(const Object& object, Entry& entry) {
        if (entry.range.table.empty()) {
            return;
        }
        const auto found = std::find_if(part_.tables.begin(), part_.tables.end(),
                                        [&](const Table& t) { return t.id == entry.range.table; });
        if (found == part_.tables.end()) {
            fault(entry,
                  fmt::format("{} takes its range from table {}, which does not exist", name(object, entry),
                              entry.range.table),
                  "name a [[table]] of this device");
            return;
        }
        for (const auto& row : found->rows) {
            for (const auto& part : row.cells.empty() ? std::vector<Cell::Part>{} : row.cells.front().parts) {
                const auto* first = std::get_if<std::int64_t>(&part.first);
                const auto* last = std::get_if<std::int64_t>(&part.last);
                for (std::int64_t v = first == nullptr ? 1 : *first; first != nullptr && v <= *last; ++v) {
                    if (std::find(entry.range.values.begin(), entry.range.values.end(), Value{v}) ==
                        entry.range.values.end()) {
                        entry.range.values.emplace_back(v);
                    }
                }
            }
        }
        if (entry.range.values.empty()) {
            fault(entry, fmt::format("table {} has no numbers in its first column", entry.range.table),
                  "choose another table");
        }
    }

    /// The numeric value of a limit, with its words for a message; nothing when it does not limit.
    std::optional<double> limit_value(const Object& object, const Entry& entry, const Limit& limit,
                                      std::string& words) {
        if (limit.kind == Limit::Kind::number) {
            words = to_text(limit.number);
            return as_number(limit.number);
        }
        if (limit.kind == Limit::Kind::none) {
            return std::nullopt;
        }
        const int sub = limit.subindex < 0 ? entry.subindex : limit.subindex;
        const auto found = objects_.find(limit.index);
        const Entry* other = nullptr;
        if (found != objects_.end()) {
            for (const Entry& e : found->second->entries) {
                other = e.subindex == sub ? &e : other;
            }
        }
        if (other == nullptr) {
            fault(
                entry,
                fmt::format("{} is limited by {:04X}h:{}, which does not exist", name(object, entry), limit.index, sub),
                "name an object of this device");
            return std::nullopt;
        }
        if (other->type != entry.type) {
            fault(entry,
                  fmt::format("{} ({}) is limited by {:04X}h:{} ({})", name(object, entry), entry.type, limit.index,
                              sub, other->type),
                  "a limit has the type of what it limits");
            return std::nullopt;
        }
        words = fmt::format("{:04X}h:{} default {}", limit.index, sub, to_text(other->value));
        if (limit.add != 0) {
            words += fmt::format(" {} {}", limit.add < 0 ? "-" : "+", std::abs(limit.add));
        }
        const auto value = as_number(other->value);
        return value ? std::optional{*value + static_cast<double>(limit.add)} : std::nullopt;
    }

    void check_limits(const Object& object, const Entry& entry) {
        if (entry.range.empty()) {
            return;
        }
        if (type_size(entry.type) == 0 || type_size(entry.type) > 4) {
            fault(entry, fmt::format("{} of type {} cannot have a range", name(object, entry), entry.type),
                  "remove range");
            return;
        }
        const auto own = integer_limits(entry.type);
        for (const Limit* limit : {&entry.range.minimum, &entry.range.maximum}) {
            const auto value = limit->kind == Limit::Kind::number ? as_number(limit->number) : std::nullopt;
            if (limit->kind != Limit::Kind::number) {
                continue;
            }
            const bool whole = std::holds_alternative<std::int64_t>(limit->number);
            if (!value || (!is_real(entry.type) && !whole) ||
                (own && (*value < static_cast<double>(own->first) || *value > static_cast<double>(own->second)))) {
                fault(entry,
                      fmt::format("{} limit {} is no {}", name(object, entry), to_text(limit->number), entry.type),
                      "give a limit that the type can hold");
            }
        }
        std::string low_words;
        std::string high_words;
        const auto low = limit_value(object, entry, entry.range.minimum, low_words);
        const auto high = limit_value(object, entry, entry.range.maximum, high_words);
        if (low && high && *low > *high) {
            fault(entry,
                  fmt::format("{} minimum {} exceeds its maximum {}", name(object, entry), low_words, high_words),
                  "exchange them");
        }
        const auto given = as_number(entry.value);
        if (given && high && *given > *high) {
            fault(entry,
                  fmt::format("{} default {} exceeds its limit ({})", name(object, entry), to_text(entry.value),
                              high_words),
                  "lower it or raise the limit");
        }
        if (given && low && *given < *low) {
            fault(entry,
                  fmt::format("{} default {} is below its limit ({})", name(object, entry), to_text(entry.value),
                              low_words),
                  "raise it or lower the limit");
        }
        const auto& values = entry.range.values;
        if (given && !values.empty() && std::find(values.begin(), values.end(), entry.value) == values.end()) {
            fault(entry,
                  fmt::format("{} default {} is not among its values", name(object, entry), to_text(entry.value)),
                  "use one of them or add it");
        }
    }

    void check_default(const Object& object, Entry& entry) {
        const std::string where = name(object, entry);
        if (entry.type == "DOMAIN") {
            if (!std::holds_alternative<std::monostate>(entry.value)) {
                fault(entry, fmt::format("{} is a DOMAIN with a default", where), "remove default");
            }
            return;
        }
        if (is_string_type(entry.type)) {
            const auto* text = std::get_if<std::string>(&entry.value);
            if (text == nullptr) {
                fault(entry, fmt::format("{} has no text as default", where), "give default = \"…\"");
            } else if (entry.length != 0 && text->size() > entry.length) {
                fault(entry,
                      fmt::format("{} default has {} bytes, its length is {}", where, text->size(), entry.length),
                      "shorten it or raise length");
            } else if (entry.length == 0) {
                entry.length = text->size();
            }
            return;
        }
        check_numeric_default(entry, where);
    }

    void check_numeric_default(const Entry& entry, const std::string& where) {
        const auto number = as_number(entry.value);
        if (!number) {
            fault(entry, fmt::format("{} has no number as default", where),
                  fmt::format("give a default of type {}", entry.type));
            return;
        }
        const auto own = integer_limits(entry.type);
        const bool whole = !std::holds_alternative<double>(entry.value);
        if (!is_real(entry.type) && !whole) {
            fault(entry, fmt::format("{} default {} is no whole number", where, to_text(entry.value)),
                  "write a whole number");
        } else if (own && (*number < static_cast<double>(own->first) || *number > static_cast<double>(own->second))) {
            fault(entry, fmt::format("{} default {} is no {}", where, to_text(entry.value), entry.type),
                  fmt::format("use a value from {} to {}", own->first, own->second));
        }
    }

    Part& part_;
    Faults& faults_;
    std::map<std::uint16_t, const Object*> objects_;
};

}  // namespace

void check_objects(Part& part, Faults& faults) {
    ObjectCheck{part, faults}.run();
}

}  // namespace canproof::host
