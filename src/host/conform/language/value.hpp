// SPDX-License-Identifier: Apache-2.0
// The value of a variable in a conformance case: a number or bytes, possibly with fields.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace canproof::host::conform {

using Bytes = std::vector<std::uint8_t>;

struct Value;
/// A function that returns the field with a given name; nothing when the value has no such field.
using Fields = std::function<std::optional<Value>(const std::string&)>;

struct Value {
    std::int64_t number{0};
    std::optional<Bytes> bytes;
    Fields fields;

    Value() = default;
    explicit Value(std::int64_t of) : number{of} {}
    explicit Value(Bytes of) : bytes{std::move(of)} {}
};

/// Reports that a step cannot be done as it is written. The case is broken, and the slave is not judged.
class BrokenCase : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Returns the number of a value, or its bytes as a little-endian unsigned number. Throws BrokenCase for more than
/// eight bytes.
std::int64_t number_of(const Value& value);
/// Returns the bytes of a value. Throws BrokenCase for a value without bytes, because the width of a number is not
/// known.
const Bytes& bytes_of(const Value& value);
/// Returns the lowest `count` bytes of a number, little-endian.
Bytes little_endian(std::int64_t number, std::size_t count);
/// Returns `count` bytes from `start` on as a little-endian unsigned number. Missing bytes count as 0.
std::int64_t from_little_endian(const Bytes& bytes, std::size_t start, std::size_t count);
/// Returns the value for messages: `1234 (4D2h)` or `73 61 76 65`.
std::string words_of(const Value& value);
/// Returns the bytes in hexadecimal, `73 61 76 65`, cut after 64 bytes.
std::string hex_words(const Bytes& bytes);
/// Returns whether two values are equal. Compares bytes if both are bytes, otherwise numbers.
bool same(const Value& a, const Value& b);

/// The variables of a case, or of one call of a procedure. A variable that this scope does not have is looked up in the
/// scope of the caller (`outer`).
class Scope {
  public:
    explicit Scope(const Scope* outer = nullptr) : outer_{outer} {}

    void set(const std::string& name, Value value) { values_[name] = std::move(value); }
    const Value* find(const std::string& name) const {
        const auto found = values_.find(name);
        return found != values_.end() ? &found->second : outer_ == nullptr ? nullptr : outer_->find(name);
    }

  private:
    const Scope* outer_;
    std::map<std::string, Value> values_;
};

}  // namespace canproof::host::conform
