// SPDX-License-Identifier: Apache-2.0
// A save of the parameter store that the power cuts after any byte. The dictionary has one stored parameter of four
// bytes. A save of more parameters repeats the same steps.
#pragma once

#include "firmware/canopen/parameter_store.hpp"
#include "generated/canopen/constants.hpp"
#include "properties/proofs/support/cut_memory.hpp"

namespace canproof::proofs {

constexpr std::uint16_t parameter_index = 0x2100U;
constexpr std::size_t parameter_size = 4U;
constexpr std::size_t bank_size = 16U + parameter_size + 4U;  // header, values, CRC
/// A save writes a marker that makes the new bank invalid, the bytes of the bank, a marker that makes the bank valid,
/// and a marker that makes the old bank invalid.
constexpr std::size_t bytes_of_a_save = bank_size + 3U;

using Memory = CutMemory<2U * bank_size>;

constexpr std::array<ObjectRow, 1U> object_rows{{{parameter_index, 0U, 1U, ObjectKind::var}}};
constexpr std::array<EntryRow, 1U> entry_rows{{{0U, parameter_size, no_limit, 0U, DataType::unsigned32,
                                                rights::read | rights::write | rights::stored, Service::none}}};
constexpr std::array<std::uint8_t, parameter_size> shipped_image{{1U, 2U, 3U, 4U}};
constexpr std::array<std::uint16_t, 2U> slots{{0U, no_object}};
constexpr std::uint32_t layout = 0x12345678U;
constexpr std::uint32_t shipped = 0x04030201U;

/// The dictionary row of 1010h:1 (save all parameters).
constexpr EntryRow save_all{0U, 4U, no_limit, 1U, DataType::unsigned32, rights::read | rights::write, Service::store};

inline DictionaryTables dictionary_tables() {
    DictionaryTables tables{};
    tables.objects = table_view(object_rows);
    tables.entries = table_view(entry_rows);
    tables.defaults = table_view(shipped_image);
    tables.layout = layout;
    tables.slots = table_view(slots);
    return tables;
}

/// A device that is switched on with the stored parameters in `memory`.
struct Device {
    explicit Device(Memory& memory) : store{objects, memory} {
        store.open();
        objects.load_defaults(ParameterGroup::manufacturer, 1U);
        store.load(ParameterGroup::manufacturer, 1U);
    }
    std::uint32_t value() const { return objects.read(parameter_index, 0U); }
    AbortCode save(const std::uint32_t value) {
        objects.write(parameter_index, 0U, value);
        return store.execute(EntryRef{&save_all, 0x1010U}, generated::canopen::store_signature);
    }

    DictionaryTables tables{dictionary_tables()};
    std::array<std::uint8_t, parameter_size> image{};
    ObjectDictionary objects{tables, MutableBytes{image}, LimitAbort::range};
    ParameterStore store;
};

/// Cuts the power after some number of bytes of a save that follows `saves` other saves. The prover proves the theorem
/// for each number of bytes.
inline void cut_a_save_behind(const std::size_t saves) {
    const std::size_t cut = each(bytes_of_a_save + 1U);
    Memory::Bytes bytes{};
    Memory memory{bytes};
    std::uint32_t last{shipped};
    for (std::size_t i = 0U; i < saves; ++i) {
        last = any<std::uint32_t>();
        Device device{memory};
        claim(device.save(last) == AbortCode::none);
    }
    const auto next = any<std::uint32_t>();
    Device device{memory};
    claim(!device.store.is_damaged() && (device.value() == last));
    memory.left_ = cut;
    static_cast<void>(device.save(next));
    memory.left_ = Memory::no_cut;
    const Device restarted{memory};
    claim(!restarted.store.is_damaged());
    claim((restarted.value() == last) || (restarted.value() == next));
    claim((cut != bytes_of_a_save) || (restarted.value() == next));
}

}  // namespace canproof::proofs
