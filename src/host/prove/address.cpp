// SPDX-License-Identifier: Apache-2.0
#include "host/prove/address.hpp"

#include <unordered_map>

namespace canproof::host::prove {

namespace {

constexpr unsigned spacing = 40;  ///< each object has 2^40 addresses; its base is in the middle of them
constexpr std::uint64_t middle = std::uint64_t{1} << (spacing - 1);

std::uint64_t base_number(ObjectId object) {
    return ((std::uint64_t{object} + 1) << spacing) + middle;
}

class Reader {
  public:
    Reader(z3::context& context, std::size_t objects) : context_{context}, objects_{objects} {}

    std::vector<Place> read(const Term& address) const {
        if (const auto value = number(address)) {
            return {of_number(*value)};
        }
        if (!address.is_app() || !may_be_address(address)) {
            return {plain(address)};
        }
        switch (address.decl().decl_kind()) {
            case Z3_OP_BADD:
                return of_sum(address);
            case Z3_OP_ITE:
                return joined(under(address.arg(0), read(address.arg(1))),
                              under(!address.arg(0), read(address.arg(2))));
            case Z3_OP_CONCAT:
                return of_concatenation(address);
            default:
                return {plain(address)};
        }
    }

  private:
    /// Returns whether a term, such as a sum or a choice, contains the base address of an object. Remembers the result
    /// for each part of the term, because a term can use a part many times.
    bool may_be_address(const Term& term) const {
        if (const auto value = number(term)) {
            return of_number(*value).object.has_value();
        }
        const Z3_decl_kind kind = term.decl().decl_kind();
        if (kind == Z3_OP_CONCAT) {
            return number(term.arg(0)).has_value();
        }
        if (kind != Z3_OP_BADD && kind != Z3_OP_ITE) {
            return false;
        }
        const auto known = looked_at_.find(term.id());
        if (known != looked_at_.end()) {
            return known->second;
        }
        bool may = false;
        for (unsigned i = kind == Z3_OP_ITE ? 1 : 0; i < term.num_args() && !may; ++i) {
            may = may_be_address(term.arg(i));
        }
        looked_at_[term.id()] = may;
        return may;
    }
    Term always() const { return context_.bool_val(true); }
    Place plain(const Term& value) const { return {always(), std::nullopt, value}; }

    Place of_number(std::uint64_t value) const {
        const std::uint64_t at = value >> spacing;
        if (at == 0 || at > objects_) {
            return plain(constant(context_, value, address_width));
        }
        const auto object = static_cast<ObjectId>(at - 1);
        return {always(), object, constant(context_, value - base_number(object), address_width)};
    }

    std::vector<Place> of_sum(const Term& sum) const {
        std::vector<Place> all = read(sum.arg(0));
        for (unsigned i = 1; i < sum.num_args(); ++i) {
            all = added(all, read(sum.arg(i)));
        }
        return all;
    }

    /// Returns the places of an address that is a concatenation. The solver may convert a base plus a short offset into
    /// a concatenation of the upper bits of the base and the bits of the offset.
    std::vector<Place> of_concatenation(const Term& address) const {
        const Term high = address.arg(0);
        const auto value = number(high);
        if (!value) {
            return {plain(address)};
        }
        const unsigned below = address_width - width_of(high);
        const Term low = resized(address.extract(below - 1, 0), address_width);
        return added({of_number(*value << below)}, {plain(low)});
    }

    std::vector<Place> added(const std::vector<Place>& left, const std::vector<Place>& right) const {
        std::vector<Place> all;
        for (const Place& a : left) {
            for (const Place& b : right) {
                const Term when = (a.when && b.when).simplify();
                const Term offset = (a.offset + b.offset).simplify();
                if (is_false(when)) {
                    continue;
                }
                if (a.object && b.object) {  // a sum of two addresses points to no object
                    all.push_back({when, std::nullopt, offset});
                } else {
                    all.push_back({when, a.object ? a.object : b.object, offset});
                }
            }
        }
        return joined(all, {});
    }

    static std::vector<Place> under(const Term& condition, std::vector<Place> places) {
        for (Place& one : places) {
            one.when = (condition && one.when).simplify();
        }
        return places;
    }

    /// Merges two lists of places. In the result, each object occurs at most once.
    static std::vector<Place> joined(const std::vector<Place>& first, const std::vector<Place>& second) {
        std::vector<Place> all;
        for (const auto* list : {&first, &second}) {
            for (const Place& one : *list) {
                bool known = false;
                for (Place& other : all) {
                    if (!known && other.object == one.object) {
                        other.offset = choose(other.when, other.offset, one.offset);
                        other.when = (other.when || one.when).simplify();
                        known = true;
                    }
                }
                if (!known) {
                    all.push_back(one);
                }
            }
        }
        return all;
    }

    z3::context& context_;
    std::size_t objects_;
    mutable std::unordered_map<unsigned, bool> looked_at_{};
};

}  // namespace

Term base_of(z3::context& context, ObjectId object) {
    return constant(context, base_number(object), address_width);
}

std::vector<Place> places_of(const Term& address, std::size_t objects) {
    std::vector<Place> all = Reader{address.ctx(), objects}.read(address);
    for (Place& one : all) {
        one.offset = one.offset.simplify();
    }
    return all;
}

Term address_at(z3::context& context, const std::vector<Place>& places) {
    const auto one = [&context](const Place& place) {
        if (!place.object) {
            return place.offset;
        }
        const Term base = base_of(context, *place.object);
        const auto offset = number(place.offset);
        return offset ? (base + place.offset).simplify() : base + place.offset;
    };
    Term address = one(places.back());
    for (std::size_t i = places.size() - 1; i > 0; --i) {
        address = choose(places[i - 1].when, one(places[i - 1]), address);
    }
    return address;
}

}  // namespace canproof::host::prove
