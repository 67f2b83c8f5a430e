// SPDX-License-Identifier: Apache-2.0
// Runs one device with any events (frames, changes of physical inputs, time, failing memory, power cuts) and checks the
// device after each event. A `Unit` describes the device: types, size of the memory, own checks; see *_unit.hpp.
//
// An input of the fuzz target consists of records of twelve bytes: the event, `how`, and ten bytes for it.
//   0…3 SDO request · 4 expedited write to the n-th entry · 5 LSS request · 6 frame of identifier 0 · 7 RPDO · 8 any
//   frame · 9 remote frame on an identifier of the device · A SYNC · B physical input · C time, with no deadline kept
//   when `how` is odd · D power cut while a frame is served · E power cycle · F memory fails, cannot be read, or works
//   again
#pragma once

#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "firmware/canopen/lss_store.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "fuzz/support/circumstances.hpp"
#include "fuzz/support/device_record.hpp"
#include "fuzz/support/digest.hpp"
#include "fuzz/support/entries.hpp"
#include "fuzz/support/frame_probe.hpp"
#include "fuzz/support/journal_memory.hpp"
#include "fuzz/support/limit_watch.hpp"
#include "fuzz/support/own_identifiers.hpp"
#include "fuzz/support/require_consistent.hpp"
#include "fuzz/support/sdo_legal.hpp"

namespace canproof::fuzz {

/// Most records of an input; further records are ignored, so that each run is short.
constexpr std::size_t most_device_records = 150;

template <typename Unit>
class DeviceWorld {
  public:
    using Device = typename Unit::Device;
    using Inputs = typename Unit::Inputs;

    explicit DeviceWorld(const Circumstances& circumstances, Image memory = Image(Unit::memory_size, 0xFF))
        : DeviceWorld{circumstances, std::move(memory), usual_inputs()} {}
    DeviceWorld(const Circumstances& circumstances, Image memory, const Inputs& inputs)
        : memory_{std::move(memory)}, garbage_{circumstances.garbage}, start_{circumstances.begins_us} {
        state_.inputs = inputs;
        state_.now = Instant{circumstances.begins_us};
        power_on();
    }
    ~DeviceWorld() { device_->~Device(); }
    DeviceWorld(const DeviceWorld&) = delete;
    DeviceWorld& operator=(const DeviceWorld&) = delete;

    /// Checks the present state of the device and saves it, so that restart() can return to it.
    void keep_start() {
        check();
        kept_ = std::make_unique<Kept>(Kept{storage_->bytes, memory_.image(), state_});
    }
    /// Returns to the state that keep_start() saved, faster than a new device with its power-on. Copying the bytes is
    /// enough, because the firmware uses no heap and its objects do not move.
    void restart() {
        storage_->bytes = kept_->device;
        memory_.heal();
        memory_.replace(kept_->memory);
        state_ = kept_->state;
    }

    void happen(const std::uint8_t* record) {
        const std::optional<Frame> frame = frame_in(record);
        if (frame) {
            receive(*frame);
        } else {
            befall(record);
        }
    }
    /// Returns the frame that a record of kind 0 to A puts on the bus. Returns nothing for the other kinds, and when
    /// kind 4 selects an entry that has no expedited write.
    std::optional<Frame> frame_in(const std::uint8_t* record) const {
        const unsigned how = record[1];
        const std::uint8_t* const data = record + 2;
        switch (record[0] & 0x0FU) {
            case 4:
                return entry_write(device_->objects().tables(), node(), data);
            case 5:
                return frame_of(0x7E5, how, data);
            case 6:
                return frame_of(0x000, how, data);
            case 7:
                return frame_of(current_id(0x1400U + ((how >> 4U) & 3U), 1), how, data);
            case 8:
                return any_frame(how, data);
            case 9:
                return remote_frame(how);
            case 0xA:
                return frame_of(current_id(0x1005, 0), how & 1U, data);
            default:
                return (record[0] & 0x0FU) < 4U ? std::optional{request(data)} : std::nullopt;
        }
    }
    /// Applies a record of kind B to F (an event that is no frame) to the device.
    void befall(const std::uint8_t* record) {
        const unsigned how = record[1];
        const std::uint8_t* const data = record + 2;
        switch (record[0] & 0x0FU) {
            case 0xB:
                return set_input(how, data);
            case 0xC:
                return (how & 1U) != 0 ? pass_unattended(duration_in(record)) : pass(duration_in(record));
            case 0xD:
                return cut_power((how & 1U) != 0 ? frame_of(0x7E5, 8, data) : request(data), data[8] + 256U * data[9]);
            case 0xE:
                return power_cycle();
            case 0xF:
                return memory_.fail(how, data[0] + 256U * data[1]);
            default:
                return;  // a record of kind 4 that selects an entry without an expedited write
        }
    }
    /// Checks that all values are within their limits, and the conditions of Unit::check(). Called after each record.
    void check() {
        check_values();
        state_.unit.check(*device_, state_.inputs, false);
    }
    /// Lets enough time pass for the device to act on all events, and checks again.
    void settle() {
        pass(milliseconds(5));
        check_values();
        state_.unit.check(*device_, state_.inputs, true);
    }

    /// Advances time to `end` and calls the device at each of its deadlines on the way.
    void run_until(Instant end) {
        constexpr unsigned most_at_once = 4;  // a block upload fills the queue at most 4 times at one point in time
        unsigned at_once = 0;
        while (state_.due <= end) {
            const bool is_later = state_.due > state_.now;
            at_once = is_later ? 1 : at_once + 1;
            require(at_once <= most_at_once);
            state_.now = is_later ? state_.due : state_.now;
            advance();
        }
        state_.now = end;
    }
    void pass(Duration time) { run_until(state_.now + time); }
    /// Advances time as with a late driver, which calls the device only at the end of `time`.
    void pass_unattended(Duration time) {
        state_.now = state_.now + time;
        advance(true);
        run_until(state_.now);
    }

    void receive(const Frame& frame) {
        if (start_ == 0) {
            deliver(*device_, frame, state_.now);
        } else {  // the second of the two runs does not call deliver(), which logs the frame
            device_->receive(frame, state_.now);
        }
        react(&frame);
        run_until(state_.now);
    }

    void set_inputs(const Inputs& inputs) {
        state_.inputs = inputs;
        device_->set_inputs(inputs, state_.now);
        react(nullptr);
        run_until(state_.now);
    }

    Instant now() const { return state_.now; }
    /// Returns the next deadline of the device.
    Instant next_deadline() const { return state_.due; }
    const Device& device() const { return *device_; }
    const Inputs& inputs() const { return state_.inputs; }
    const Image& memory() const { return memory_.image(); }
    /// Ends all faults of the memory and of the CAN controller.
    void recover() {
        memory_.heal();
        for_each_input(state_.inputs, [](const char* name, auto& input) {
            if (std::strncmp(name, "can_", 4) == 0) {
                input = std::decay_t<decltype(input)>{};
            }
        });
        device_->set_inputs(state_.inputs, state_.now);
        react(nullptr, true);
        run_until(state_.now);
    }
    bool has_sent() const { return !state_.sent.empty(); }
    /// Returns the frames that the device has sent since the last call.
    std::vector<Frame> take_sent() { return std::exchange(state_.sent, {}); }
    /// Replaces `frames` by the frames that the device has sent since the last call. Allocates no memory, because the
    /// memory of `frames` is used again.
    void take_sent(std::vector<Frame>& frames) {
        frames.clear();
        frames.swap(state_.sent);
    }

    /// Returns a hash of all frames that the device has sent, and of its present values, outputs and memory.
    std::uint64_t digest() {
        state_.digest.add(device_->objects().image());
        for_each_output(device_->outputs(), [this](const char*, const auto& value) { state_.digest.add(value); });
        state_.digest.add(ByteView{memory_.image().data(), memory_.image().size()});
        return state_.digest.value();
    }

  private:
    static Inputs usual_inputs() {
        Inputs inputs{};
        Unit::prepare(inputs);
        return inputs;
    }
    /// Advances the device, and drains its queue.
    void advance(bool may_be_full = false) {
        device_->advance(state_.now);
        state_.due = device_->next_deadline();
        require(state_.due > state_.now, "what is due gets done");
        drain(nullptr, may_be_full);
    }
    /// Drains the queue of the device after an event, which may have moved the next deadline.
    void react(const Frame* cause, bool may_be_full = false) {
        drain(cause, may_be_full);
        state_.due = device_->next_deadline();
    }
    std::uint32_t node() const { return device_->node_id() & 0x7FU; }
    std::uint32_t current_id(std::uint32_t index, std::uint8_t sub) const {
        return device_->objects().read(static_cast<std::uint16_t>(index), sub) & 0x7FFU;
    }

    Frame request(const std::uint8_t* data) const { return frame_of(0x600U + node(), 8, data); }
    /// Returns a remote frame that requests the error control message, a TPDO or an RPDO.
    Frame remote_frame(unsigned how) const {
        const unsigned number = how % 9U;
        std::uint32_t id = device_->objects().has(0x100E, 0) ? current_id(0x100E, 0) : 0x700U + node();
        if (number >= 5U) {
            id = current_id(0x1400U + number - 5U, 1);
        } else if (number >= 1U) {
            id = current_id(0x1800U + number - 1U, 1);
        }
        Frame frame = data_frame(id, 0);
        frame.remote = true;
        return frame;
    }

    void set_input(unsigned which, const std::uint8_t* data) {
        put_input(state_.inputs, which, data);
        device_->set_inputs(state_.inputs, state_.now);
        react(nullptr);
    }

    void power_on() {
        std::fill(storage_->bytes.begin(), storage_->bytes.end(), garbage_);
        state_.queue = TransmitQueue{};
        state_.unasked = 0;
        state_.unit = Unit{};
        device_ = new (storage_->bytes.data()) Device{memory_, state_.queue, typename Unit::FactoryData{}};
        state_.own.restart();
        device_->power_on(state_.inputs, state_.now);
        react(nullptr);
        run_until(state_.now);
    }
    void power_cycle() {
        device_->~Device();
        memory_.heal();
        power_on();
    }
    /// Cuts the power while a frame is handled. The stored parameters must be the old or the new set (CiA 301,
    /// 7.5.2.13).
    void cut_power(const Frame& frame, std::size_t place) {
        memory_.heal();
        memory_.open_journal();
        receive(frame);
        if (memory_.written() != 0) {  // otherwise the memory is as it was before the frame
            const std::uint64_t after = stored(memory_.image());
            const std::uint64_t before = stored(memory_.before_journal());
            memory_.cut_after(place % (memory_.written() + 1U));
            const std::uint64_t found = stored(memory_.image());
            require(found == before || found == after, "stored set old or new");
        }
        power_cycle();
    }
    /// Returns a hash of the stored parameters, node-ID and bit rate that a device loads from this memory.
    std::uint64_t stored(const Image& image) const {
        JournalMemory copy{image};
        TransmitQueue queue;
        const auto probe = std::make_unique<Device>(copy, queue, typename Unit::FactoryData{});
        probe->power_on(usual_inputs(), Instant{});
        Digest digest;
        digest.add(probe->node_id());
        digest.add(probe->bit_rate());
        for_each_entry(probe->objects(), [&](const EntryRef& entry) {
            if (entry.may(rights::stored)) {
                digest.add(probe->objects().value(entry));
            }
        });
        return digest.value();
    }

    /// Checks that every value is within its limits. Exceptions: 1003h:0 (number of errors), whose limits apply to
    /// writes only, and entries for which Unit::shows_beyond_limits() is true. Does not check an entry again if neither
    /// its value nor its limits have changed since the last check.
    void check_values() {
        const ObjectDictionary& objects = device_->objects();
        if (!Unit::has_values(*device_)) {
            return;
        }
        static const LimitIndex index{objects};
        state_.checked.visit_changed(index, objects, [&objects](const EntryRef& entry) {
            require(entry.is(0x1003, 0) || Unit::shows_beyond_limits(objects, entry) ||
                        objects.check_value(entry, objects.value(entry)) == AbortCode::none,
                    "limits of", (entry.index * 0x100UL) + entry.row->subindex);
        });
    }

    /// Checks the frames that one event caused: they must be well-formed, have an identifier of the device or be
    /// permitted by Unit::may_also_send(), and contain at most one SDO answer. The transmit queue must not be full,
    /// because then a frame may be lost. It may be full only if it was not emptied for a long time (`may_be_full`).
    void drain(const Frame* cause, bool may_be_full = false) {
        require_consistent(*device_);
        require(may_be_full || state_.queue.size() < TransmitQueue::capacity, "room in the queue");
        static const IdentifierPlaces places{device_->objects()};
        if (!state_.own.follow(places, device_->objects(), device_->node_id(), Unit::answers_remote) &&
            state_.queue.empty()) {
            return;
        }
        int answers = 0;
        while (!state_.queue.empty()) {
            const Frame frame = state_.queue.pop();
            require(!frame.extended && !frame.remote && frame.length <= max_frame_length && frame.id <= 0x7FF);
            require(state_.own.has(frame.id) || Unit::may_also_send(frame), "the device owns the identifier", frame.id);
            if (frame.id >= 0x580U && frame.id < 0x600U) {
                ++answers;
                check_answer(cause, frame);
            }
            remember(frame);
            if (cause != nullptr && frame_probe.answers != nullptr) {
                frame_probe.answers(frame);
            }
        }
        require(answers <= 1);
        state_.due = device_->next_deadline();  // a block upload continues when the queue has room
    }
    /// Checks an SDO answer. Without a request, the server sends only the abort of a time-out, once.
    void check_answer(const Frame* cause, const Frame& answer) {
        constexpr std::uint32_t timed_out = 0x05040000;
        if (cause == nullptr) {
            require(is_abort(answer) && read_u32(answer.payload(), 4) == timed_out && state_.unasked == 0);
            ++state_.unasked;
            return;
        }
        state_.unasked = 0;
        require(cause->id == answer.id + 0x80U && !cause->remote && !cause->extended);
        require(is_legal_answer(*cause, answer));
    }
    void remember(const Frame& frame) {
        state_.digest.add(state_.now.us - start_);
        state_.digest.add(frame.id);
        state_.digest.add(frame.payload());
        state_.sent.push_back(frame);
    }

    using DeviceBytes = std::array<std::uint8_t, sizeof(Device)>;
    struct Storage {
        alignas(Device) DeviceBytes bytes;
    };
    /// Everything that changes during a run, except the device and its non-volatile memory.
    struct State {
        TransmitQueue queue;
        Inputs inputs{};
        Unit unit;
        Instant now{};
        Instant due{never};  ///< the next deadline of the device
        IdentifierWatch own;
        LimitWatch checked;
        unsigned unasked{0};
        std::vector<Frame> sent;
        Digest digest;
    };
    struct Kept {
        DeviceBytes device;
        Image memory;
        State state;
    };

    JournalMemory memory_;
    State state_;
    std::uint8_t garbage_;
    std::uint64_t start_;
    const std::unique_ptr<Storage> storage_{std::make_unique<Storage>()};
    Device* device_{nullptr};
    std::unique_ptr<const Kept> kept_;
};

}  // namespace canproof::fuzz
