// SPDX-License-Identifier: Apache-2.0
// A save of the LSS store that the power cuts after any byte.
#pragma once

#include "firmware/canopen/lss_store.hpp"
#include "properties/proofs/support/cut_memory.hpp"

namespace canproof::proofs {

using Memory = CutMemory<LssStore::size>;

/// A save writes 23 bytes: a marker that makes the new slot invalid, the 20 bytes of the slot, a marker that makes the
/// slot valid, and a marker that makes the old slot invalid.
constexpr std::size_t bytes_of_a_save = 23U;

inline LssConfiguration any_configuration() {
    LssConfiguration configuration{any<std::uint8_t>(), any<std::uint32_t>(), false};
    assume(is_lss_node_id(configuration.node_id));
    return configuration;
}

inline bool same(const LssConfiguration& a, const LssConfiguration& b) {
    return (a.node_id == b.node_id) && (a.bit_rate == b.bit_rate) && !a.damaged && !b.damaged;
}

/// Cuts the power after `cut` bytes of a save of `next`. Claims that the store then loads `last` or `next`, and that it
/// loads `next` if the save was complete.
inline void cut_a_save(Memory::Bytes bytes, const std::size_t cut, const LssConfiguration& shipped,
                       const LssConfiguration& last, const LssConfiguration& next) {
    Memory memory{bytes};
    memory.left_ = cut;
    static_cast<void>(LssStore{memory}.store(next));
    memory.left_ = Memory::no_cut;
    const LssConfiguration loaded = LssStore{memory}.load(shipped);
    claim(same(loaded, last) || same(loaded, next));
    claim((cut != bytes_of_a_save) || same(loaded, next));
}

/// Cuts the power after each possible number of bytes of a save that follows `saves` other saves.
inline void cut_a_save_behind(const std::size_t saves) {
    const LssConfiguration shipped = any_configuration();
    const LssConfiguration next = any_configuration();
    LssConfiguration last = shipped;
    Memory::Bytes stored{};
    Memory before{stored};
    for (std::size_t i = 0U; i < saves; ++i) {
        last = any_configuration();
        claim(LssStore{before}.store(last) == LssError::none);
    }
    claim(same(LssStore{before}.load(shipped), last));
    for (std::size_t cut = 0U; cut <= bytes_of_a_save; ++cut) {
        cut_a_save(stored, cut, shipped, last, next);
    }
}

}  // namespace canproof::proofs
