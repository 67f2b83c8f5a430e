// SPDX-License-Identifier: Apache-2.0
// Fuzzes the CAN driver of the Zynq UltraScale+ on a model of its registers, with any order of frames, transmissions,
// errors, stuck buses, slow hardware and bit rates. Input: records of four bytes: the event, and three bytes for it.
#include <algorithm>
#include <deque>
#include <map>

#include "fuzz/support/claims.hpp"
#include "fuzz/support/require.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/zynqmp/can.hpp"
#include "tests/support/zynqmp/zynq_can_model.hpp"

namespace {

using namespace canproof;
using fuzz::require;
using test::ZynqCanModel;

constexpr std::size_t record_size = 4;
constexpr std::array<std::uint32_t, 6> identifiers{0x083, 0x183, 0x184, 0x583, 0x703, 0x7E4};
constexpr std::array<std::uint32_t, 8> bit_rates{1000000, 666667, 500000, 250000, 125000, 50000, 10000, 3000};

/// Returns the serial number that the data of a frame contain. Frames are numbered in the order in which they are
/// queued.
std::uint32_t serial_of(const Frame& frame) {
    return static_cast<std::uint32_t>(load_le<4>(frame.data.data()));
}

class World {
  public:
    void act(const std::uint8_t* record);
    /// Makes the bus idle: all waiting frames are sent, and all received frames are passed on.
    void settle();

  private:
    void queue_frame(std::uint8_t which);
    void advance(std::uint64_t us);
    void begin_transmission();
    void end_transmission(bool sent);
    void receive(const std::uint8_t* record);
    void take_received(std::size_t most);
    void take_overrun();
    void set_bit_rate(std::uint8_t which);
    void break_something(std::uint8_t what);
    void follow_reset();

    ZynqCanModel model_;
    zynqmp::Can can_{model_.registers(), 24000000};
    TransmitQueue queue_;
    Instant now_{};

    std::uint32_t next_serial_{1};
    std::map<std::uint32_t, Frame>
        queued_;              ///< frames in the transmit queue that the controller has not got yet, by serial number
    std::uint32_t given_{0};  ///< serial number of the frame in the controller; 0: none
    std::deque<Frame> received_;
    bool lost_{false};  ///< a frame was lost since the last report, because a buffer was full
    std::size_t resets_{0};
};

void World::act(const std::uint8_t* record) {
    switch (record[0] % 11) {
        case 0:
        case 1:
            return queue_frame(record[1]);
        case 2:
            return advance(record[1]);
        case 3:
            return begin_transmission();
        case 4:
            return end_transmission((record[1] & 1U) != 0);
        case 5:
        case 6:
            return receive(record);
        case 7:
            return take_received(record[1] % 16U);
        case 8:
            return model_.count_errors(record[1] + (record[2] % 4 == 0 ? 1U : 0U), record[3]);
        case 9:
            return model_.pass_recessive(record[1]);
        default:
            break;
    }
    if (record[1] % 4 == 0) {
        set_bit_rate(record[2]);
    } else {
        break_something(record[2]);
    }
}

void World::queue_frame(std::uint8_t which) {
    Frame frame = data_frame(identifiers[which % identifiers.size()], 8);
    store_le<4>(frame.data.data(), next_serial_);
    if (queue_.push(frame)) {
        queued_[next_serial_++] = frame;
    }
}

/// Advances the driver. If a frame leaves the queue, checks that no queued frame has a lower identifier, and that no
/// frame with the same identifier was queued earlier.
void World::advance(std::uint64_t us) {
    now_.us += us * 1000;
    const std::size_t before = queue_.size();
    const Frame next = queue_.empty() ? Frame{} : *queue_.front();
    can_.advance(queue_, now_);
    follow_reset();
    const std::size_t left = before - queue_.size();
    require(left <= 1, "more than one frame is given to the controller");
    if (left == 1) {
        require(given_ == 0, "a frame is given to the controller while it has one", given_);
        given_ = serial_of(next);
        const auto found = queued_.find(given_);
        require(found != queued_.end(), "nobody queued this frame", given_);
        for (const auto& [serial, frame] : queued_) {
            const bool goes_before = frame.id < next.id || (frame.id == next.id && serial < given_);
            require(!goes_before, "another frame should be given first", serial);
        }
    }
}

void World::begin_transmission() {
    const auto frame = model_.begin_transmission();
    if (frame) {
        require(given_ != 0 && serial_of(*frame) == given_, "another frame than the given one is on the bus");
        const Frame& expected = queued_.at(given_);
        require(expected.id == frame->id && expected.data == frame->data, "another content", given_);
    }
}

void World::end_transmission(bool sent) {
    const bool was_full = model_.is_full();
    model_.end_transmission(sent);
    if (was_full && !model_.is_full()) {
        queued_.erase(given_);
        given_ = 0;
    }
}

void World::receive(const std::uint8_t* record) {
    Frame frame = data_frame(static_cast<std::uint32_t>(record[1] + 256 * (record[2] % 8)),
                             static_cast<std::uint8_t>(record[3] & 0xFU));
    frame.extended = (record[3] & 0x10U) != 0;
    frame.remote = (record[3] & 0x20U) != 0;
    store_le<4>(frame.data.data(), next_serial_++);
    const auto taken = model_.receive(frame);
    require(!frame.extended || taken == ZynqCanModel::Taken::filtered, "a 29-bit identifier passes the filter");
    if (taken == ZynqCanModel::Taken::kept) {
        frame.length = std::min<std::uint8_t>(frame.length, 8);
        received_.push_back(frame);
    }
    lost_ = lost_ || taken == ZynqCanModel::Taken::lost;
}

void World::take_received(std::size_t most) {
    Frame frame;
    for (std::size_t i = 0; i < most && can_.receive(frame); ++i) {
        require(!received_.empty(), "a frame that nobody sent");
        const Frame& expected = received_.front();
        require(frame.id == expected.id && frame.remote == expected.remote && !frame.extended &&
                    frame.length == expected.length && frame.data == expected.data,
                "frames in another order or with another content", frame.id);
        received_.pop_front();
    }
    take_overrun();
}

void World::take_overrun() {
    require(can_.take_overrun() == lost_, "an overrun is not reported, or reported without one");
    lost_ = false;
}

void World::set_bit_rate(std::uint8_t which) {
    can_.set_bit_rate(bit_rates[which % bit_rates.size()], now_);
    follow_reset();
}

/// Follows a reset of the controller, which drops the frame to be sent and the received frames.
void World::follow_reset() {
    if (model_.resets() != resets_) {
        resets_ = model_.resets();
        queued_.erase(given_);
        given_ = 0;
        received_.clear();
        lost_ = false;
    }
}

void World::break_something(std::uint8_t what) {
    model_.hold_dominant((what & 1U) != 0);
    model_.answer_reset((what & 2U) == 0);
    model_.keep_filters_busy((what & 4U) != 0);
}

void World::settle() {
    break_something(0);
    end_transmission(true);
    set_bit_rate(0);
    for (int i = 0; i < 20; ++i) {
        advance(100);
        model_.pass_recessive(128);
    }
    advance(0);
    require(can_.is_on_bus() && can_.state() != CanState::bus_off, "a bus that is in order is not joined");
    for (std::size_t i = 0; i <= TransmitQueue::capacity; ++i) {
        begin_transmission();
        end_transmission(true);
        advance(0);
    }
    require(queue_.empty() && queued_.empty(), "a frame does not go out");
    take_received(zynqmp::fifo_depth + 1);
    require(received_.empty(), "a frame stays in the controller");
    for (const auto& fault : model_.faults()) {
        require(false, fault.c_str());
    }
}

}  // namespace

CANPROOF_FUZZ_CLAIMS(req::CO_ZCAN_003, req::CO_ZCAN_006, req::CO_ZCAN_008, req::CO_ZCAN_009, req::CO_ZCAN_012)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    World world;
    const std::uint8_t joins[][record_size]{{10, 0, 0, 0}, {2, 1, 0, 0}, {2, 1, 0, 0}, {2, 1, 0, 0}, {2, 1, 0, 0}};
    for (const auto& record : joins) {
        world.act(record);
    }
    for (std::size_t at = 0; size - at >= record_size; at += record_size) {
        world.act(data + at);
    }
    world.settle();
    return 0;
}
