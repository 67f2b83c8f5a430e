// SPDX-License-Identifier: Apache-2.0
// The objects of a program, and their contents on one path.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/prove/address.hpp"
#include "host/prove/contents.hpp"

namespace canproof::host::prove {

/// The properties of an object, which never change.
struct Object {
    std::string name;
    Term size;  ///< in bytes, a term of 64 bits
    std::uint64_t alignment{1};
    bool writable{true};
    ContentsPointer initial{};  ///< initial contents of a global variable; empty for an object that a function makes
};

/// All objects of a proof so far. No object is ever removed.
class Objects {
  public:
    ObjectId add(Object object);
    void initialise(ObjectId id, ContentsPointer contents) { all_[id].initial = std::move(contents); }
    const Object& operator[](ObjectId id) const { return all_[id]; }
    std::size_t size() const { return all_.size(); }

  private:
    std::vector<Object> all_;
};

/// The contents of the objects on one path. An object without contents does not exist on this path, or does not exist
/// any more.
class Memory {
  public:
    void set(ObjectId id, ContentsPointer contents) { changed_[id] = std::move(contents); }
    void remove(ObjectId id) { changed_.erase(id); }
    /// Returns the contents; nothing when the object does not exist on this path.
    ContentsPointer contents(const Objects& objects, ObjectId id) const;
    /// Merges the memory of another path into this one. Each object has its contents of this path where `condition` is
    /// true, and those of the other path where it is false.
    void merge(const Objects& objects, const Term& condition, const Memory& otherwise);

    /// Returns the objects that exist here and in `before`, and whose contents may differ between the two.
    std::vector<ObjectId> changed_since(const Objects& objects, const Memory& before) const;

  private:
    std::map<ObjectId, ContentsPointer> changed_;
};

/// Returns the condition that `count` bytes from `offset` on are inside the object.
Term in_bounds(const Object& object, const Term& offset, const Term& count);

}  // namespace canproof::host::prove
