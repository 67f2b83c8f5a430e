// The AX060805 as an image that is flashed onto an STM32F405.
#include "devices/ax060805/target/wiring.hpp"
#include "target/image/image.hpp"

namespace {

using namespace canproof;

// The device's table of bit rates contains 800 kbit/s, which needs a core clock of 160 MHz.
stm32f405::Chip chip{stm32f405::core_160_mhz};
stm32f405::JournalRam<4096> ram;
stm32f405::ParameterJournal memory{chip.flash, stm32f405::parameter_sectors(), MutableBytes{ram.bytes},
                                   Slots<std::uint32_t>{ram.changed}};
TransmitQueue queue;
ax060805::Device device{memory, queue, ax060805::FactoryData{}};
ax060805::Wiring wiring{chip};

}  // namespace

extern "C" void can_received() {
    chip.can.drain();
}

extern "C" void image_main() {
    target::run_image(device, queue, wiring, chip, memory);
}
