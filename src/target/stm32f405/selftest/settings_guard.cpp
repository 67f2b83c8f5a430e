// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/selftest/settings_guard.hpp"

#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/selftest/core.hpp"
#include "target/stm32f405/selftest/state_guard.hpp"

namespace canproof::stm32f405 {

namespace {

std::uint32_t add(const std::uint32_t sum, const ByteView words) noexcept {
    return core_sum(sum, words.data(), static_cast<std::uint32_t>(words.size() / sizeof(std::uint32_t)));
}

/// Returns the bytes of all lines, which are one block of memory.
ByteView bytes_of(const Slots<PdoLine>& lines) noexcept {
    return lines.empty() ? ByteView{} : ByteView{object_bytes(lines[0U]).data(), lines.size() * sizeof(PdoLine)};
}

/// Adds the settings of all PDOs of one direction, and the lines of their mappings.
template <typename Settings, typename Pdo>
std::uint32_t add_pdos(const std::uint32_t sum, const Slots<Pdo>& pdos, const Slots<PdoLine>& lines) noexcept {
    std::uint32_t total{sum};
    for (const Settings& pdo : pdos) {
        total = add(total, object_bytes(pdo));
    }
    return add(total, bytes_of(lines));
}

std::uint32_t sum_of(const NodeSettings& settings) noexcept {
    std::uint32_t sum = add(0U, settings.values);
    sum = add_pdos<ReceivePdoSettings>(sum, settings.received, settings.received_lines);
    return add_pdos<TransmitPdoSettings>(sum, settings.sent, settings.sent_lines);
}

}  // namespace

static_assert(implements<req::CO_SELF_019>);
void SettingsGuard::keep(const NodeSettings& settings) noexcept {
    changes_ = settings.changes;
    complement_ = ~sum_of(settings);
}

static_assert(implements<req::CO_SELF_019>);
bool SettingsGuard::follow(const NodeSettings& settings) noexcept {
    const std::uint32_t sum = sum_of(settings);
    const bool sound = (settings.changes != changes_) || (complement_ == ~sum);
    changes_ = settings.changes;
    complement_ = ~sum;
    return sound;
}

}  // namespace canproof::stm32f405
