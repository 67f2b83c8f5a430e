// SPDX-License-Identifier: Apache-2.0
// The LSS store when the power fails: it has the old configuration or the new one, never a mixture.
#include "firmware/canopen/lss_store.hpp"

#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

/// Memory for both slots whose power fails after a number of bytes; later writes have no effect.
class CutMemory final : public NonVolatileMemory {
  public:
    std::size_t size() const override { return bytes_.size(); }
    bool read(const std::size_t at, MutableBytes to) const override {
        to.copy(0U, ByteView{bytes_}.part(at, to.size()));
        return true;
    }
    bool write(const std::size_t at, const ByteView bytes) override {
        for (std::size_t i = 0U; i < bytes.size(); ++i) {
            if (left_ != 0U) {
                bytes_[at + i] = bytes[i];
                --left_;
            }
        }
        return true;
    }
    bool commit() override { return true; }

    std::array<std::uint8_t, LssStore::size> bytes_{};
    std::size_t left_{1000U};
};

/// A save writes a void marker, 20 bytes and two markers.
constexpr std::size_t bytes_of_a_save = 23U;

LssConfiguration any_configuration() {
    LssConfiguration configuration{any<std::uint8_t>(), any<std::uint32_t>(), false};
    assume(is_lss_node_id(configuration.node_id));
    return configuration;
}

bool same(const LssConfiguration& a, const LssConfiguration& b) {
    return (a.node_id == b.node_id) && (a.bit_rate == b.bit_rate) && !a.damaged && !b.damaged;
}

/// Cuts the power after each number of bytes of a save that follows `saves` others.
void cut_a_save_behind(const std::size_t saves) {
    const LssConfiguration shipped = any_configuration();
    const LssConfiguration next = any_configuration();
    LssConfiguration last = shipped;
    CutMemory before{};
    for (std::size_t i = 0U; i < saves; ++i) {
        last = any_configuration();
        claim(LssStore{before}.store(last) == LssError::none);
    }
    claim(same(LssStore{before}.load(shipped), last));
    for (std::size_t cut = 0U; cut <= bytes_of_a_save; ++cut) {
        CutMemory memory{};
        memory.bytes_ = before.bytes_;
        memory.left_ = cut;
        static_cast<void>(LssStore{memory}.store(next));
        memory.left_ = 1000U;
        const LssConfiguration loaded = LssStore{memory}.load(shipped);
        claim(same(loaded, last) || same(loaded, next));
        claim((cut != bytes_of_a_save) || same(loaded, next));
    }
}

}  // namespace

void the_first_lss_save_is_whole_or_not_at_all() {
    shows("the first save, cut after any byte, loads as shipped or as saved, for every node-ID and bit rate");
    proves<req::CO_LSS_016, req::CO_LSS_017, req::CO_LSS_020, req::CO_LSS_076>();
    cut_a_save_behind(0U);
}

void a_later_lss_save_is_whole_or_not_at_all() {
    shows("a save behind another, cut after any byte, loads as saved before or as saved now");
    proves<req::CO_LSS_016, req::CO_LSS_017, req::CO_LSS_020, req::CO_LSS_076>();
    cut_a_save_behind(1U);
}

void a_third_lss_save_is_whole_or_not_at_all() {
    shows("a save behind two others, which takes the place of the first, loads as saved before or as saved now");
    proves<req::CO_LSS_016, req::CO_LSS_017, req::CO_LSS_020, req::CO_LSS_076>();
    cut_a_save_behind(2U);
}

}  // namespace canproof::proofs
