// SPDX-License-Identifier: Apache-2.0
// A view of an array whose length is known at run time only. The owner of the memory chooses the length.
#pragma once

#include <array>
#include <cstddef>

namespace canproof {

template <typename T>
class Slots {
  public:
    constexpr Slots() noexcept = default;
    constexpr Slots(T* const first, const std::size_t count) noexcept
        : first_{first}, end_{first + count}, count_{count} {}
    template <std::size_t N>
    constexpr explicit Slots(std::array<T, N>& places) noexcept : Slots{places.data(), N} {}

    constexpr std::size_t size() const noexcept { return count_; }
    constexpr bool empty() const noexcept { return count_ == 0U; }
    constexpr T* begin() const noexcept { return first_; }
    constexpr T* end() const noexcept { return end_; }
    /// Returns element `at`, which must be below size().
    constexpr T& operator[](const std::size_t at) const noexcept { return first_[at]; }
    /// Returns a view of at most `count` elements from `from` on; fewer when this view ends earlier.
    constexpr Slots part(const std::size_t from, const std::size_t count) const noexcept {
        const std::size_t start = (from < count_) ? from : count_;
        const std::size_t rest = count_ - start;
        return Slots{first_ + start, (count < rest) ? count : rest};
    }

  private:
    T* first_{nullptr};
    T* end_{nullptr};  ///< end of the view; stored, because loops read it more often than the count
    std::size_t count_{0U};
};

}  // namespace canproof
