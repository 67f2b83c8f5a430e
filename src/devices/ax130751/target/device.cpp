// The AX130751 as an image that is flashed onto an STM32F405.
#include "devices/ax130751/target/wiring.hpp"
#include "target/image/image.hpp"

namespace {

using namespace canproof;

// The device's table of bit rates contains 666.667 kbit/s but not 800 kbit/s, so a core clock of 168 MHz fits all
// rates.
stm32f405::Chip chip{stm32f405::core_168_mhz};
stm32f405::JournalRam<8192> ram;
stm32f405::ParameterJournal memory{chip.flash, stm32f405::parameter_sectors(), MutableBytes{ram.bytes},
                                   Slots<std::uint32_t>{ram.changed}};
TransmitQueue queue;
ax130751::Device device{memory, queue, ax130751::FactoryData{}};
ax130751::Wiring wiring{chip};

}  // namespace

extern "C" void can_received() {
    chip.can.drain();
}

extern "C" void image_main() {
    target::run_image(device, queue, wiring, chip, memory);
}
