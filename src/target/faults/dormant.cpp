// SPDX-License-Identifier: Apache-2.0
#include "target/faults/dormant.hpp"

#include "target/faults/machine.hpp"
#include "target/faults/record.hpp"
#include "target/faults/watch.hpp"

namespace canproof::faults {

namespace {

constexpr std::uint32_t blocks = most_ram / block_bytes;

/// For each block, a pass from which on the device does not use the block; 0 when none is known.
std::uint32_t unused_from[blocks];
/// The inverted bits of unused_from. A device with a fault can have changed one of the two.
std::uint32_t complement[blocks];
std::uint32_t watched_block;
std::uint32_t watched_from;

std::uint32_t block_of(std::uint32_t address) {
    return (address - ram_start()) / block_bytes;
}

void learn(std::uint32_t block, std::uint32_t pass) {
    unused_from[block] = pass;
    complement[block] = ~pass;
}

/// Returns 0 when nothing is known about the block.
std::uint32_t known_from(std::uint32_t block) {
    return unused_from[block] == ~complement[block] ? unused_from[block] : 0U;
}

bool differs_only_in(std::uint32_t address, std::uint32_t bit, std::uint32_t pass) {
    auto* const byte = reinterpret_cast<volatile std::uint8_t*>(static_cast<std::uintptr_t>(address));
    const std::uint8_t inverted = *byte;
    *byte = static_cast<std::uint8_t>(inverted ^ (1U << bit));
    const bool same = state_is_recorded(pass);
    *byte = inverted;
    return same;
}

}  // namespace

void load_dormancy() {
    const auto* const known = reinterpret_cast<const std::uint32_t*>(unused_address);
    for (std::uint32_t i = 0; i < blocks; ++i) {
        learn(i, known[i]);
    }
}

bool is_dormant(std::uint32_t address, std::uint32_t bit, std::uint32_t pass) {
    if (address >= ram_start() + variable_bytes() || !differs_only_in(address, bit, pass)) {
        return false;
    }
    const std::uint32_t block = block_of(address);
    if (known_from(block) != 0U && known_from(block) <= pass + 1U) {
        return true;
    }
    watched_block = block;
    watched_from = pass + 1U;
    watch_block(address);
    return false;
}

void end_dormancy() {
    if (is_unused() && (known_from(watched_block) == 0U || watched_from < known_from(watched_block))) {
        learn(watched_block, watched_from);
        say("unused ");
        say_number(watched_block);
        say(" ");
        say_number(watched_from);
        say("\n");
    }
    end_watch();
}

}  // namespace canproof::faults
