// SPDX-License-Identifier: Apache-2.0
// Naive relay of the AX130751 (manual, 1.4), written from the sentences of the manual and not from generated tables.
#pragma once

#include <cstdint>

#include "properties/devices/ax130751/naive_outputs.hpp"

namespace canproof::naive_ax130751 {

/// The relay. State true means ON: the common pin is connected to contact NC.
class NaiveRelay {
  public:
    bool cycle(const Relay& relay, const Sources& sources, const Circumstances& now) {
        const Signal control = sources.read(relay.control);
        const Signal unlatch = sources.read(relay.unlatch);
        const Signal enable = sources.read(relay.enable);
        const Signal forced = sources.read(relay.override_input);
        control_.follow(control);
        unlatch_.follow(unlatch);
        enable_.follow(enable);
        override_.follow(forced);
        if (!was_fine_) {
            before_ = control_.on();  // a change while the control was in error or absent does not count
        }
        was_fine_ = control.fine();
        latch(relay);
        const bool latches = relay.polarity == 3 || relay.polarity == 4;
        const bool has_lack = sources.lacks(relay.enable, enable) || sources.lacks(relay.override_input, forced) ||
                              (latches && sources.lacks(relay.unlatch, unlatch));
        const bool has_error = control.error() || enable.error() || forced.error() || (latches && unlatch.error());
        const bool disabled = enable.fine() && enable_.on() != enables_when_on(relay.enable_response);
        if (now.shutdown || relay.polarity == 0 || has_lack || has_error) {
            force(false);
        } else if (forced.fine() && override_.on() == (relay.override_response == 0)) {
            force(relay.override_state == 1);
        } else if (disabled && relay.enable_response >= 4) {
            force(state_);
        } else if (disabled || control.unused()) {
            change(relay, false, false, now.now);
        } else {
            obey(relay, now.now);
        }
        before_ = control_.on();
        return state_;
    }

  private:
    /// Returns whether the relay is enabled while its enable input is ON, for enable response `response` of Table 11.
    static bool enables_when_on(int response) { return response == 0 || response == 3 || response == 4; }

    /// Applies the unlatch input of a latched relay. While this input is ON, the relay is in its rest state, and stays
    /// there until the control has its rest state too.
    void latch(const Relay& relay) {
        if (relay.polarity != 3 && relay.polarity != 4) {
            latch_of_ = 0;
            return;
        }
        const bool rest = relay.polarity == 4;  // rest state of relay and control: ON for an inverse latch, else OFF
        if (latch_of_ != relay.polarity) {
            latch_of_ = relay.polarity;
            memory_ = rest;
            deaf_ = false;
        }
        if (unlatch_.on()) {
            memory_ = rest;
            deaf_ = true;
        } else if (deaf_ && control_.on() == rest) {
            deaf_ = false;
        }
    }
    /// Derives the state of the relay from its control input and its polarity (Table 10), and changes the relay to this
    /// state.
    void obey(const Relay& relay, std::uint64_t now) {
        const bool control = control_.on();
        switch (relay.polarity) {
            case 1:
                return change(relay, control, false, now);
            case 2:
                return change(relay, !control, false, now);
            case 5:
                return change(relay, control, true, now);
            default:
                break;
        }
        const bool edge = relay.polarity == 3 ? control && !before_ : before_ && !control;
        if (edge && !deaf_) {
            memory_ = !memory_;
        }
        if (relay.polarity == 3 && unlatch_.on()) {
            return force(false);  // the delays are those of control and enable
        }
        change(relay, memory_, false, now);
    }
    /// Performs a commanded change of the relay after its delay. Toggling begins and ends with such a change, too.
    void change(const Relay& relay, bool wanted, bool toggling, std::uint64_t now) {
        if (wanted == on_) {
            waits_ = false;
        } else {
            asked_ = waits_ ? asked_ : now;
            waits_ = true;
            const int delay = relay.delays == 0 ? 0 : wanted ? relay.on_delay : relay.off_delay;
            if (now - asked_ >= static_cast<std::uint64_t>(delay)) {
                on_ = wanted;
                waits_ = false;
            }
        }
        const bool toggles = on_ && (wanted ? toggling : toggles_);
        if (toggles && !toggles_) {
            since_ = now;
        }
        toggles_ = toggles;
        const auto half = static_cast<std::uint64_t>(relay.blink);
        state_ = on_ && (!toggles || half == 0 || (now - since_) / half % 2 == 0);
    }
    /// Sets the state at once and cancels a change that waits for its delay.
    void force(bool state) {
        on_ = state;
        state_ = state;
        waits_ = false;
        toggles_ = false;
    }

    Reading control_;
    Reading unlatch_;
    Reading enable_;
    Reading override_;
    int latch_of_{0};
    bool memory_{false};
    bool deaf_{false};
    bool before_{false};
    bool was_fine_{true};  ///< the control had a value, and was not in error, in the last cycle
    bool on_{false};
    bool state_{false};
    bool waits_{false};
    bool toggles_{false};
    std::uint64_t asked_{0};
    std::uint64_t since_{0};
};

}  // namespace canproof::naive_ax130751
