// SPDX-License-Identifier: Apache-2.0
// Fuzzes the CAN driver of the microcontroller on a model of its registers, with any order of frames, transmissions,
// aborts, errors, stuck buses and bit rates. Input: records of four bytes: the event, and three bytes for it.
#include <algorithm>
#include <deque>
#include <map>

#include "fuzz/support/claims.hpp"
#include "fuzz/support/require.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/bxcan.hpp"
#include "tests/support/stm32f405/bxcan_model.hpp"

namespace {

using namespace canproof;
using fuzz::require;
using test::BxcanModel;

constexpr std::size_t record_size = 4;
constexpr std::array<std::uint32_t, 6> identifiers{0x083, 0x183, 0x184, 0x583, 0x703, 0x7E4};
constexpr std::array<std::uint32_t, 8> bit_rates{1000000, 666667, 500000, 250000, 125000, 50000, 10000, 800000};

/// Returns the serial number that the data of a frame contain. Frames have ascending serial numbers in the order in
/// which they were queued.
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
    void queue_boot_up();
    void advance(std::uint64_t us);
    void begin_transmission();
    void end_transmission(bool sent);
    void receive(const std::uint8_t* record);
    void count_errors(std::uint32_t transmit, std::uint32_t receive);
    void drain();
    void take_received();
    void forget_received_after_reset();
    void set_bit_rate(std::uint8_t which);
    void break_something(std::uint8_t what);

    BxcanModel model_;
    stm32f405::Bxcan can_{model_.registers(), 42000000};
    TransmitQueue queue_;
    Instant now_{};

    std::uint32_t next_serial_{1};
    /// frames that the driver has accepted but not yet sent, by serial number
    std::map<std::uint32_t, Frame> waiting_;
    std::uint32_t on_bus_{0};  ///< serial number of the frame on the bus; 0: none
    /// serial number of the last boot-up message; the driver drops all earlier frames
    std::uint32_t forgotten_below_{0};
    /// frames with a lower serial number may be lost, because the driver cleared their mailboxes
    std::uint32_t vanished_below_{0};
    std::deque<Frame> in_fifos_;
    std::deque<Frame> in_ring_;
    bool lost_{false};  ///< a frame was lost since the last report, because a buffer was full
    std::size_t resets_{0};
};

void World::act(const std::uint8_t* record) {
    switch (record[0] % 14) {
        case 0:
        case 1:
            return queue_frame(record[1]);
        case 2:
            return record[1] % 8 == 0 ? queue_boot_up() : queue_frame(record[1]);
        case 3:
            return advance(record[1]);
        case 4:
            return begin_transmission();
        case 5:
            return end_transmission(true);
        case 6:
            return end_transmission(false);
        case 7:
        case 8:
            return receive(record);
        case 9:
            return drain();
        case 10:
            return take_received();
        case 11:
            return count_errors(record[1] + (record[2] % 4 == 0 ? 1U : 0U), record[3]);
        case 12:
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
        waiting_[next_serial_++] = frame;
    }
}

void World::queue_boot_up() {
    Frame frame = data_frame(0x703, 8);
    store_le<4>(frame.data.data(), next_serial_);
    queue_.push_boot_up(frame);
    forgotten_below_ = next_serial_;
    waiting_[next_serial_++] = frame;
}

void World::advance(std::uint64_t us) {
    now_.us += us * 1000;
    can_.advance(queue_, now_);
    vanished_below_ = can_.is_on_bus() ? vanished_below_ : next_serial_;
    forget_received_after_reset();
}

void World::begin_transmission() {
    advance(0);
    const auto frame = model_.begin_transmission();
    if (!frame) {
        return;
    }
    const std::uint32_t serial = serial_of(*frame);
    const auto found = waiting_.find(serial);
    require(found != waiting_.end(), "nobody queued this frame, or it was sent before", serial);
    require(found->second.id == frame->id && found->second.data == frame->data, "another content", serial);
    require(serial >= forgotten_below_, "a frame from before the reset goes out", serial);
    for (const auto& [other, content] : waiting_) {
        const bool may_be_gone = other < std::max(forgotten_below_, vanished_below_);
        const bool goes_before = content.id < frame->id || (content.id == frame->id && other < serial);
        require(may_be_gone || serial == forgotten_below_ || !goes_before, "another frame should go out first", other);
        require(other != forgotten_below_ || other == serial || may_be_gone, "the boot-up message is overtaken",
                serial);
    }
    on_bus_ = serial;
}

void World::end_transmission(bool sent) {
    model_.end_transmission(sent);
    if (sent) {
        waiting_.erase(on_bus_);
    }
    on_bus_ = 0;
}

void World::receive(const std::uint8_t* record) {
    Frame frame = data_frame(static_cast<std::uint32_t>(record[1] + 256 * (record[2] % 8)),
                             static_cast<std::uint8_t>(record[3] & 0xFU));
    frame.extended = (record[3] & 0x10U) != 0;
    frame.remote = (record[3] & 0x20U) != 0;
    store_le<4>(frame.data.data(), next_serial_++);
    const auto taken = model_.receive(frame, 40U + record[3]);
    require(!frame.extended || taken == BxcanModel::Taken::filtered, "a 29-bit identifier passes the filters");
    if (taken == BxcanModel::Taken::kept) {
        frame.length = std::min<std::uint8_t>(frame.length, 8);
        in_fifos_.push_back(frame);
    }
    lost_ = lost_ || taken == BxcanModel::Taken::lost;
}

void World::count_errors(std::uint32_t transmit, std::uint32_t receive) {
    model_.count_errors(transmit, receive);
    on_bus_ = transmit > 255 ? 0 : on_bus_;  // bus-off interrupts the transmission
}

void World::drain() {
    const std::size_t before = model_.pending(0) + model_.pending(1);
    can_.drain();
    model_.finish_release();
    const std::size_t taken = before - model_.pending(0) - model_.pending(1);
    for (std::size_t i = 0; i < taken; ++i) {
        if (in_ring_.size() < stm32f405::ReceiveRing::capacity) {
            in_ring_.push_back(in_fifos_.front());
        } else {
            lost_ = true;
        }
        in_fifos_.pop_front();
    }
    require(can_.take_overrun() == lost_, "an overrun is not reported, or reported without one");
    lost_ = false;
}

void World::take_received() {
    Frame frame;
    while (can_.receive(frame)) {
        require(!in_ring_.empty(), "a frame that nobody sent");
        const Frame& expected = in_ring_.front();
        require(frame.id == expected.id && frame.remote == expected.remote && frame.length == expected.length &&
                    frame.data == expected.data,
                "frames in another order or with another content", frame.id);
        in_ring_.pop_front();
    }
    require(in_ring_.empty(), "a frame is lost without an overrun");
}

void World::forget_received_after_reset() {
    if (model_.resets() != resets_) {
        resets_ = model_.resets();
        in_fifos_.clear();  // a reset of the controller empties its FIFOs
        lost_ = false;
        on_bus_ = 0;
    }
}

void World::set_bit_rate(std::uint8_t which) {
    can_.set_bit_rate(bit_rates[which % bit_rates.size()], now_);
    vanished_below_ = next_serial_;
}

void World::break_something(std::uint8_t what) {
    model_.hold_dominant((what & 1U) != 0);
    model_.answer_initialisation((what & 2U) == 0);
    model_.release_slowly((what & 4U) != 0);
}

void World::settle() {
    break_something(0);
    end_transmission(true);
    set_bit_rate(0);
    for (int i = 0; i < 20; ++i) {
        advance(100);
        model_.pass_recessive(128);
    }
    require(can_.is_on_bus() && can_.state() != CanState::bus_off, "a bus that is in order is not joined");
    for (std::size_t i = 0; i < TransmitQueue::capacity + stm32f405::mailbox_count; ++i) {
        begin_transmission();
        end_transmission(true);
    }
    advance(0);
    require(queue_.empty() && !model_.begin_transmission(), "a frame does not go out");
    for (int i = 0; i < 3; ++i) {
        drain();
        take_received();
    }
    require(in_fifos_.empty(), "a frame stays in its FIFO");
    for (const auto& fault : model_.faults()) {
        require(false, fault.c_str());
    }
}

}  // namespace

CANPROOF_FUZZ_CLAIMS(req::CO_CAN_003, req::CO_CAN_004, req::CO_CAN_005, req::CO_CAN_006, req::CO_CAN_012,
                     req::CO_CAN_013)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    World world;
    const std::uint8_t joins[][record_size]{{13, 0, 0, 0}, {3, 1, 0, 0}, {3, 1, 0, 0}};
    for (const auto& record : joins) {
        world.act(record);
    }
    for (std::size_t at = 0; size - at >= record_size; at += record_size) {
        world.act(data + at);
    }
    world.settle();
    return 0;
}
