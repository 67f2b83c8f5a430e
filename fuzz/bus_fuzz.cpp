// SPDX-License-Identifier: Apache-2.0
// Fuzzes all devices together on one bus. A frame of the master reaches all devices; a frame of a device reaches the
// other devices with the same bit rate. Changed inputs, memory failures and power cuts apply to one device; time passes
// for all of them. An input consists of the records that support/device_world.hpp describes; the upper half of a
// record's first byte selects the device, in the order of `bus_node`.
#include <tuple>

#include "fuzz/support/beside_hook.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/device_world.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "generated/canopen/requirements.hpp"
#include "generated/every_unit.hpp"

namespace {

using namespace canproof;
using fuzz::require;

constexpr std::size_t most_records = 60;
constexpr unsigned most_frames_at_once = 1000;
constexpr std::uint32_t bit_rate = 125000;

/// Returns a memory in which LSS has stored the device's node-ID. A device without LSS gets an empty memory.
template <typename Unit>
fuzz::Image memory_of() {
    fuzz::JournalMemory memory{fuzz::Image(Unit::memory_size, 0xFF)};
    if constexpr (Unit::has_lss) {
        LssStore{memory}.store({Unit::bus_node, bit_rate});
    }
    return memory.image();
}

template <typename Unit>
struct Seat {
    explicit Seat(const fuzz::Circumstances& circumstances) : world{circumstances, memory_of<Unit>()} {}
    fuzz::DeviceWorld<Unit> world;
};

template <typename Units>
class Bus;

template <typename... Unit>
class Bus<std::tuple<Unit...>> {
  public:
    explicit Bus(const fuzz::Circumstances& circumstances) : seats_{same<Unit>(circumstances)...} {
        for_each([](auto& world) { world.keep_start(); });
    }

    /// Switches all devices on again, each with the memory content that it had at first.
    void restart() {
        for_each([](auto& world) { world.restart(); });
        exchange();
    }
    void happen(const std::uint8_t* record) {
        const unsigned whose = (record[0] >> 4U) % sizeof...(Unit);
        std::optional<Frame> frame;
        unsigned number = 0;
        for_each([&](auto& world) {
            if (number++ != whose) {
                return;
            }
            frame = world.frame_in(record);
            if (!frame && (record[0] & 0x0FU) != 0xCU) {
                world.befall(record);
            }
        });
        if (frame) {
            for_each([&frame](auto& world) { world.receive(*frame); });
        } else if ((record[0] & 0x0FU) == 0xCU) {
            pass(fuzz::duration_in(record));
        }
        exchange();
        for_each([](auto& world) { world.check(); });
    }
    void settle() {
        pass(milliseconds(5));
        for_each([](auto& world) { world.check(); });
    }
    std::uint64_t digest() {
        fuzz::Digest all;
        for_each([&all](auto& world) { all.add(world.digest()); });
        return all.value();
    }

  private:
    template <typename Visit>
    void for_each(const Visit& visit) {
        std::apply([&visit](auto&... seat) { (visit(seat.world), ...); }, seats_);
    }
    template <typename>
    static const fuzz::Circumstances& same(const fuzz::Circumstances& circumstances) {
        return circumstances;
    }
    /// Delivers frames until the devices have stopped answering one another. Fails when they do not stop.
    void exchange() {
        unsigned frames = 0;
        for (bool quiet = false; !quiet;) {
            quiet = true;
            for_each([&](auto& sender) {
                sender.take_sent(sent_);
                for (const Frame& frame : sent_) {
                    require(++frames <= most_frames_at_once, "the bus comes to rest");
                    quiet = false;
                    deliver(frame, &sender, sender.device().bit_rate());
                }
            });
        }
    }
    /// Delivers the frame to all other devices that work at the same bit rate.
    void deliver(const Frame& frame, const void* sender, std::uint32_t rate) {
        for_each([&](auto& world) {
            if (&world != sender && world.device().bit_rate() == rate) {
                world.receive(frame);
            }
        });
    }
    void pass(Duration time) {
        const Instant end = now() + time;
        for (Instant next{}; next < end;) {
            next = end;
            for_each([&next](auto& world) { next = earliest(next, world.next_deadline()); });
            next = next < now() ? now() : next;
            for_each([next](auto& world) { world.run_until(next); });
            exchange();
        }
    }

    Instant now() const { return std::get<0>(seats_).world.now(); }

    std::tuple<Seat<Unit>...> seats_;
    std::vector<Frame> sent_;  ///< the frames that exchange() delivers; kept to reuse the memory
};

void run(const std::uint8_t* data, std::size_t size, Bus<fuzz::EveryUnit>& bus) {
    bus.restart();
    const std::size_t count = std::min(size / fuzz::device_record_size, most_records);
    for (std::size_t i = 0; i < count; ++i) {
        bus.happen(data + i * fuzz::device_record_size);
    }
    bus.settle();
}

}  // namespace

CANPROOF_FUZZ_RECORDS(fuzz::device_record_size)
CANPROOF_FUZZ_CLAIMS(req::CO_SDO_015, req::CO_SDO_044, req::CO_STORE_004)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::begin_checks(data, size);
    // the devices are made once for all inputs, because making them takes longer than running an input
    static Bus<fuzz::EveryUnit> first{fuzz::Circumstances{}};
    static Bus<fuzz::EveryUnit> second{fuzz::late_and_dirty};
    fuzz::Digest hash;
    hash.add(ByteView{data, size});
    run(data, size, first);
    if (fuzz::samples.is_repeated(hash.value())) {
        run(data, size, second);
        require(first.digest() == second.digest(), "two runs are equal");
    }
    return 0;
}
