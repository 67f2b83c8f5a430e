// SPDX-License-Identifier: Apache-2.0
// Runs the image of a device as it is flashed, with main loop and wiring, on models of the chip. An image never returns
// while its device runs, so the bench leaves it by longjmp() from within an access to a register.
#pragma once

#include <csetjmp>
#include <functional>
#include <vector>

#include "tests/support/stm32f405/chip_model.hpp"
#include "tests/support/stm32f405/image_store.hpp"

namespace canproof::test {

/// The entry points and parts of an image, whose variables have static storage.
struct FlashedImage {
    void (*reset)();     ///< constructs the variables again, as after a reset
    void (*run)();       ///< image_main()
    void (*received)();  ///< can_received()
    void (*failed)();    ///< device_failed()
    void* device;        ///< the object of the type Device
    TransmitQueue* queue;
};
FlashedImage flashed_ax060805();
FlashedImage flashed_ax130751();
FlashedImage flashed_ax188001();
FlashedImage flashed_cbx_ao412();

/// One run of an image, from a reset on. A pass of the main loop takes 100 us.
class FlashedBench {
  public:
    explicit FlashedBench(const FlashedImage& image);
    ~FlashedBench();
    FlashedBench(const FlashedBench&) = delete;
    FlashedBench& operator=(const FlashedBench&) = delete;
    FlashedBench(FlashedBench&&) = delete;
    FlashedBench& operator=(FlashedBench&&) = delete;

    ChipModel chip;
    bool bus_is_busy{false};                        ///< whether frames of other nodes keep the device from sending
    std::function<void()> on_pass{};                ///< called at the start of each pass
    std::function<void(std::uintptr_t)> on_read{};  ///< called before the image reads the register at an address

    /// Runs the image for `passes` passes of the main loop. Returns whether the image still ran at their end.
    bool run(std::uint32_t passes);
    /// Inverts a bit of a byte of the image.
    static void damage(void* byte) { *static_cast<std::uint8_t*>(byte) ^= 0x40U; }
    /// Returns the number of passes that have begun, and how often CAN_MSR was read in the present pass.
    std::uint32_t passes() const { return passes_; }
    std::uint32_t status_reads() const { return status_reads_; }
    /// Returns the frames that were sent since the last call.
    std::vector<Frame> take_sent() { return std::exchange(sent_, {}); }
    /// Takes the failed self-test that the image has recorded.
    static stm32f405::SelfTest take_record();

  private:
    void note(const Access& access);
    void begin_pass();

    FlashedImage image_;
    std::jmp_buf end_{};
    std::uint32_t passes_{0}, last_{0}, status_reads_{0};
    bool is_inside_{false};  ///< the present access comes from the bench
    std::vector<Frame> sent_;
};

}  // namespace canproof::test
