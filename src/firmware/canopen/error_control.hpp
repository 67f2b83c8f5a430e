// SPDX-License-Identifier: Apache-2.0
// Error control: boot-up, heartbeat producer, node guarding and life guarding (CiA 301, 7.2.8.2).
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace canproof {

class ErrorControl {
  public:
    ErrorControl(ObjectDictionary& objects, TransmitQueue& queue) noexcept : objects_{objects}, queue_{queue} {}

    /// Sends the boot-up message after a reset and starts the heartbeat or waits for guarding.
    void boot_up(std::uint8_t node_id, Instant now) noexcept;
    void set_state(const NmtState state) noexcept { state_ = state; }

    /// Answers a guarding request of the master and restarts the life time. A frame with this node's guarding
    /// identifier counts as a request: the caller passes remote frames only. Returns false for another identifier or
    /// while the heartbeat is on, otherwise true, also when the transmit queue has no room for the answer.
    bool answer(const Frame& request, Instant now) noexcept;
    void advance(const Instant now) noexcept {
        if (next_deadline() <= now) {
            act(now);
        }
    }
    Instant next_deadline() const noexcept { return earliest(next_heartbeat_, life_deadline_); }

    /// Returns whether life guarding has failed: after a first guarding request, no other one came for guard time ×
    /// life time factor. The failure ends with the next guarding request, with a reset, and when guarding is switched
    /// off or the heartbeat is switched on.
    bool life_guarding_failed() const noexcept { return life_failed_; }

    /// Applies a write. 1017h producer heartbeat time restarts the heartbeat. 100Ch guard time and 100Dh life time
    /// factor restart life guarding, if it runs. A new 100Eh node guarding identifier is used from the next message on.
    void after_write(const EntryRef& entry, Instant now) noexcept;
    AbortCode before_write(const EntryRef& entry, std::uint32_t wanted) const noexcept;

    /// Returns whether the invariant between two calls holds (properties/invariants): the stored times are those of
    /// 1017h (producer heartbeat time), 100Ch (guard time) and 100Dh (life time factor). Only a node with a heartbeat
    /// time has a heartbeat due, and such a node is not guarded. Without a boot-up, the times may be older ones.
    bool is_consistent() const noexcept;
    /// Returns whether `state` is the NMT state that the messages show (properties/invariants).
    bool shows(NmtState state) const noexcept;

  private:
    /// Reads the parameters again, after a reset and after each write to one of them.
    void refresh() noexcept;
    void act(Instant now) noexcept;
    void send_state(std::uint8_t octet) noexcept;
    void start_heartbeat(Instant now) noexcept;

    ObjectDictionary& objects_;
    TransmitQueue& queue_;
    std::uint8_t node_id_{0U};
    NmtState state_{NmtState::initialising};
    bool toggle_{false};
    bool life_failed_{false};
    std::uint32_t identifier_{0U};
    Duration heartbeat_time_{};
    Duration life_time_{};
    Instant next_heartbeat_{never};
    Instant life_deadline_{never};
};

}  // namespace canproof
