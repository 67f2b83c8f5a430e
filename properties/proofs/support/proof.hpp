// SPDX-License-Identifier: Apache-2.0
// The functions with which a harness (a function in properties/proofs) states a theorem. A harness leaves some values
// open: they can be anything. It assumes conditions, calls the firmware and claims a result. `canproof prove` shows
// that every claim holds for all open values, and that no undefined behaviour occurs. src/host/prove/README.md
// describes how.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

// The prover implements these functions; replay.cpp implements them when a counterexample runs natively.
extern "C" {
void canproof_any(void* at, std::size_t bytes) noexcept;
void canproof_any_state(void* at, std::size_t bytes) noexcept;
std::uint8_t* canproof_any_memory(std::size_t bytes) noexcept;
std::uint8_t canproof_each(std::size_t count) noexcept;
void canproof_assume(bool holds, const char* file, unsigned line) noexcept;
void canproof_claim(bool holds, unsigned line) noexcept;
void canproof_loop(const char* function, std::size_t number, const char* variables, std::size_t most, void* changed,
                   std::size_t bytes, bool (*holds)(const void*, std::size_t, std::uint64_t, std::uint64_t),
                   const void* context) noexcept;
void canproof_contract(const char* function, const char* theorem, void (*stands_for)()) noexcept;
void canproof_shows(const char* statement) noexcept;
void canproof_seed(const char* target, const std::uint8_t* input, std::size_t bytes) noexcept;
void canproof_proves(const char* requirement) noexcept;
}

namespace canproof::proofs {

/// States in one sentence what the theorem shows.
inline void shows(const char* const statement) noexcept {
    canproof_shows(statement);
}

/// Names the requirements that the theorem shows; a misspelt requirement, or one that was withdrawn, gives a compile
/// error.
template <typename... Requirements>
void proves() noexcept {
    (canproof_proves(Requirements::id), ...);
}

/// Assumes that `holds` is true: excludes the open values for which it is false. The table of theorems shows the source
/// line of the assumption.
inline void assume(const bool holds, const char* const file = __builtin_FILE(),
                   const unsigned line = __builtin_LINE()) noexcept {
    canproof_assume(holds, file, line);
}

/// Claims that the condition holds. `line` is the source line of the claim.
inline void claim(const bool holds, const unsigned line = __builtin_LINE()) noexcept {
    canproof_claim(holds, line);
}

/// Offers `input` to the fuzz target `target`. With this input, the fuzz target does the same as the harness with its
/// open values. `canproof prove --seeds` writes the input of a counterexample to a file. A harness calls this function
/// before the call of the firmware that may fail.
template <std::size_t N>
void fuzz_seed(const char* const target, const std::array<std::uint8_t, N>& input) noexcept {
    canproof_seed(target, input.data(), N);
}

/// Gives an object any value: each of its bytes is open, except the bytes of pointers. A bool is 0 or 1.
template <typename T>
void leave_open(T& object) noexcept {
    canproof_any_state(&object, sizeof(T));
}

/// Returns any value of the type T: every bit of a number is open (it can be 0 or 1).
template <typename T>
T any() noexcept {
    T value{};
    if constexpr (std::is_same_v<T, bool>) {
        std::uint8_t byte{0U};
        canproof_any(&byte, sizeof(byte));
        value = (byte & 1U) != 0U;
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
        canproof_any(&value, sizeof(T));
    } else {
        leave_open(value);
    }
    return value;
}

/// Returns each number below `count` (1…256) in turn: the prover proves the theorem separately for each number, and it
/// must hold for all of them.
inline std::uint8_t each(const std::size_t count) noexcept {
    return canproof_each(count);
}

/// Returns memory of `size` (at most 2^32) bytes of any value; `size` may be open itself.
inline std::uint8_t* any_memory(const std::size_t size) noexcept {
    return canproof_any_memory(size);
}
constexpr std::size_t most_memory = std::size_t{1U} << 32U;

/// Returns a size that memory can have.
inline std::size_t any_size() noexcept {
    const std::size_t size = any<std::size_t>();
    assume(size <= most_memory);
    return size;
}

}  // namespace canproof::proofs
