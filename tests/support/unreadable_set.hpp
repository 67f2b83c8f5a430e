// SPDX-License-Identifier: Apache-2.0
// The start of a device that takes the most work with its parameters: both banks hold a sound set, and the last value
// of the newer set cannot be read. The device loads all stored values, and then the defaults again.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "tests/support/faulty_memory.hpp"
#include "tests/support/frame_bench.hpp"

namespace canproof::test {

/// A test fixture, on the bench of a device, whose memory fails. `memory_size` is that of the bench.
template <typename Bench, std::size_t memory_size>
class UnreadableSet : public testing::Test, public Bench {
  protected:
    /// Creates a new device on the memory and powers it on.
    Frames power_cycle() {
        using Device = std::remove_reference_t<decltype(*std::declval<Bench&>().device)>;
        this->queue = TransmitQueue{};
        this->device = std::make_unique<Device>(faulty, this->queue, this->factory);
        return this->switch_on([this] { this->device->power_on(this->inputs, this->now); });
    }
    /// Stores all parameters twice by `store_all`. The second time, the first set cannot be marked as void, so that two
    /// sound sets remain.
    template <typename Store>
    void store_two_sets(const Store& store_all) {
        faulty.fail_write(0);
        store_all();
        ASSERT_GT(faulty.writes, 0U);
        faulty.fail_write(faulty.writes, 0);  // the last write marks the other set as void
        store_all();
        faulty.fail_write(0);
    }
    /// Calls `act` twice. The second time, the last read of `act` fails.
    template <typename Act>
    Frames with_unreadable_value(const Act& act) {
        faulty.fail_read(0);
        static_cast<void>(act());
        faulty.fail_read(faulty.reads);
        const Frames frames = act();
        faulty.fail_read(0);
        return frames;
    }

    FaultyMemory faulty{memory_size};
};

}  // namespace canproof::test
