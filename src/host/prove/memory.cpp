// SPDX-License-Identifier: Apache-2.0
#include "host/prove/memory.hpp"

#include "host/prove/order.hpp"

namespace canproof::host::prove {

ObjectId Objects::add(Object object) {
    all_.push_back(std::move(object));
    return static_cast<ObjectId>(all_.size() - 1);
}

ContentsPointer Memory::contents(const Objects& objects, ObjectId id) const {
    const auto found = changed_.find(id);
    return found == changed_.end() ? objects[id].initial : found->second;
}

void Memory::merge(const Objects& objects, const Term& condition, const Memory& otherwise) {
    for (const auto& [id, theirs] : otherwise.changed_) {
        const ContentsPointer ours = contents(objects, id);
        if (!ours) {
            changed_[id] = theirs;  // the object exists on the other path only: no address on this path points to it
        } else if (ours != theirs) {
            changed_[id] = ours->merged(condition, theirs);
        }
    }
    for (auto& [id, ours] : changed_) {
        const ContentsPointer theirs = otherwise.contents(objects, id);
        if (theirs && otherwise.changed_.find(id) == otherwise.changed_.end() && ours != theirs) {
            ours = ours->merged(condition, theirs);
        }
    }
}

std::vector<ObjectId> Memory::changed_since(const Objects& objects, const Memory& before) const {
    std::vector<ObjectId> all;
    for (const auto& [id, now] : changed_) {
        const ContentsPointer then = before.contents(objects, id);
        if (then && now != then) {
            all.push_back(id);
        }
    }
    return all;
}

Term in_bounds(const Object& object, const Term& offset, const Term& count) {
    return (at_most(count, object.size) && at_most(offset, (object.size - count).simplify())).simplify();
}

}  // namespace canproof::host::prove
