// SPDX-License-Identifier: Apache-2.0
// Theorems on the LSS store when the power fails during a save: afterwards it has the old configuration or the new one,
// never a mixture.
#include "firmware/canopen/lss_store.hpp"

#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/cut_memory.hpp"

namespace canproof::proofs {

namespace {

using Memory = CutMemory<LssStore::size>;

/// A save writes 23 bytes: a marker that makes the new slot invalid, the 20 bytes of the slot, a marker that makes the
/// slot valid, and a marker that makes the old slot invalid.
constexpr std::size_t bytes_of_a_save = 23U;

LssConfiguration any_configuration() {
    LssConfiguration configuration{any<std::uint8_t>(), any<std::uint32_t>(), false};
    assume(is_lss_node_id(configuration.node_id));
    return configuration;
}

bool same(const LssConfiguration& a, const LssConfiguration& b) {
    return (a.node_id == b.node_id) && (a.bit_rate == b.bit_rate) && !a.damaged && !b.damaged;
}

/// Cuts the power after `cut` bytes of a save of `next`. Claims that the store then loads `last` or `next`, and that it
/// loads `next` if the save was complete.
void cut_a_save(Memory::Bytes bytes, const std::size_t cut, const LssConfiguration& shipped,
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
void cut_a_save_behind(const std::size_t saves) {
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

}  // namespace

void the_first_lss_save_is_whole_or_not_at_all() {
    shows("the first save, cut after any byte, loads as shipped or as saved, for every node-ID and bit rate");
    proves<req::CO_LSS_016, req::CO_LSS_017, req::CO_LSS_020, req::CO_LSS_088>();
    cut_a_save_behind(0U);
}

void a_later_lss_save_is_whole_or_not_at_all() {
    shows("a save behind another, cut after any byte, loads as saved before or as saved now");
    proves<req::CO_LSS_016, req::CO_LSS_017, req::CO_LSS_020, req::CO_LSS_088>();
    cut_a_save_behind(1U);
}

void a_lss_save_is_whole_over_any_memory() {
    shows(
        "over memory of any contents that loads as not damaged, a save, cut after any byte, loads as before or as "
        "saved now, and as saved now when it is complete");
    proves<req::CO_LSS_016, req::CO_LSS_017, req::CO_LSS_020, req::CO_LSS_088>();
    const std::size_t cut = each(bytes_of_a_save + 1U);
    const LssConfiguration shipped = any_configuration();
    const LssConfiguration next = any_configuration();
    auto bytes = any<Memory::Bytes>();
    Memory memory{bytes};
    const LssConfiguration last = LssStore{memory}.load(shipped);
    assume(!last.damaged);
    cut_a_save(bytes, cut, shipped, last, next);
}

}  // namespace canproof::proofs
