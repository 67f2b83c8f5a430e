// Reads and writes of memory. That each lies in one object is an obligation.
#pragma once

#include <string>

#include "host/prove/proof.hpp"
#include "host/prove/state.hpp"

namespace canproof::host::prove {

/// An access: how aligned its address must be, and where it stands in the source.
struct AccessSite {
    std::uint64_t alignment{1};
    std::string where;
};

Term load(Proof& proof, const State& state, const Term& address, unsigned bytes, const AccessSite& site);
void store(Proof& proof, State& state, const Term& address, const Term& word, const AccessSite& site);
/// memmove; memcpy as well. `count` of 64 bits.
void copy(Proof& proof, State& state, const Term& to, const Term& from, const Term& count, const std::string& where);
void fill(Proof& proof, State& state, const Term& to, const Term& byte, const Term& count, const std::string& where);
/// The address moved by so many bytes. It must stay in its object, or one past its end.
Term moved(Proof& proof, const State& state, const Term& address, const Term& by, bool within_object,
           const std::string& where);
/// Whether two addresses are equal, or the first lies below the second. Addresses of two objects are never equal.
Term equal_addresses(const Proof& proof, const Term& a, const Term& b);
Term below(const Proof& proof, const Term& a, const Term& b);

}  // namespace canproof::host::prove
