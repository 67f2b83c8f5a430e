// SPDX-License-Identifier: Apache-2.0
// A test fixture (bench) for frames that the CAN driver puts into the three mailboxes of the controller.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>
#include <vector>

#include "firmware/canopen/transmit_queue.hpp"
#include "target/stm32f405/bxcan.hpp"
#include "tests/support/stm32f405/bxcan_model.hpp"

namespace canproof::test {

using Numbered = std::pair<std::uint32_t, int>;  ///< the identifier of a frame and its first byte

/// The CAN driver on a model of the controller, on the bus at 1 Mbit/s, with a transmit queue.
struct MailboxBench {
    BxcanModel model;
    stm32f405::Bxcan can{model.registers(), 42000000};
    TransmitQueue queue;
    Instant now{};

    MailboxBench() {
        can.set_bit_rate(1000000, now);
        serve();
        serve();
        EXPECT_TRUE(can.is_on_bus());
    }
    void serve() {
        now.us += 100;
        can.advance(queue, now);
    }
    static Frame frame(const Numbered& numbered) {
        Frame frame = data_frame(numbered.first, 1);
        frame.data[0] = static_cast<std::uint8_t>(numbered.second);
        return frame;
    }
    void queue_up(std::initializer_list<Numbered> frames) {
        for (const Numbered& one : frames) {
            ASSERT_TRUE(queue.push(frame(one)));
        }
    }
    /// Puts these frames into mailboxes 0, 1 …, in this order.
    void fill(std::initializer_list<Numbered> frames) {
        for (const Numbered& one : frames) {
            queue_up({one});
            serve();
        }
        ASSERT_TRUE(queue.empty());
    }
    void fill_queue(std::uint32_t id) {
        while (queue.size() < TransmitQueue::capacity) {
            queue_up({{id, 99}});
        }
    }
    /// Drops what waits in the queue, as the node does at bus-off and when LSS changes the bit rate.
    void empty_queue() {
        queue.close();
        queue.open();
    }
    /// Sends the frames of the mailboxes without a call of the driver.
    std::vector<Numbered> sent_at_once() {
        std::vector<Numbered> frames;
        while (const auto one = model.transmit()) {
            frames.emplace_back(one->id, one->data[0]);
        }
        return frames;
    }
    /// Sends all frames, with a call of the driver before each.
    std::vector<Numbered> sent() {
        std::vector<Numbered> frames;
        for (serve(); const auto one = model.transmit(); serve()) {
            frames.emplace_back(one->id, one->data[0]);
        }
        return frames;
    }
};

}  // namespace canproof::test
