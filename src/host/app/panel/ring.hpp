// SPDX-License-Identifier: Apache-2.0
// Keeps the newest items of a sequence, numbered from 0. A reader asks for the items from the first number that it has
// not read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

namespace canproof::host {

template <typename T>
class Ring {
  public:
    explicit Ring(std::size_t capacity) : capacity_{capacity} {}

    void push(T item) {
        if (items_.size() == capacity_) {
            items_.pop_front();
        }
        items_.push_back(std::move(item));
        ++next_;
    }
    /// Returns the number that the next added item will get; the first item has number 0.
    std::uint64_t next() const { return next_; }
    std::uint64_t oldest() const { return next_ - items_.size(); }
    /// Calls visit(number, item) for the items from number `from` on. Skips all but the newest `most` items.
    template <typename Visit>
    void for_each_from(std::uint64_t from, std::size_t most, const Visit& visit) const {
        const std::uint64_t newest = next_ > most ? next_ - most : 0U;
        std::uint64_t number = from < oldest() ? oldest() : from;
        number = number < newest ? newest : number;
        for (; number < next_; ++number) {
            visit(number, items_[static_cast<std::size_t>(number - oldest())]);
        }
    }
    const std::deque<T>& items() const { return items_; }

  private:
    std::size_t capacity_;
    std::deque<T> items_;
    std::uint64_t next_{0};
};

}  // namespace canproof::host
