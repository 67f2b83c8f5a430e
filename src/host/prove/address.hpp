// Addresses as terms: each object of the program has a base of its own, far from all others.
#pragma once

#include <optional>
#include <vector>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

/// Number of an object: index into Objects.
using ObjectId = unsigned;

/// Where an address lies when `when` holds: so many bytes behind the start of an object. Without an object it is a
/// plain number, such as null.
struct Place {
    Term when;
    std::optional<ObjectId> object;
    Term offset;
};

/// The address of an object's first byte.
Term base_of(z3::context& context, ObjectId object);

/// Every place that an address may mean, each object at most once. An address is a base plus offsets, or a choice
/// between addresses; what is neither comes out as a place without an object.
std::vector<Place> places_of(const Term& address, std::size_t objects);

/// The same address built from its places: what was added to a base is one term.
Term address_at(z3::context& context, const std::vector<Place>& places);

}  // namespace canproof::host::prove
