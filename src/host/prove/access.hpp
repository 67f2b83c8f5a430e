// SPDX-License-Identifier: Apache-2.0
// Reads and writes the memory of the proven program. Each access adds an obligation: it must be inside one object.
#pragma once

#include <string>

#include "host/prove/proof.hpp"
#include "host/prove/state.hpp"

namespace canproof::host::prove {

/// The required alignment of an access in bytes, and its place in the source for messages.
struct AccessSite {
    std::uint64_t alignment{1};
    std::string where;
};

Term load(Proof& proof, const State& state, const Term& address, unsigned bytes, const AccessSite& site);
void store(Proof& proof, State& state, const Term& address, const Term& word, const AccessSite& site);
/// Copies `count` bytes, as memmove and memcpy do. `count` has 64 bits.
void copy(Proof& proof, State& state, const Term& to, const Term& from, const Term& count, const std::string& where);
void fill(Proof& proof, State& state, const Term& to, const Term& byte, const Term& count, const std::string& where);
/// Returns the address plus `by` bytes. With `within_object`, adds the obligation that the result is in the object of
/// the address or directly behind its end.
Term moved(Proof& proof, const State& state, const Term& address, const Term& by, bool within_object,
           const std::string& where);
/// Returns the difference of two addresses. Where both are in the same object, this is the difference of their offsets.
/// Returns nothing when one of them is no address.
std::optional<Term> difference(const Proof& proof, const Term& a, const Term& b);
/// These functions compare two addresses: equal_addresses() returns whether they are equal, below() whether the first
/// one is lower. Addresses in two different objects are never equal; the address in the object with the smaller number
/// is the lower one.
Term equal_addresses(const Proof& proof, const Term& a, const Term& b);
Term below(const Proof& proof, const Term& a, const Term& b);

}  // namespace canproof::host::prove
