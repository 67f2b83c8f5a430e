// SPDX-License-Identifier: Apache-2.0
// Two receive PDOs in any state. Each maps up to two entries. The dictionary has any rows; a value has one of two
// limits or none.
#pragma once

#include "firmware/canopen/receive_pdo.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

constexpr std::size_t pdo_count = 2U;
constexpr std::size_t line_count = 2U;  ///< largest number of entries that a PDO maps here
constexpr std::size_t entry_count = pdo_count * line_count;
constexpr std::size_t image_size = 16U;

/// The part of the device that owns the mapped entries. It accepts a received value or refuses it. The prover considers
/// both answers. The harness fixes the answer before the call of the firmware.
class AnyOwner final : public ObjectAccess {
  public:
    Result<ByteView, AbortCode> read(std::uint16_t /*index*/, std::uint8_t /*subindex*/) override {
        return Result<ByteView, AbortCode>::failure(AbortCode::object_missing);
    }
    AbortCode write(std::uint16_t /*index*/, std::uint8_t /*sub*/, ByteView /*value*/, Instant /*now*/) override {
        return AbortCode::object_missing;
    }
    Result<WritePlace, AbortCode> writable(std::uint16_t /*index*/, std::uint8_t /*subindex*/) override {
        return Result<WritePlace, AbortCode>::failure(AbortCode::object_missing);
    }
    AbortCode before_received(const EntryRef& /*entry*/, std::uint64_t /*bits*/) override {
        return takes_ ? AbortCode::none : AbortCode::value_range;
    }
    void after_put(const EntryRef& /*entry*/, bool /*changes*/, Instant /*now*/) override { ++effects_; }
    bool is_watched(std::uint64_t /*marks*/) const override { return true; }

    bool takes_{any<bool>()};
    std::size_t effects_{0U};
};

/// Returns any dictionary row for a number of 1, 2, 4 or 8 bytes in the image, with one of two limits or none.
inline EntryRow any_row() {
    const EntryRow row = any<EntryRow>();
    assume((row.size == 1U) || (row.size == 2U) || (row.size == 4U) || (row.size == 8U));
    assume(!row.may(rights::constant) && ((row.offset + row.size) <= image_size));
    assume((row.type != DataType::boolean) || (row.size == 1U));
    assume((row.limit == no_limit) || (row.limit < 2U));
    return row;
}

/// Returns no limit, or any limit that is a constant. Limits by a list or by another entry are covered by the theorems
/// on the dictionary.
inline Limit any_limit() {
    const Limit limit = any<Limit>();
    assume((limit.kind == LimitKind::none) || (limit.kind == LimitKind::value) ||
           (limit.kind == LimitKind::value_or_zero));
    return limit;
}

/// Returns how many bits an entry has in a PDO: one for a BOOLEAN, whole bytes for all other types.
inline std::uint32_t bits_of(const EntryRow& row) {
    return (row.type == DataType::boolean) ? 1U : (row.size * 8U);
}

/// Two receive PDOs with resolved mappings, in any state of reception. Their values do not count as adjacent in the
/// image of values, so the firmware does not use its faster code for adjacent values.
struct Receiving {
    std::array<std::uint8_t, image_size> image{any<std::array<std::uint8_t, image_size>>()};
    std::array<EntryRow, entry_count> rows{};
    std::array<LimitRow, 2U> limits{};
    DictionaryTables tables{};
    ObjectDictionary objects{tables, MutableBytes{image}, LimitAbort::range};
    AnyOwner owner{};
    TransmitQueue queue{};
    std::array<PdoLine, entry_count> lines{};
    std::array<ReceivePdo, pdo_count> pdos{};
    ReceivePdos received{Slots<ReceivePdo>{pdos}, Slots<PdoLine>{lines}, objects, owner, queue, any<std::uint8_t>()};

    Receiving() {
        for (LimitRow& row : limits) {
            row = LimitRow{any_limit(), any_limit()};
        }
        tables.limits = table_view(limits);
        for (EntryRow& row : rows) {
            row = any_row();
        }
        for (std::size_t number = 0U; number < pdo_count; ++number) {
            open_pdo(number);
        }
        received.failed_ = any<std::uint32_t>() & 0xFFFFFFU;
        received.next_ = earliest(pdos[0].due, pdos[1].due);
        assume(received.is_consistent());
    }

    /// Gives a PDO any state and any mapping. The prover proves the theorem for each number of mapped entries
    /// separately.
    void open_pdo(const std::size_t number) {
        ReceivePdo& pdo = pdos[number];
        leave_open(pdo.parameters);
        leave_open(pdo.waiting);
        pdo.identifier = any<std::uint32_t>();
        pdo.waits = any<bool>();
        pdo.due = any<Instant>();
        const std::size_t count = each((number == 0U) ? (line_count + 1U) : 2U);
        std::uint32_t total{0U};
        pdo.mapping.all_free_ = true;
        for (std::size_t i = 0U; i < count; ++i) {
            PdoLine& line = lines[(number * line_count) + i];
            const EntryRow& row = rows[(number * line_count) + i];
            const bool is_gap = any<bool>();
            line = PdoLine{is_gap ? nullptr : &row, any<std::uint16_t>(), any<std::uint8_t>(), 0U, nullptr};
            assume((line.bits >= 1U) && (line.bits <= 64U) && (is_gap || (line.bits == bits_of(row))));
            total += line.bits;
            pdo.mapping.all_free_ = pdo.mapping.all_free_ && line.is_free();
        }
        assume(total <= 64U);
        pdo.mapping.lines_ = Slots<PdoLine>{&lines[number * line_count], count};
        pdo.mapping.length_ = static_cast<std::uint8_t>((total + 7U) / 8U);
    }
    /// Returns whether byte `at` of the image belongs to an entry that PDO `number` maps.
    bool maps(const std::size_t number, const std::size_t at) const {
        bool mapped{false};
        for (const PdoLine& line : pdos[number].mapping.lines_) {
            const bool lies_in = (line.row != nullptr) && (at >= line.row->offset) &&
                                 (at < (line.row->offset + std::size_t{line.row->size}));
            mapped = mapped || lies_in;
        }
        return mapped;
    }
};

}  // namespace canproof::proofs
