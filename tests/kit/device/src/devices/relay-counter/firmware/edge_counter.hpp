// Counts how often an input goes on (RC:6).
#pragma once

#include <cstdint>

#include "firmware/base/requirement.hpp"
#include "generated/relay_counter/requirements.hpp"

namespace canproof::relay_counter {

class EdgeCounter {
  public:
    /// Begins anew at 0; `input` as it is now does not count.
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
    /// Changes from off to on since restart(), modulo 2^32.
    std::uint32_t count() const noexcept { return count_; }

  private:
    std::uint32_t count_{0U};
    bool input_{false};
};

}  // namespace canproof::relay_counter
