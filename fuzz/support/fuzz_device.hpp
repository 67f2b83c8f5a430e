// SPDX-License-Identifier: Apache-2.0
// Runs one input of a fuzz target on a device. Checks that two runs have the same result, that a reset at the end
// works, and that the device behaves like its naive model.
#pragma once

#include "fuzz/support/beside_hook.hpp"
#include "fuzz/support/device_world.hpp"

namespace canproof::fuzz {

/// Checks that a device after a reset (`used`) is the same as a device that was switched on at that moment (`fresh`).
template <typename Unit>
void require_same(DeviceWorld<Unit>& used, DeviceWorld<Unit>& fresh) {
    const std::vector<Frame> said = used.take_sent();
    const std::vector<Frame> expected = fresh.take_sent();
    require(said.size() == expected.size(), "a reset node sends what a fresh one sends");
    for (std::size_t i = 0; i < said.size(); ++i) {
        require(
            said[i].id == expected[i].id && said[i].length == expected[i].length && said[i].data == expected[i].data,
            "a reset node sends what a fresh one sends", said[i].id);
    }
    const ByteView values = used.device().objects().image();
    require(std::equal(values.data(), values.data() + values.size(), fresh.device().objects().image().data()),
            "a reset node has the values of a fresh one");
    Digest outputs;
    for_each_output(used.device().outputs(), [&outputs](const char*, const auto& value) { outputs.add(value); });
    Digest wanted;
    for_each_output(fresh.device().outputs(), [&wanted](const char*, const auto& value) { wanted.add(value); });
    require(outputs.value() == wanted.value(), "a reset node drives what a fresh one drives");
}

/// Checks that a device after the NMT command reset node behaves like a device that is switched on at the same moment
/// with the same memory and inputs (CO-NMT-005). Skips devices of three kinds:
/// - A device that receives no command, because it has no node-ID or LSS switches its bit rate.
/// - A device that takes another node-ID or bit rate at power-on, but not at reset node.
/// - A device that keeps the value of an output over the reset (Unit::keeps_outputs()).
template <typename Unit>
void check_reset(DeviceWorld<Unit>& used) {
    used.recover();
    used.take_sent();
    Frame command = data_frame(0, 2);
    command.data[0] = 0x81;
    command.data[1] = used.device().node_id();
    used.receive(command);
    DeviceWorld<Unit> fresh{{used.now().us, 0x5A}, used.memory(), used.inputs()};
    const bool is_moved =
        fresh.device().node_id() != used.device().node_id() || fresh.device().bit_rate() != used.device().bit_rate();
    if (!used.has_sent() || is_moved || Unit::keeps_outputs(used.device(), used.inputs())) {
        return;
    }
    require_same(used, fresh);
    const std::uint8_t node = used.device().node_id();
    Frame start = command;
    start.data[0] = 1;
    Frame guarding = data_frame(0x700U + node, 0);
    guarding.remote = true;
    for (const Frame& frame : {start, data_frame(0x80, 0), guarding}) {
        for (DeviceWorld<Unit>* world : {&used, &fresh}) {
            world->receive(frame);
            world->pass(milliseconds(40));
        }
        require_same(used, fresh);
    }
}

/// Owns a DeviceWorld that is made once. Each input begins from the state after its power-on.
template <typename World>
class Reused {
  public:
    explicit Reused(const Circumstances& circumstances) : world_{circumstances} { world_.keep_start(); }

    World& at_start() {
        world_.restart();
        return world_;
    }

  private:
    World world_;
};

template <typename Unit>
void run_events(const std::uint8_t* data, std::size_t size, DeviceWorld<Unit>& world) {
    const std::size_t count = std::min(size / device_record_size, most_device_records);
    for (std::size_t i = 0; i < count; ++i) {
        world.happen(data + i * device_record_size);
        world.check();
    }
    world.settle();
}

template <typename Unit>
std::uint64_t run_world(const std::uint8_t* data, std::size_t size, const Circumstances& circumstances,
                        DeviceWorld<Unit>& world) {
    run_events(data, size, world);
    const std::uint64_t digest = world.digest();
    if (circumstances.begins_us != 0) {  // only the second of the two runs of an input checks the reset
        check_reset(world);
    }
    return digest;
}

/// Runs one input in a new DeviceWorld. Needs memory for one DeviceWorld, and for two during the check of the reset.
template <typename Unit>
std::uint64_t run_in_new_world(const std::uint8_t* data, std::size_t size, const Circumstances& circumstances) {
    DeviceWorld<Unit> world{circumstances};
    return run_world(data, size, circumstances, world);
}

/// Runs one input on a device. Some inputs run a second time, which must have the same result, because the behaviour of
/// a device depends on its events only. Some inputs also run beside the naive model of the device. On the
/// microcontroller, runs every input twice and makes a new DeviceWorld for each run, because its memory is too small to
/// keep them.
template <typename Unit>
int fuzz_device(const std::uint8_t* data, std::size_t size) {
    constexpr bool has_room = sizeof(std::size_t) > sizeof(std::uint32_t);
    if constexpr (has_room) {
        static Reused<DeviceWorld<Unit>> first{Circumstances{}};
        static Reused<DeviceWorld<Unit>> second{late_and_dirty};
        Digest hash;
        hash.add(ByteView{data, size});
        begin_checks(hash.value());
        DeviceWorld<Unit>& world = first.at_start();
        run_events(data, size, world);
        if (samples.is_repeated(hash.value())) {
            require(world.digest() == run_world(data, size, late_and_dirty, second.at_start()), "two runs are equal");
        }
        // a frame log must show only one run, so there is no run beside the model
        const bool is_logged = frame_probe.begins != nullptr;
        if (beside_model != nullptr && !is_logged && samples.is_compared(hash.value())) {
            beside_model(data, size);
        }
    } else {
        const std::uint64_t digest = run_in_new_world<Unit>(data, size, {});
        require(digest == run_in_new_world<Unit>(data, size, late_and_dirty), "two runs are equal");
    }
    return 0;
}

}  // namespace canproof::fuzz
