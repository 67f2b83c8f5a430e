// SPDX-License-Identifier: Apache-2.0
// A device with the main loop and the self-tests of a flashed image. The harness replaces the drivers of bus, clock and
// terminals.
#pragma once

#include <cstring>
#include <new>

#include "target/faults/campaign.hpp"
#include "target/image/image.hpp"

namespace canproof::faults {

struct Can {
    std::uint32_t bit_rate() const { return can_bit_rate(); }
    void set_bit_rate(std::uint32_t rate, Instant) { set_can_bit_rate(rate); }
    void advance(TransmitQueue& queue, Instant) {
        while (!queue.empty()) {
            frame_sent(queue.pop());
        }
    }
    bool receive(Frame& frame) { return take_frame(frame); }
    CanState state() const { return CanState::error_active; }
    bool take_overrun() { return false; }
};

struct Time {
    Instant now() const { return time_now(); }
};

struct Refreshed {
    bool start() { return true; }
    void refresh() {}
};

struct Drivers {
    using Can = faults::Can;
    using Time = faults::Time;
    using Watchdog = faults::Refreshed;
};

template <typename InputsOfDevice, typename OutputsOfDevice>
struct Board {
    using Inputs = InputsOfDevice;
    using Outputs = OutputsOfDevice;
    void read(Inputs& inputs) { std::memcpy(&inputs, present_inputs().data(), sizeof(Inputs)); }
    void drive(const Outputs& outputs) { outputs_driven(&outputs, sizeof(Outputs)); }
};

template <std::size_t Size>
class RamMemory final : public NonVolatileMemory {
  public:
    std::size_t size() const override { return Size; }
    bool read(std::size_t at, MutableBytes to) const override {
        to.copy(0, ByteView{bytes_}.part(at, to.size()));
        return at + to.size() <= Size;
    }
    bool write(std::size_t at, ByteView from) override {
        MutableBytes{bytes_}.copy(at, from);
        return at + from.size() <= Size;
    }
    bool commit() override { return true; }

  private:
    std::array<std::uint8_t, Size> bytes_{};
};

/// The registers by which the self-test measures the clock. The harness writes a correct capture value before each
/// pass.
stm32f405::CaptureRegisters& capture_registers();

template <typename Device, typename Inputs, typename Outputs, typename FactoryData, std::size_t MemorySize>
class DeviceSubject final : public Subject {
  public:
    void power_on(bool with_tests) override {
        with_tests_ = with_tests;
        if (with_tests_) {
            loop_.power_on(true);
        } else {
            board_.read(inputs_);
            device_.power_on(inputs_, time_now());
        }
    }
    void pass() override {
        if (with_tests_) {
            loop_.pass();
        } else {
            plain_pass();
        }
    }
    std::uint32_t failed() const override { return static_cast<std::uint32_t>(loop_.failed()); }
    std::uint32_t tested() const override {
        return tests_.flash().passes() < tests_.ram().passes() ? tests_.flash().passes() : tests_.ram().passes();
    }
    void convert(const Event& event, RawBytes& raw) const override {
        Inputs inputs{};
        std::size_t place = 0;
        for_each_input(inputs, [&](const char*, auto& input) {
            const double value = event.values[place++];
            if (value == value) {  // an input that is NaN keeps its default
                input = static_cast<std::decay_t<decltype(input)>>(value);
            }
        });
        static_assert(sizeof(Inputs) <= most_bytes && sizeof(Outputs) <= most_bytes);
        std::memcpy(raw.data(), &inputs, sizeof inputs);
    }
    void mask_outputs(RawBytes& mask) const override {
        const Outputs outputs{};
        for_each_output(outputs, [&](const char*, const auto& output) {
            const auto at = reinterpret_cast<std::uintptr_t>(&output) - reinterpret_cast<std::uintptr_t>(&outputs);
            std::memset(&mask[at], 0xFF, sizeof output);
        });
    }
    std::array<Area, 4> areas() const override {
        return {Area{&device_, sizeof device_}, Area{&queue_, sizeof queue_}, Area{&memory_, sizeof memory_},
                Area{&tests_, sizeof *this - static_cast<std::size_t>(reinterpret_cast<std::uintptr_t>(&tests_) -
                                                                      reinterpret_cast<std::uintptr_t>(this))}};
    }

  private:
    /// Does what a pass of the main loop does, without self-tests.
    void plain_pass() {
        const Instant now = time_now();
        if (can_.bit_rate() != device_.bit_rate()) {
            can_.set_bit_rate(device_.bit_rate(), now);
        }
        can_.advance(queue_, now);
        board_.read(inputs_);
        inputs_.can_state = 0;
        device_.set_inputs(inputs_, now);
        Frame frame{};
        while (can_.receive(frame)) {
            device_.receive(frame, now);
        }
        if (device_.next_deadline() <= now) {
            device_.advance(now);
        }
        can_.advance(queue_, now);
        board_.drive(device_.outputs());
    }

    RamMemory<MemorySize> memory_;
    TransmitQueue queue_;
    Device device_{memory_, queue_, FactoryData{}};
    // The members from here on belong to the main loop and the self-tests.
    stm32f405::SelfTests tests_{target::image_memory(), capture_registers(), 84};
    Board<Inputs, Outputs> board_;
    Can can_;
    Time time_;
    Refreshed watchdog_;
    stm32f405::DeviceLoop<Device, Board<Inputs, Outputs>, Drivers> loop_{device_, queue_,    board_, can_,
                                                                         time_,   watchdog_, tests_};
    Inputs inputs_{};
    bool with_tests_{false};
};

}  // namespace canproof::faults
