// SPDX-License-Identifier: Apache-2.0
// Addresses as terms. Each object of the program has its own base address. The distance from one base to the next is
// 2^40 bytes.
#pragma once

#include <optional>
#include <vector>

#include "host/prove/terms.hpp"

namespace canproof::host::prove {

/// The number of an object: its index in Objects.
using ObjectId = unsigned;

/// One possible meaning of an address: under the condition `when`, it is the byte at `offset` of `object`. Without an
/// object, it is the plain number `offset`, such as 0 for a null pointer.
struct Place {
    Term when;
    std::optional<ObjectId> object;
    Term offset;
};

/// Returns the address of an object's first byte.
Term base_of(z3::context& context, ObjectId object);

/// Returns every place (object and offset) that an address may be, with each object at most once. The address may be a
/// number, a base plus offsets, or a choice between addresses. Any other term gives a place without an object.
std::vector<Place> places_of(const Term& address, std::size_t objects);

/// Makes an address from its places: a base plus one offset term, or a choice between such sums.
Term address_at(z3::context& context, const std::vector<Place>& places);

}  // namespace canproof::host::prove
