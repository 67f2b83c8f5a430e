// SPDX-License-Identifier: Apache-2.0
// Counts the changes of an input from off to on (RC:6).
#pragma once

#include <cstdint>

#include "firmware/base/requirement.hpp"
#include "generated/relay_counter/requirements.hpp"

namespace canproof::relay_counter {

class EdgeCounter {
  public:
    /// Sets the count to 0. An input that is already on does not count as a change.
    void restart(const bool input) noexcept {
        input_ = input;
        count_ = 0U;
    }
    static_assert(implements<req::RC_COUNT_001>);
    void see(const bool input) noexcept {
        if (input && !input_) {
            ++count_;
        }
        input_ = input;
    }
    /// Returns the number of changes from off to on since restart(), modulo 2^32.
    std::uint32_t count() const noexcept { return count_; }

  private:
    std::uint32_t count_{0U};
    bool input_{false};
};

}  // namespace canproof::relay_counter
