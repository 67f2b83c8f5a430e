// What src/devices/NAME/target/device.cpp and interrupts.cpp know of each other.
#pragma once

#include "target/stm32f405/chip.hpp"
#include "target/stm32f405/device_loop.hpp"

/// The interrupt of received frames: the device's file drains its controller.
extern "C" void can_received();

namespace canproof::target {

/// Whether flash holds what seal has sealed.
bool is_sound();

/// Starts the chip and the device on it, and goes on until power is lost. Returns when the device must not run: the
/// image is damaged, or no clock is right.
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
    static_cast<void>(memory.prepare());  // without it a commit has to erase, or says that it failed
    stm32f405::DeviceLoop<Device, Board> loop{device, queue, board, chip.can, chip.time, chip.watchdog};
    loop.power_on(chip.source == stm32f405::ClockSource::crystal);
    for (;;) {
        loop.pass();
    }
}

}  // namespace canproof::target
