// SPDX-License-Identifier: Apache-2.0
#include "host/register/check_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

/// The minimum or maximum of a range as a number. If the limit is another object, the number is the default of this
/// object.
struct End {
    std::optional<double> value;
    std::string words;  ///< description for a message, such as "4020h:1 default 2500 - 100"
    std::string fix;    ///< the value that the user can change instead of the default, such as "4020h:1" or "the limit"
};

class LimitCheck {
  public:
    LimitCheck(const Part& part, Faults& faults) : part_{part}, faults_{faults} {
        for (const Object& object : part.objects) {
            for (const Entry& entry : object.entries) {
                entries_.emplace(std::pair{object.index, entry.subindex}, &entry);
            }
        }
    }

    void run() {
        for (const Object& object : part_.objects) {
            for (const Entry& entry : object.entries) {
                if (is_known_type(entry.type) && !entry.range.empty()) {
                    where_ = fmt::format("{:04X}h:{}", object.index, entry.subindex);
                    check(entry);
                }
            }
        }
    }

  private:
    void fault(const Place& place, const std::string& what, const std::string& fix) {
        faults_.push_back({place, fmt::format("{} {}", where_, what), fix});
    }

    void check(const Entry& entry) {
        if (type_size(entry.type) == 0 || type_size(entry.type) > 4) {
            fault(entry.range.place,
                  fmt::format("has the type {} and cannot have a range; only types of 1 to 4 bytes can", entry.type),
                  "remove range");
            return;
        }
        check_values(entry);
        const End low = end(entry, entry.range.minimum);
        const End high = end(entry, entry.range.maximum);
        if (low.value && high.value && *low.value > *high.value) {
            fault(entry.range.place, fmt::format("minimum ({}) exceeds its maximum ({})", low.words, high.words),
                  "lower the minimum or raise the maximum");
            return;
        }
        check_default(entry, low, high);
    }

    void check_values(const Entry& entry) {
        for (const Value& value : entry.range.values) {
            if (!fits_type(value, entry.type)) {
                fault(entry.range.place, fmt::format("allows {}, which is no {}", to_text(value), entry.type),
                      fmt::format("allow {}", type_words(entry.type)));
            }
        }
        const bool ends =
            entry.range.minimum.kind != Limit::Kind::none || entry.range.maximum.kind != Limit::Kind::none;
        if (ends && !entry.range.values.empty()) {
            fault(entry.range.place, "has both limits and a list of values", "remove the limits or the list");
        }
        const auto least = number_of(entry.range.minimum.number);
        const bool above_zero = entry.range.minimum.kind == Limit::Kind::number && least && *least > 0.0;
        if (entry.range.zero && (!above_zero || is_real_type(entry.type))) {
            fault(entry.range.place, "allows 0 in addition to its range, but the minimum is no whole number above 0",
                  "remove `zero`, or write a `min` above 0");
        }
    }

    void check_default(const Entry& entry, const End& low, const End& high) {
        auto given = number_of(entry.value);
        if (given && entry.node_id) {
            *given += part_.info.node_id;  // adds the node-ID as shipped
        }
        if (!given || !fits_type(entry.value, entry.type)) {
            return;  // another check reports a default that does not fit the type
        }
        const std::string text = (entry.node_id ? "$NODEID+" : "") + to_text(entry.value);
        if (high.value && *given > *high.value) {
            fault(entry.default_place, fmt::format("default {} exceeds its limit ({})", text, high.words),
                  fmt::format("lower the default or raise {}", high.fix));
        }
        const bool off = entry.range.zero && *given == 0.0;
        if (low.value && *given < *low.value && !off) {
            fault(entry.default_place, fmt::format("default {} is below its limit ({})", text, low.words),
                  fmt::format("raise the default or lower {}", low.fix));
        }
        const auto& values = entry.range.values;
        const auto same = [&](const Value& value) { return number_of(value) == given; };
        if (!values.empty() && std::none_of(values.begin(), values.end(), same)) {
            fault(entry.default_place, fmt::format("default {} is not among the allowed values", text),
                  "use an allowed value, or add the default to the allowed values");
        }
    }

    End end(const Entry& entry, const Limit& limit) {
        switch (limit.kind) {
            case Limit::Kind::number:
                return number_end(entry, limit);
            case Limit::Kind::object:
                return object_end(entry, limit);
            default:
                return {};
        }
    }

    End number_end(const Entry& entry, const Limit& limit) {
        if (!fits_type(limit.number, entry.type)) {
            fault(limit.place, fmt::format("limit {} is no {}", to_text(limit.number), entry.type),
                  fmt::format("use {}", type_words(entry.type)));
            return {};
        }
        return {number_of(limit.number), to_text(limit.number), "the limit"};
    }

    End object_end(const Entry& entry, const Limit& limit) {
        const int sub = limit.subindex < 0 ? entry.subindex : limit.subindex;
        const std::string name = fmt::format("{:04X}h:{}", limit.index, sub);
        const auto found = sub > 0xFF ? entries_.end() : entries_.find({limit.index, static_cast<std::uint8_t>(sub)});
        if (found == entries_.end()) {
            fault(limit.place, fmt::format("is limited by {}, which does not exist", name),
                  "name an object of this device");
            return {};
        }
        const Entry& other = *found->second;
        if (other.type != entry.type) {
            fault(limit.place,
                  fmt::format("has the type {}, but its limit {} has the type {}", entry.type, name, other.type),
                  "name an object of the same type as the entry");
            return {};
        }
        if (is_real_type(entry.type)) {
            fault(limit.place, fmt::format("is a REAL32, but its limit is the object {}", name),
                  "write a number as limit: only the limit of an integer can be another object");
            return {};
        }
        End result;
        result.words = fmt::format("{} default {}", name, to_text(other.value));
        if (limit.add != 0) {
            result.words += fmt::format(" {} {}", limit.add < 0 ? "-" : "+", std::abs(limit.add));
        }
        result.fix = name;
        if (const auto value = number_of(other.value)) {
            result.value = *value + static_cast<double>(limit.add);
        }
        return result;
    }

    const Part& part_;
    Faults& faults_;
    std::map<std::pair<std::uint16_t, std::uint8_t>, const Entry*> entries_;
    std::string where_;
};

}  // namespace

void check_limits(const Part& part, Faults& faults) {
    LimitCheck{part, faults}.run();
}

}  // namespace canproof::host
