// SPDX-License-Identifier: Apache-2.0
// Theorems about loops over bytes of any number: check sums, and blank banks of stored values. Each theorem states the
// invariant of the loop.
#include "firmware/base/commit_marker.hpp"
#include "firmware/base/crc16.hpp"
#include "firmware/base/crc32.hpp"
#include "properties/proofs/support/crc_by_definition.hpp"
#include "properties/proofs/support/loop.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

/// Memory of fewer than 2^32 bytes, which is all that a microcontroller with addresses of 32 bits can have.
struct Bytes {
    std::size_t size{any<std::uint32_t>()};
    std::uint8_t* memory{any_memory(size)};

    ByteView view() const { return ByteView{memory, size}; }
};

/// The number of passes of the loop that compares all bytes of a bank with the first one.
std::size_t passes_over(const Bytes& bank) {
    return (bank.size == 0U) ? 0U : (bank.size - 1U);
}

/// Claims that a CRC takes each of any bytes once, in order, as `by_definition` takes one byte. `register_of` is the
/// member of the CRC that contains its state, and `State` a number with as many bits as the CRC.
template <typename State, typename Crc, typename Definition>
void claim_each_byte(const LoopOf& loop, std::uint32_t Crc::*const register_of, const Definition& by_definition) {
    const Bytes bytes{};
    Crc crc{};
    crc.*register_of = any<State>();
    const Sequence<State> states{bytes.size};
    assume(states[0] == crc.*register_of);
    const auto invariant = [&](const std::size_t passes) noexcept {
        if (passes < bytes.size) {
            assume(states[passes + 1U] == by_definition(states[passes], bytes.memory[passes]));
        }
        return crc.*register_of == states[passes];
    };
    state_invariant(loop, bytes.size, crc, invariant);
    crc.add(bytes.view());
    claim(crc.*register_of == states[bytes.size]);
}

}  // namespace

void crc16_of_any_bytes_is_that_of_each_byte() {
    shows("CRC-16 of any bytes takes each of them once, in order, as polynomial 1021h says, from every state");
    claim_each_byte<std::uint16_t>({"Crc16::add"}, &Crc16::remainder_, crc16_by_definition);
}

void crc16_takes_bytes_in_a_state_of_any_bits() {
    shows("CRC-16 takes any bytes and any segment, also when bits of its state are set that a CRC of 16 bits lacks");
    const Bytes bytes{};
    Crc16 crc{};
    leave_open(crc);
    const auto invariant = [](const std::size_t) noexcept { return true; };
    state_invariant({"Crc16::add"}, bytes.size, crc, invariant);
    crc.add(bytes.view());
    claim(crc.value() == (crc.remainder_ & 0xFFFFU));
    crc.add_segment(any<std::uint64_t>());
    claim(crc.remainder_ <= 0xFFFFU);
}

void crc32_of_any_bytes_is_that_of_each_byte() {
    shows("CRC-32 of any bytes takes each of them once, in order, as polynomial 04C11DB7h says, from every state");
    claim_each_byte<std::uint32_t>({"Crc32::add"}, &Crc32::register_, crc32_by_definition);
}

void a_bank_that_counts_as_unused_is_void_or_blank() {
    shows("a bank of any size that counts as unused is void, or all its bytes are 00h, or all are FFh");
    const Bytes bank{};
    const std::size_t one = any<std::uint32_t>();
    const auto invariant = [&](const std::size_t passes, const std::uint64_t same) noexcept {
        const bool is_compared = (one < bank.size) && (one <= passes);
        return (same == 0U) || ((same == 1U) && (!is_compared || (bank.memory[one] == bank.memory[0])));
    };
    state_invariant({"is_blank", "same"}, passes_over(bank), invariant);
    const BankState state = state_by_marker(any<bool>(), bank.view(), any<std::uint8_t>());
    const std::uint32_t first = bank.view()[0];
    const bool is_void = bank.view()[commit_marker_at] == void_marker;
    claim((state != BankState::unused) || is_void || (first == 0x00U) || (first == 0xFFU));
    claim((state != BankState::unused) || is_void || (one >= bank.size) || (bank.view()[one] == first));
}

void a_blank_bank_counts_as_unused() {
    shows("a readable bank of any size counts as unused when all its bytes are 00h, or all are FFh");
    const Bytes bank{};
    const std::uint8_t every = any<bool>() ? std::uint8_t{0xFFU} : std::uint8_t{0x00U};
    assume((bank.size == 0U) || (bank.view()[0] == every));
    const auto invariant = [&](const std::size_t passes, const std::uint64_t same) noexcept {
        assume(((passes + 1U) >= bank.size) || (bank.view()[passes + 1U] == every));
        return same == 1U;
    };
    state_invariant({"is_blank", "same"}, passes_over(bank), invariant);
    claim(state_by_marker(true, bank.view(), any<std::uint8_t>()) == BankState::unused);
}

void a_bank_of_any_size_is_judged_by_its_marker() {
    shows("a bank of any size that is not unused is damaged when readable and committed, and otherwise doubtful");
    const Bytes bank{};
    const bool readable = any<bool>();
    const auto committed = any<std::uint8_t>();
    const auto invariant = [](const std::size_t, const std::uint64_t same) noexcept { return same <= 1U; };
    state_invariant({"is_blank", "same"}, passes_over(bank), invariant);
    const BankState state = state_by_marker(readable, bank.view(), committed);
    const std::uint8_t marker = bank.view()[commit_marker_at];
    claim(state != BankState::sound);
    claim(readable || (state == BankState::doubtful));
    claim((state == BankState::unused) || ((state == BankState::damaged) == (readable && (marker == committed))));
    claim(!readable || (marker != void_marker) || (state == BankState::unused));
}

}  // namespace canproof::proofs
