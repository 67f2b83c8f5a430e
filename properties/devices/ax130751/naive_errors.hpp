// SPDX-License-Identifier: Apache-2.0
// Naive supply and temperature faults and errors of the AX130751: 1001h (error register), 1003h (error list) and
// emergency messages (manual, 1.8, 3.2.2 and 3.2.4).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <vector>

#include "properties/devices/ax130751/naive_parameters.hpp"

namespace canproof::naive_ax130751 {

struct Inputs {
    float supply{24.0F};
    float temperature{35.0F};
    std::array<float, 2> load{250.0F, 250.0F};
};

/// A frame sent by the node.
struct Said {
    std::uint64_t at{0};  ///< ms since power-on
    unsigned id{0};
    std::vector<int> data;

    bool operator==(const Said& other) const { return at == other.at && id == other.id && data == other.data; }
};

/// The errors as they are listed in 1003h (predefined error field): the upper 16 bits are description and channel, the
/// lower 16 bits the error code.
constexpr std::uint32_t supply_error = 0x00003100;
constexpr std::uint32_t temperature_error = 0x00004200;
constexpr std::uint32_t time_out_error = 0x00008100;
constexpr std::uint32_t length_error = 0x00008210;
constexpr std::uint32_t heartbeat_error = 0x80008130;  ///< the channel (bits 16 to 23) is the producer's node-ID

class Errors {
  public:
    /// Begins or ends an error, and adds its emergency message, with the identifier `id`, to `said`.
    void set(std::uint32_t error, bool present, std::uint64_t now, unsigned id, std::vector<Said>& said) {
        if (active_.count(error) == (present ? 1U : 0U)) {
            return;
        }
        if (present) {
            active_[error] = true;
            list_.push_front(error);
            if (list_.size() > 4) {
                list_.pop_back();
            }
        } else {
            active_.erase(error);
            std::deque<std::uint32_t> rest;
            for (const std::uint32_t other : list_) {
                if (other != error) {
                    rest.push_back(other);
                }
            }
            list_ = rest;
        }
        const auto byte = [&](unsigned shift) { return present ? static_cast<int>(error >> shift & 0xFFU) : 0; };
        said.push_back({now, id, {byte(0), byte(8), reg(), byte(16), byte(24), 0, 0, 0}});
    }
    int reg() const { return active_.empty() ? 0 : 1; }
    /// Returns the entries of 1003h (error list) from sub-index 1 on.
    const std::deque<std::uint32_t>& list() const { return list_; }
    void empty_list() { list_.clear(); }

  private:
    std::map<std::uint32_t, bool> active_;
    std::deque<std::uint32_t> list_;
};

/// Faults of supply and temperature (section 1.8). A fault begins when the value is beyond the limit. It ends when the
/// value is on the other side of the limit by at least the hysteresis. While the hardware has switched the outputs off,
/// there is a supply fault too. A temperature that is NaN counts as too hot.
class Faults {
  public:
    void look(const Inputs& inputs, const Diagnostics& limits) {
        const auto under = static_cast<float>(limits.under);
        const auto over = static_cast<float>(limits.over);
        const auto back = static_cast<float>(limits.supply_hysteresis);
        const auto hot = static_cast<float>(limits.hot);
        const auto cool = static_cast<float>(limits.hot - limits.heat_hysteresis);
        follow(under_, limits.watches_supply, inputs.supply < under, inputs.supply >= under + back);
        follow(over_, limits.watches_supply, inputs.supply > over, inputs.supply <= over - back);
        const bool is_hot = std::isnan(inputs.temperature) || inputs.temperature > hot;
        follow(hot_, limits.watches_heat, is_hot, inputs.temperature <= cool);
        const bool powered = inputs.supply >= 7.0F && inputs.supply <= 39.0F;
        unpowered_ = limits.watches_supply != 0 && !powered;
    }
    bool supply() const { return under_ || over_ || unpowered_; }
    bool temperature() const { return hot_; }

  private:
    static void follow(bool& fault, int watched, bool begins, bool ends) {
        fault = watched != 0 && (begins || (fault && !ends));
    }

    bool under_{false};
    bool over_{false};
    bool unpowered_{false};  ///< the hardware has switched the outputs off
    bool hot_{false};
};

}  // namespace canproof::naive_ax130751
