// SPDX-License-Identifier: Apache-2.0
// Reads and writes of the memory of the proven program. Each of them adds an obligation: the access must lie inside one
// object.
#pragma once

#include <string>

#include "host/prove/proof.hpp"
#include "host/prove/state.hpp"

namespace canproof::host::prove {

/// Conditions of an access beside its address: the alignment that the address must have, and the place in the source,
/// for messages.
struct AccessSite {
    std::uint64_t alignment{1};
    std::string where;
};

Term load(Proof& proof, const State& state, const Term& address, unsigned bytes, const AccessSite& site);
void store(Proof& proof, State& state, const Term& address, const Term& word, const AccessSite& site);
/// Does what memmove and memcpy do. `count` has 64 bits.
void copy(Proof& proof, State& state, const Term& to, const Term& from, const Term& count, const std::string& where);
void fill(Proof& proof, State& state, const Term& to, const Term& byte, const Term& count, const std::string& where);
/// Returns the address plus `by` bytes. With `within_object`, adds the obligation that the result stays in the object
/// of the address or is one past its end.
Term moved(Proof& proof, const State& state, const Term& address, const Term& by, bool within_object,
           const std::string& where);
/// The comparisons of two addresses: are they equal, and is the first one lower? Addresses of two different objects are
/// never equal; the address in the object with the smaller number is lower.
Term equal_addresses(const Proof& proof, const Term& a, const Term& b);
Term below(const Proof& proof, const Term& a, const Term& b);

}  // namespace canproof::host::prove
