// SPDX-License-Identifier: Apache-2.0
// States the invariant of a loop, so that a theorem covers any number of its passes.
#pragma once

#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

/// An outermost loop of a function that the theorem calls.
struct LoopOf {
    const char* function;       ///< name, with its class: "Crc16::add"
    const char* variables{""};  ///< names of at most two local variables that the invariant is about: "kept waiting"
    std::uint32_t number{0U};   ///< of the outermost loops of the function, in the order of the source
};

/// Returns whether an invariant holds after `passes` passes. The invariant takes the values of the variables that
/// LoopOf names, as far as it needs them.
template <typename Invariant>
bool holds_after(const Invariant& invariant, const std::size_t passes, const std::uint64_t first,
                 const std::uint64_t second) noexcept {
    if constexpr (std::is_invocable_v<Invariant, std::size_t, std::uint64_t, std::uint64_t>) {
        return invariant(passes, first, second);
    } else if constexpr (std::is_invocable_v<Invariant, std::size_t, std::uint64_t>) {
        return invariant(passes, first);
    } else {
        return invariant(passes);
    }
}

/// States an invariant of a loop of a function, which the theorem then calls. The prover shows that the invariant holds
/// before the first pass, that one pass from any state in which it holds makes it hold again, and that there are at
/// most `most_passes` passes. Behind the loop, the prover knows only the invariant, and that the loop ended.
///
/// `changed` is the object that the loop changes, with `bytes` bytes; the prover shows that it changes no other. Its
/// pointers keep their values.
template <typename Invariant>
void state_invariant_of(const LoopOf& loop, const std::size_t most_passes, void* const changed, const std::size_t bytes,
                        const Invariant& invariant) noexcept {
    const auto holds = [](const void* const context, const std::size_t passes, const std::uint64_t first,
                          const std::uint64_t second) noexcept {
        return holds_after(*static_cast<const Invariant*>(context), passes, first, second);
    };
    canproof_loop(loop.function, loop.number, loop.variables, most_passes, changed, bytes, holds, &invariant);
}

template <typename Changed, typename Invariant>
void state_invariant(const LoopOf& loop, const std::size_t most_passes, Changed& changed,
                     const Invariant& invariant) noexcept {
    state_invariant_of(loop, most_passes, &changed, sizeof(Changed), invariant);
}

/// States an invariant of a loop that changes local variables only.
template <typename Invariant>
void state_invariant(const LoopOf& loop, const std::size_t most_passes, const Invariant& invariant) noexcept {
    state_invariant_of(loop, most_passes, nullptr, 0U, invariant);
}

/// A sequence of numbers, of which a theorem defines each next one by an assumption. `T` is an unsigned integer.
template <typename T>
class Sequence {
  public:
    /// `last` is the greatest index, at most 2^32 - 1.
    explicit Sequence(const std::size_t last) noexcept {
        for (std::uint8_t*& bytes : bytes_) {
            bytes = any_memory(last + 1U);
        }
    }
    T operator[](const std::size_t at) const noexcept {
        std::uint64_t number{0U};
        for (std::size_t i = 0U; i < sizeof(T); ++i) {
            number |= std::uint64_t{bytes_[i][at]} << (8U * i);
        }
        return static_cast<T>(number);
    }

  private:
    std::array<std::uint8_t*, sizeof(T)> bytes_{};
};

}  // namespace canproof::proofs
