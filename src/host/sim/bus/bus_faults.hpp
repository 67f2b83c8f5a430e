// SPDX-License-Identifier: Apache-2.0
// Random faults of the in-process bus. The same seed gives the same faults.
#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace canproof::host {

/// The probability of each fault for one frame, 0 to 1.
struct BusFaultRates {
    double corrupted{0.0};  ///< a bit error: an error frame follows, and the frame is sent again
    double lost{0.0};       ///< a randomly chosen node loses the frame, as if its buffer were full
    double bus_off{0.0};    ///< the sender's controller becomes bus-off after the frame
    std::uint64_t seed{1U};

    bool any() const { return corrupted > 0.0 || lost > 0.0 || bus_off > 0.0; }
};

/// Parses `corrupted=0.01,lost=0.001,bus-off=0.0001,seed=7`. Each part is optional. A probability is 0 to 0.9. Throws
/// InputError for any other text.
BusFaultRates parse_bus_faults(const std::string& text);

class BusFaults {
  public:
    explicit BusFaults(const BusFaultRates& rates) : rates_{rates}, generator_{rates.seed} {}

    bool corrupts() { return happens(rates_.corrupted); }
    bool loses() { return happens(rates_.lost); }
    bool switches_off() { return happens(rates_.bus_off); }
    /// Returns a number from 0 to count − 1.
    std::size_t pick(std::size_t count) { return static_cast<std::size_t>(generator_() % count); }

  private:
    // The generator gives the same numbers everywhere; the standard distributions depend on the library, so they are
    // not used.
    bool happens(double probability) {
        constexpr double numbers = 4294967296.0;
        return probability > 0.0 && static_cast<double>(generator_() >> 32U) < probability * numbers;
    }

    BusFaultRates rates_;
    std::mt19937_64 generator_;
};

}  // namespace canproof::host
