// SPDX-License-Identifier: Apache-2.0
// Lets a theorem use the contract of a function, which another theorem proves, in place of the function's code.
#pragma once

#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

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
