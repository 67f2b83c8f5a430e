// SPDX-License-Identifier: Apache-2.0
#include "host/codegen/dictionary_rows.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include "host/register/layout.hpp"
#include "host/register/service_words.hpp"

namespace canproof::host {

namespace {

std::uint8_t rights_of(const Entry& entry, bool constant) {
    const std::string_view access{entry.access};
    const std::string_view mapping{entry.mapping};
    std::uint8_t bits = 0;
    const auto grant = [&bits](bool granted, std::uint8_t right) {
        bits = granted ? static_cast<std::uint8_t>(bits | right) : bits;
    };
    grant(access != "wo", rights::read);
    grant(access == "rw" || access == "wo", rights::write);
    grant(mapping == "rpdo" || mapping == "both", rights::rpdo);
    grant(mapping == "tpdo" || mapping == "both", rights::tpdo);
    grant(entry.stored, rights::stored);
    grant(entry.node_id, rights::node_id);
    grant(constant, rights::constant);
    return bits;
}

std::uint32_t limit_bits(const std::string& type, const Value& value) {
    if (std::string_view{type} == "REAL32") {
        const auto* real = std::get_if<double>(&value);
        const auto narrow =
            static_cast<float>(real != nullptr ? *real : static_cast<double>(std::get<std::int64_t>(value)));
        std::uint32_t bits = 0;
        std::memcpy(&bits, &narrow, sizeof bits);
        return bits;
    }
    if (const auto* truth = std::get_if<bool>(&value)) {
        return *truth ? 1U : 0U;
    }
    // Of a negative limit, only the bits of the entry's type are kept: -1 of an INTEGER16 becomes FFFFh.
    const std::int64_t number = std::get<std::int64_t>(value);
    const auto bits = static_cast<std::uint64_t>(number);
    if (number >= 0) {
        return static_cast<std::uint32_t>(bits);
    }
    const std::uint64_t mask = (std::uint64_t{1} << (8U * type_size(type))) - 1U;
    return static_cast<std::uint32_t>(bits & mask);
}

canproof::Limit limit_of(const Entry& entry, const Limit& one) {
    if (one.kind == Limit::Kind::number) {
        return {LimitKind::value, limit_bits(entry.type, one.number), 0};
    }
    if (one.kind == Limit::Kind::object) {
        const unsigned sub = one.subindex < 0 ? same_subindex : static_cast<unsigned>(one.subindex);
        return {LimitKind::entry, (unsigned{one.index} << 8U) | sub, static_cast<std::int32_t>(one.add)};
    }
    return {LimitKind::none, 0U, 0};
}

/// Returns where the entry's allowed values are in the list `allowed`, as `first << 16 | count`. With Limits::shared,
/// uses equal values that are already in the list; otherwise appends the values.
std::uint32_t list_for(const Entry& entry, std::vector<std::uint32_t>& allowed, Limits limits) {
    std::vector<std::uint32_t> bits;
    for (const auto& value : entry.range.values) {
        bits.push_back(limit_bits(entry.type, value));
    }
    const auto found = limits == Limits::shared ? std::search(allowed.begin(), allowed.end(), bits.begin(), bits.end())
                                                : allowed.end();
    const auto first = static_cast<std::size_t>(found - allowed.begin());
    if (found == allowed.end()) {
        allowed.insert(allowed.end(), bits.begin(), bits.end());
    }
    return static_cast<std::uint32_t>((first << 16U) | bits.size());
}

/// Collects the rows of limits. With Limits::shared, entries with equal limits have the same row.
class LimitRows {
  public:
    LimitRows(DictionaryRows& rows, Limits limits) : rows_{rows}, limits_{limits} {}

    /// Returns the position of the entry's row of limits in `rows_.limits`. Adds the row if necessary. Returns
    /// `no_limit` for an entry without limits.
    std::uint16_t row_for(const Entry& entry) {
        if (entry.range.empty()) {
            return no_limit;
        }
        LimitRow row{limit_of(entry, entry.range.minimum), limit_of(entry, entry.range.maximum)};
        if (entry.range.zero) {
            row.minimum.kind = LimitKind::value_or_zero;
        }
        if (!entry.range.values.empty()) {
            row = LimitRow{{LimitKind::list, list_for(entry, rows_.allowed, limits_), 0}, {LimitKind::none, 0U, 0}};
        }
        const auto next = static_cast<std::uint16_t>(rows_.limits.size());
        const auto [known, is_new] = numbers_.try_emplace({content_of(row.minimum), content_of(row.maximum)}, next);
        if (is_new || limits_ == Limits::one_an_entry) {
            rows_.limits.push_back(row);
            return next;
        }
        return known->second;
    }

  private:
    using Content = std::tuple<LimitKind, std::uint32_t, std::int32_t>;

    static Content content_of(const canproof::Limit& limit) { return {limit.kind, limit.bits, limit.add}; }

    DictionaryRows& rows_;
    Limits limits_;
    std::map<std::pair<Content, Content>, std::uint16_t> numbers_;
};

Service service_of(const Entry& entry) {
    const auto& words = service_words();
    const auto found = std::find(words.begin(), words.end(), entry.service);
    return found == words.end() ? Service::none : static_cast<Service>(found - words.begin());
}

/// Puts each object into a hash slot that results from its index and `factor`. Returns the largest number of slots that
/// a search for an object visits. Stops early when this number reaches `enough`.
std::size_t fill_slots(std::vector<std::uint16_t>& slots, const std::vector<ObjectRow>& objects, std::uint32_t factor,
                       std::size_t enough) {
    const std::size_t count = slots.size();
    std::fill(slots.begin(), slots.end(), no_object);
    std::size_t longest = 0;
    for (std::size_t at = 0; at < objects.size() && longest < enough; ++at) {
        std::size_t slot = object_slot(objects[at].index, factor, count);
        std::size_t steps = 1;
        while (slots[slot] != no_object) {
            slot = (slot + 1) % count;
            ++steps;
        }
        slots[slot] = static_cast<std::uint16_t>(at);
        longest = std::max(longest, steps);
    }
    return longest;
}

/// Returns how many factors find_slots() tries, from 4 to 300. More objects get fewer factors.
std::size_t attempts_for(std::size_t objects) {
    constexpr std::size_t most = 300;
    constexpr std::size_t least = 4;
    constexpr std::size_t work = 300000;  // objects that all attempts together put into slots
    return std::clamp(work / std::max<std::size_t>(objects, 1), least, most);
}

/// Chooses the number of slots, a power of two that is at least twice the number of objects. Tries several factors and
/// keeps the one whose longest search is the shortest.
void find_slots(DictionaryRows& rows) {
    std::size_t count = 2;
    while (count < 2 * rows.objects.size()) {
        count *= 2;
    }
    std::vector<std::uint16_t> slots(count);
    std::size_t best = rows.objects.size() + 1;
    std::uint32_t factor = 0x9E3779B1U;  // 2^32 divided by the golden ratio: spreads consecutive indices over the slots
    for (std::size_t attempt = attempts_for(rows.objects.size()); attempt > 0; --attempt) {
        const std::size_t longest = fill_slots(slots, rows.objects, factor, best);
        if (longest < best) {
            best = longest;
            rows.slots = slots;
            rows.slot_factor = factor;
        }
        factor = factor * 1664525U + 1013904223U;
    }
}

}  // namespace

DataType data_type(const std::string& cia_type) {
    using Row = std::pair<std::string_view, DataType>;
    // The most frequent types come first, because the search begins at the start.
    static constexpr std::array<Row, 14> types{{{"UNSIGNED8", DataType::unsigned8},
                                                {"UNSIGNED16", DataType::unsigned16},
                                                {"UNSIGNED32", DataType::unsigned32},
                                                {"BOOLEAN", DataType::boolean},
                                                {"INTEGER8", DataType::integer8},
                                                {"INTEGER16", DataType::integer16},
                                                {"INTEGER32", DataType::integer32},
                                                {"INTEGER64", DataType::integer64},
                                                {"UNSIGNED64", DataType::unsigned64},
                                                {"REAL32", DataType::real32},
                                                {"REAL64", DataType::real64},
                                                {"VISIBLE_STRING", DataType::visible_string},
                                                {"OCTET_STRING", DataType::octet_string},
                                                {"DOMAIN", DataType::domain}}};
    const auto found = std::find_if(types.begin(), types.end(),
                                    [word = std::string_view{cia_type}](const Row& row) { return word == row.first; });
    if (found == types.end()) {
        throw std::out_of_range{cia_type + " is no data type that the firmware supports"};
    }
    return found->second;
}

DictionaryTables DictionaryRows::tables() const {
    return DictionaryTables{table_view(objects),
                            table_view(entries),
                            table_view(limits),
                            table_view(allowed),
                            table_view(layout.constants),
                            table_view(layout.image),
                            layout.fingerprint,
                            table_view(slots),
                            slot_factor,
                            layout.settings_at};
}

DictionaryRows make_rows(const Part& part, Limits limits) {
    DictionaryRows rows;
    rows.layout = make_layout(part);
    LimitRows limit_rows{rows, limits};
    for (std::size_t o = 0; o < part.objects.size(); ++o) {
        const Object& object = part.objects[o];
        rows.objects.push_back(ObjectRow{object.index, static_cast<std::uint16_t>(rows.entries.size()),
                                         static_cast<std::uint8_t>(object.entries.size()),
                                         static_cast<ObjectKind>(object.kind)});
        for (std::size_t e = 0; e < object.entries.size(); ++e) {
            const Entry& entry = object.entries[e];
            const Placement& place = rows.layout.placements[o][e];
            rows.entries.push_back(EntryRow{place.offset, place.size, limit_rows.row_for(entry), entry.subindex,
                                            data_type(entry.type), rights_of(entry, place.constant),
                                            service_of(entry)});
        }
    }
    find_slots(rows);
    return rows;
}

}  // namespace canproof::host
