// The objects of a program, and what they hold on a path.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/prove/address.hpp"
#include "host/prove/contents.hpp"

namespace canproof::host::prove {

/// What does not change about an object.
struct Object {
    std::string name;
    Term size;  ///< 64 bits
    std::uint64_t alignment{1};
    bool writable{true};
    ContentsPointer initial{};  ///< of a global; empty for what a function makes
};

/// All objects that a proof has met; none is ever removed.
class Objects {
  public:
    ObjectId add(Object object);
    void initialise(ObjectId id, ContentsPointer contents) { all_[id].initial = std::move(contents); }
    const Object& operator[](ObjectId id) const { return all_[id]; }
    std::size_t size() const { return all_.size(); }

  private:
    std::vector<Object> all_;
};

/// What the objects hold on one path. An object without contents is not there any more.
class Memory {
  public:
    void set(ObjectId id, ContentsPointer contents) { changed_[id] = std::move(contents); }
    void remove(ObjectId id) { changed_.erase(id); }
    /// Empty where the object is gone.
    ContentsPointer contents(const Objects& objects, ObjectId id) const;
    /// What it held on the one path where `condition` is true, and on the other elsewhere.
    void merge(const Objects& objects, const Term& condition, const Memory& otherwise);

  private:
    std::map<ObjectId, ContentsPointer> changed_;
};

/// Whether `count` bytes from there lie in the object.
Term in_bounds(const Object& object, const Term& offset, const Term& count);

}  // namespace canproof::host::prove
