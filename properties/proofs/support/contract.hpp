// SPDX-License-Identifier: Apache-2.0
// Lets a theorem use the contract of a function, which another theorem proves, in place of the function's code.
#pragma once

#include <cstring>

#include "properties/invariants/both.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

/// The bytes of an object before a call. The theorem about a contract claims with them that the function changes only
/// those members which the contract gives any values.
template <typename T>
class Before {
  public:
    explicit Before(const T& object) noexcept : object_{&object} { std::memcpy(bytes_.data(), &object, sizeof(T)); }

    /// Returns whether all bytes of the object outside these members are as before.
    template <typename... Members>
    bool holds_except(const Members&... members) const noexcept {
        const auto* const now = reinterpret_cast<const std::uint8_t*>(object_);
        bool same{true};
        for (std::size_t i = 0U; i < sizeof(T); ++i) {
            if (!(is_in(&now[i], members) || ...)) {
                same = both(same, now[i] == bytes_[i]);
            }
        }
        return same;
    }

  private:
    template <typename Member>
    static bool is_in(const std::uint8_t* const byte, const Member& member) noexcept {
        const auto* const first = reinterpret_cast<const std::uint8_t*>(&member);
        return (byte >= first) && (byte < (first + sizeof(Member)));
    }

    const T* object_;
    std::array<std::uint8_t, sizeof(T)> bytes_{};
};

/// Lets each call of `function` ("TransmitQueue::push") execute `stands_for` instead, a function of a harness with the
/// same parameters; an object comes first, as a reference. It claims what the contract demands, gives what the function
/// changes any values, and assumes what the contract promises. `theorem` is the name of the theorem that shows that
/// the function keeps the contract. Without a proof of this theorem, the theorem that uses the contract is unknown.
template <typename Result, typename... Parameters>
void use_contract(const char* const function, const char* const theorem,
                  Result (*const stands_for)(Parameters...) noexcept) noexcept {
    canproof_contract(function, theorem, reinterpret_cast<void (*)()>(stands_for));
}

}  // namespace canproof::proofs
