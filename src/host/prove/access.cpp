// SPDX-License-Identifier: Apache-2.0
#include "host/prove/access.hpp"

#include <algorithm>

#include "host/prove/order.hpp"
#include "host/prove/unknown.hpp"

namespace canproof::host::prove {

namespace {

constexpr std::uint64_t most_filled = 65536;

Term aligned(const Object& object, const Term& offset, std::uint64_t alignment) {
    z3::context& context = offset.ctx();
    if (alignment <= 1) {
        return context.bool_val(true);
    }
    if (object.alignment < alignment) {
        return context.bool_val(false);
    }
    const Term rest = offset & constant(context, alignment - 1, address_width);
    return (rest == constant(context, 0, address_width)).simplify();
}

/// Returns the places (possible objects and offsets) of an address. Leaves out a place whose object does not exist in
/// this state.
std::vector<Place> live_places(const Proof& proof, const State& state, const Term& address) {
    std::vector<Place> live;
    for (const Place& one : places_of(address, proof.objects.size())) {
        if (one.object && state.memory.contents(proof.objects, *one.object)) {
            live.push_back(one);
        }
    }
    return live;
}

/// Returns the condition under which an access is valid: the address is one of these places, `count` bytes from there
/// are inside the object, and the alignment is right. With `writes`, the object must not be constant.
Term means_one(Proof& proof, const std::vector<Place>& places, const Term& count, const AccessSite& site, bool writes) {
    std::vector<Term> good;
    for (const Place& one : places) {
        const Object& object = proof.objects[*one.object];
        if (!writes || object.writable) {
            good.push_back(one.when && in_bounds(object, one.offset, count) &&
                           aligned(object, one.offset, site.alignment));
        }
    }
    return any_of(proof.context, good);
}

void change(const Proof& proof, State& state, const Place& place, const ContentsPointer& next) {
    const ContentsPointer now = state.memory.contents(proof.objects, *place.object);
    state.memory.set(*place.object, is_true(place.when) ? next : next->merged(place.when, now));
}

Term count_of(Proof& proof, std::uint64_t count) {
    return constant(proof.context, count, address_width);
}

/// Greatest size in bytes of an object that is accessed as a whole when the offset is not a constant.
constexpr std::uint64_t small_object = 64;

/// Finds by bisection the least number up to `most` for which `holds` returns true. If `holds` is true for a number, it
/// must be true for all greater numbers. Returns `most` when `holds` is true for no smaller number.
template <typename Holds>
std::uint64_t least(std::uint64_t most, const Holds& holds) {
    std::uint64_t low = 0;
    while (low < most) {
        const std::uint64_t middle = low + (most - low) / 2;
        if (holds(middle)) {
            most = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

/// Returns the bytes of an object that an access to a place may reach on this path. The other bytes of the object stay
/// unchanged, so that an address stored in them remains known as an address.
Reach reach_of(Proof& proof, const State& state, const Place& place, const Term& count) {
    const auto size = number(proof.objects[*place.object].size);
    if (!size || *size <= small_object || (number(place.offset) && number(count))) {
        return {};
    }
    ReachKey key{proof.solver.node_of(place.when), proof.solver.node_of(place.offset), proof.solver.node_of(count)};
    for (const Term& condition : state.path) {
        key.push_back(proof.solver.node_of(condition));
    }
    const auto known = proof.reaches.find(key);
    if (known != proof.reaches.end()) {
        return known->second;
    }
    const auto possible = [&](const Term& truth) {
        const Term condition = (place.when && truth).simplify();
        return !is_false(condition) &&
               proof.solver.satisfiable(state.path, condition, proof.limits.branch_milliseconds) != Answer::no;
    };
    Reach reach;
    const auto fixed = number(place.offset);
    reach.first =
        fixed ? *fixed
              : least(*size, [&](std::uint64_t at) { return possible(z3::ule(place.offset, count_of(proof, at))); });
    // finds the greatest possible end of the access, by the least possible distance from this end to the end of the
    // object
    reach.end = *size - least(*size, [&](std::uint64_t behind) {
        const Term end = place.offset + count;
        return possible(z3::uge(end, count_of(proof, *size - behind)) && z3::ule(place.offset, end) &&
                        z3::ule(place.offset, count_of(proof, *size)));
    });
    proof.reaches.emplace(key, reach);
    return reach;
}

}  // namespace

Term load(Proof& proof, const State& state, const Term& address, unsigned bytes, const AccessSite& site) {
    const std::vector<Place> places = live_places(proof, state, address);
    proof.obligations.add(state.path, means_one(proof, places, count_of(proof, bytes), site, false),
                          "a read of " + std::to_string(bytes) + " byte(s) lies in its object", site.where);
    std::optional<Term> value;
    for (const Place& one : places) {
        const Term word = state.memory.contents(proof.objects, *one.object)
                              ->read(one.offset, bytes, reach_of(proof, state, one, count_of(proof, bytes)));
        value = value ? choose(one.when, word, *value) : word;
    }
    return value ? *value : proof.fresh(byte_width * bytes);
}

void store(Proof& proof, State& state, const Term& address, const Term& word, const AccessSite& site) {
    const unsigned bytes = width_of(word) / byte_width;
    const std::vector<Place> places = live_places(proof, state, address);
    proof.obligations.add(state.path, means_one(proof, places, count_of(proof, bytes), site, true),
                          "a write of " + std::to_string(bytes) + " byte(s) lies in its object", site.where);
    for (const Place& one : places) {
        const ContentsPointer now = state.memory.contents(proof.objects, *one.object);
        change(proof, state, one, now->written(one.offset, word, reach_of(proof, state, one, count_of(proof, bytes))));
    }
}

void copy(Proof& proof, State& state, const Term& to, const Term& from, const Term& count, const std::string& where) {
    const std::vector<Place> targets = live_places(proof, state, to);
    const std::vector<Place> sources = live_places(proof, state, from);
    const Term nothing = (count == count_of(proof, 0)).simplify();
    const AccessSite site{1, where};
    proof.obligations.add(state.path, nothing || means_one(proof, sources, count, site, false),
                          "the bytes to copy lie in their object", where);
    proof.obligations.add(state.path, nothing || means_one(proof, targets, count, site, true),
                          "the target of a copy lies in its object", where);
    if (is_true(nothing)) {
        return;
    }
    const State before = state;
    for (const Place& target : targets) {
        ContentsPointer next = before.memory.contents(proof.objects, *target.object);
        const ContentsPointer now = next;
        const Reach reach = reach_of(proof, before, target, count);
        for (const Place& source : sources) {
            const ContentsPointer taken = before.memory.contents(proof.objects, *source.object);
            const ContentsPointer copied = now->copied(target.offset, taken, source.offset, count, reach);
            next = is_true(source.when) ? copied : copied->merged(source.when, next);
        }
        change(proof, state, target, next);
    }
}

void fill(Proof& proof, State& state, const Term& to, const Term& byte, const Term& count, const std::string& where) {
    const auto bytes = number(count);
    if (!bytes || *bytes > most_filled) {
        throw Unknown{
            where +
            ": canproof prove does not support filling memory whose size is not a constant of at most 65536 bytes"};
    }
    const std::vector<Place> targets = live_places(proof, state, to);
    const Term nothing = proof.context.bool_val(*bytes == 0);
    proof.obligations.add(state.path, nothing || means_one(proof, targets, count, {1, where}, true),
                          "the bytes to fill lie in their object", where);
    for (const Place& target : targets) {
        ContentsPointer next = state.memory.contents(proof.objects, *target.object);
        for (std::uint64_t i = 0; i < *bytes; ++i) {
            next = next->written((target.offset + count_of(proof, i)).simplify(), byte, {});
        }
        change(proof, state, target, next);
    }
}

Term moved(Proof& proof, const State& state, const Term& address, const Term& by, bool within_object,
           const std::string& where) {
    if (const auto none = number(by); none && *none == 0) {
        return address;
    }
    std::vector<Place> places = places_of(address, proof.objects.size());
    std::vector<Term> good;
    for (Place& one : places) {
        one.offset = (one.offset + by).simplify();
        if (one.object) {
            good.push_back(one.when && at_most(one.offset, proof.objects[*one.object].size));
        } else {
            good.push_back(one.when && by == count_of(proof, 0));
        }
    }
    if (within_object) {
        proof.obligations.add(state.path, any_of(proof.context, good),
                              "an address stays in its object, or one past its end", where);
    }
    return address_at(proof.context, places);
}

std::optional<Term> difference(const Proof& proof, const Term& a, const Term& b) {
    const std::vector<Place> left = places_of(a, proof.objects.size());
    const std::vector<Place> right = places_of(b, proof.objects.size());
    const auto is_address = [](const Place& place) { return place.object.has_value(); };
    if (std::none_of(left.begin(), left.end(), is_address) || std::none_of(right.begin(), right.end(), is_address)) {
        return std::nullopt;
    }
    std::optional<Term> all;
    for (const Place& one : left) {
        for (const Place& other : right) {
            const Term when = (one.when && other.when).simplify();
            if (is_false(when)) {
                continue;
            }
            const Term value = one.object == other.object
                                   ? (one.offset - other.offset).simplify()
                                   : (address_at(a.ctx(), {one}) - address_at(a.ctx(), {other})).simplify();
            all = all ? choose(when, value, *all) : value;
        }
    }
    return all;
}

namespace {

/// Compares two addresses. Under the condition that both are in the same object, the result is what `alike` returns for
/// the two offsets; otherwise it is what `apart` returns for the two places.
template <typename Alike, typename Apart>
Term compared(const Proof& proof, const Term& a, const Term& b, const Alike& alike, const Apart& apart) {
    std::vector<Term> cases;
    for (const Place& left : places_of(a, proof.objects.size())) {
        for (const Place& right : places_of(b, proof.objects.size())) {
            const Term result = left.object == right.object ? alike(left.offset, right.offset) : apart(left, right);
            cases.push_back(left.when && right.when && result);
        }
    }
    return any_of(a.ctx(), cases);
}

}  // namespace

Term equal_addresses(const Proof& proof, const Term& a, const Term& b) {
    return compared(
        proof, a, b, [](const Term& left, const Term& right) { return left == right; },
        [](const Place& left, const Place&) { return left.offset.ctx().bool_val(false); });
}

Term below(const Proof& proof, const Term& a, const Term& b) {
    return compared(
        proof, a, b, [](const Term& left, const Term& right) { return z3::ult(left, right); },
        [](const Place& left, const Place& right) {
            return left.offset.ctx().bool_val(left.object.value_or(0) < right.object.value_or(0));
        });
}

}  // namespace canproof::host::prove
