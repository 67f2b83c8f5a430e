// SPDX-License-Identifier: Apache-2.0
// A ring buffer of received frames: the interrupt adds them, and the main loop takes them. Neither waits for the other.
#pragma once

#include <atomic>

#include "firmware/canopen/frame.hpp"

namespace canproof::stm32f405 {

class ReceiveRing {
  public:
    /// 32 of the shortest frames (47 µs at 1 Mbit/s) take 1.5 ms on a full bus; the longest cycle of a device,
    /// the first one after a power-on with self-tests, takes 1.05 ms.
    static constexpr std::uint32_t capacity = 32U;

    /// Adds a frame; the interrupt calls it. Without room the frame is lost, and take_overrun() reports it.
    void push(const Frame& frame) noexcept {
        const std::uint32_t end = end_.load(std::memory_order_relaxed);
        if ((end - first_.load(std::memory_order_acquire)) == capacity) {
            note_overrun();
        } else {
            frames_[end % capacity] = frame;
            end_.store(end + 1U, std::memory_order_release);
        }
    }
    void note_overrun() noexcept { overrun_.store(true, std::memory_order_release); }

    /// Takes the oldest frame; the main loop calls it. Returns false when there is no frame.
    bool pop(Frame& frame) noexcept {
        const std::uint32_t first = first_.load(std::memory_order_relaxed);
        const bool any = end_.load(std::memory_order_acquire) != first;
        if (any) {
            frame = frames_[first % capacity];
            first_.store(first + 1U, std::memory_order_release);
        }
        return any;
    }
    /// Returns whether a frame was lost since the last call.
    bool take_overrun() noexcept { return overrun_.exchange(false, std::memory_order_acq_rel); }

  private:
    std::array<Frame, capacity> frames_{};
    std::atomic<std::uint32_t> first_{0U};  ///< counts all popped frames
    std::atomic<std::uint32_t> end_{0U};    ///< counts all pushed frames
    std::atomic<bool> overrun_{false};
};

}  // namespace canproof::stm32f405
