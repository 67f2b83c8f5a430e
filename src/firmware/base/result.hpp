// SPDX-License-Identifier: Apache-2.0
// A value, or the reason why it is missing. The firmware throws nothing: every failure is a return value.
#pragma once

namespace canproof {

/// Holds either a Value or an Error. Reading the value of a failed result gives Value{}.
template <typename Value, typename Error>
class Result {
  public:
    static constexpr Result success(const Value& value) noexcept { return Result{value, Error{}, true}; }
    static constexpr Result failure(const Error& error) noexcept { return Result{Value{}, error, false}; }

    constexpr bool ok() const noexcept { return ok_; }
    constexpr const Value& value() const noexcept { return value_; }
    constexpr const Error& error() const noexcept { return error_; }

  private:
    constexpr Result(const Value& value, const Error& error, const bool ok) noexcept
        : value_{value}, error_{error}, ok_{ok} {}

    Value value_;
    Error error_;
    bool ok_;
};

}  // namespace canproof
