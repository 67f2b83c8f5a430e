// The interface between src/devices/NAME/target/device.cpp and interrupts.cpp.
#pragma once

#include "target/stm32f405/chip.hpp"
#include "target/stm32f405/device_loop.hpp"

/// Handles the interrupt of received frames: the device's file drains its controller.
extern "C" void can_received();

namespace canproof::target {

/// Returns whether the image in flash matches its seal, the CRC that src/target/image/seal wrote.
bool is_sound();

/// Starts the chip and runs the device on it until power is lost. Returns when the device must not run: the image is
/// damaged, or no clock works.
template <typename Device, typename Board>
void run_image(Device& device, TransmitQueue& queue, Board& board, stm32f405::Chip& chip,
               stm32f405::ParameterJournal& memory) {
    if (!is_sound()) {
        return;
    }
    chip.start();
    if (chip.source == stm32f405::ClockSource::none) {
        return;
    }
    board.start();
    memory.open();
    static_cast<void>(memory.prepare());  // if it fails, a later commit erases the sector itself or reports the failure
    stm32f405::DeviceLoop<Device, Board> loop{device, queue, board, chip.can, chip.time, chip.watchdog};
    loop.power_on(chip.source == stm32f405::ClockSource::crystal);
    for (;;) {
        loop.pass();
    }
}

}  // namespace canproof::target
