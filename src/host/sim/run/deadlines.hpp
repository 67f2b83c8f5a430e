// SPDX-License-Identifier: Apache-2.0
// The deadlines of many devices. The earliest deadline is always known. A change takes a number of steps that is
// logarithmic in the number of devices.
#pragma once

#include <cstddef>
#include <vector>

#include "firmware/base/time.hpp"

namespace canproof::host {

class Deadlines {
  public:
    /// Makes `count` deadlines with the numbers 0 to `count` - 1 and the value `never`.
    explicit Deadlines(std::size_t count) {
        while (leaves_ < count) {
            leaves_ *= 2;
        }
        earliest_.assign(2 * leaves_, never);
    }

    void set(std::size_t number, Instant due) {
        std::size_t at = leaves_ + number;
        earliest_[at] = due;
        for (at /= 2; at > 0; at /= 2) {
            earliest_[at] = earliest(earliest_[2 * at], earliest_[2 * at + 1]);
        }
    }
    Instant first() const { return earliest_[1]; }
    /// Returns the numbers of the deadlines that are due at `now`, in ascending order.
    std::vector<std::size_t> due_at(Instant now) const {
        std::vector<std::size_t> numbers;
        collect(1, now, numbers);
        return numbers;
    }

  private:
    void collect(std::size_t at, Instant now, std::vector<std::size_t>& numbers) const {
        if (now < earliest_[at]) {
            return;
        }
        if (at >= leaves_) {
            numbers.push_back(at - leaves_);
            return;
        }
        collect(2 * at, now, numbers);
        collect(2 * at + 1, now, numbers);
    }

    std::size_t leaves_{1};
    /// binary tree of the earliest deadlines: element 1 is the root, the children of element n are 2n and 2n + 1
    std::vector<Instant> earliest_;
};

}  // namespace canproof::host
