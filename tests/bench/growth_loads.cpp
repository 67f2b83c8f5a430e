// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/growth_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "devices/catalogue.hpp"
#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "host/sim/replay/replay.hpp"
#include "host/sim/run/run_session.hpp"
#include "tests/bench/fleet.hpp"

namespace canproof::bench {

namespace {

using host::parse_frame;

constexpr unsigned rpdos_of_a_node = 8;

void expect(bool holds, const std::string& what) {
    if (!holds) {
        throw std::logic_error{what};
    }
}

/// Returns a log with one frame per millisecond: process data of other nodes, and in every hundredth line a request to
/// the device.
std::string log_of(std::size_t lines) {
    std::string text;
    for (std::size_t n = 0; n < lines; ++n) {
        const std::string frame =
            n % 100 == 0 ? "603#4018100400000000" : fmt::format("{:03X}#{:08X}00000000", 0x181 + n % 100, n);
        text += fmt::format("({}.{:03}000) can0 {}\n", n / 1000, n % 1000, frame);
    }
    return text;
}

std::function<void()> replay_of(std::size_t lines) {
    return [log = std::make_shared<std::istringstream>(log_of(lines)), lines] {
        const auto device = host::make_device("cbx-ao412");
        device->set_node_id(3);
        host::CandumpReader reader{*log, "log"};
        host::ReplayInput input;
        input.source = [&reader](host::LoggedFrame& frame) { return reader.next(frame); };
        std::ostringstream out;
        host::replay(*device, input, out, nullptr);
        const std::string sent = out.str();
        const auto answers = static_cast<std::size_t>(std::count(sent.begin(), sent.end(), '\n'));
        expect(answers == 1 + (lines + 99) / 100, "replay answers each request");
    };
}

/// Returns the text of an EDS with `entries` entries of two bytes. The limits differ from entry to entry.
std::string sheet_of(std::size_t entries) {
    constexpr std::size_t of_an_object = 8;
    const std::size_t objects = (entries + of_an_object - 1) / of_an_object;
    std::string list = fmt::format("[ManufacturerObjects]\nSupportedObjects={}\n", objects);
    std::string text = "[DeviceInfo]\nProductName=Many\nBaudRate_125=1\n";
    for (std::size_t n = 0; n < objects; ++n) {
        list += fmt::format("{}=0x{:04X}\n", n + 1, 0x2000 + n);
        text +=
            fmt::format("[{:04X}]\nParameterName=Block {}\nObjectType=9\nSubNumber={}\n", 0x2000 + n, n, of_an_object);
        text +=
            fmt::format("[{:04X}sub0]\nParameterName=Count\nObjectType=7\nDataType=5\nAccessType=ro\nDefaultValue={}\n",
                        0x2000 + n, of_an_object - 1);
        for (std::size_t sub = 1; sub < of_an_object; ++sub) {
            text += fmt::format(
                "[{:04X}sub{:X}]\nParameterName=Value {}\nObjectType=7\nDataType=6\nAccessType=rw\n"
                "DefaultValue={}\nPDOMapping=0\nLowLimit=0\nHighLimit={}\n",
                0x2000 + n, sub, sub, sub, 1000 + n);
        }
    }
    return text + list;
}

host::Part part_of(const std::string& sheet) {
    host::EdsResult read = host::read_eds(sheet, "many.eds");
    expect(read.faults.empty() && !read.part.objects.empty(), "the sheet is read");
    return std::move(read.part);
}

std::function<void()> start_up_of(std::size_t entries) {
    return [sheet = sheet_of(entries)] {
        host::GenericSimulation device{part_of(sheet)};
        device.set_node_id(5);
        device.power_on(Instant{});
        expect(device.queue().pop().id == 0x705, "the device boots");
    };
}

/// Makes a device with `entries` entries. The work sends `entries` SDO requests, all for objects that do not exist.
std::function<void()> missing_objects_of(std::size_t entries) {
    auto device = std::make_shared<host::GenericSimulation>(part_of(sheet_of(entries)));
    device->set_node_id(5);
    device->power_on(Instant{});
    device->queue().pop();
    return [device, entries] {
        for (std::size_t n = 0; n < entries; ++n) {
            Frame request = data_frame(0x605, 8);
            request.data = {0x40, static_cast<std::uint8_t>(n), static_cast<std::uint8_t>(0xA0 + (n >> 8U) % 0x40), 0};
            device->receive(request, Instant{1000});
            const Frame answer = device->queue().pop();
            expect(answer.data[0] == 0x80 && answer.data[6] == 0x02 && answer.data[7] == 0x06, "object missing");
        }
    };
}

std::shared_ptr<host::RunSession> session_of(std::vector<std::unique_ptr<host::DeviceNode>> nodes,
                                             std::vector<host::Stimulus> stimuli) {
    constexpr std::uint32_t bit_rate = 1000000;
    auto bus = std::make_unique<host::ArbitratedBus>("bench", bit_rate, host::BusFaultRates{});
    auto session = std::make_shared<host::RunSession>(std::move(bus), std::move(nodes), std::move(stimuli),
                                                      host::SessionOutputs{});
    session->power_on();
    session->advance_to(Instant{50000});  // by 50 ms, all boot-up messages have been sent
    expect(session->put(parse_frame("000#0100", "start")), "the bus takes a frame");
    return session;
}

/// Returns the text of an EDS with eight RPDOs of one byte each. The RPDOs have consecutive COB-IDs from `first` on.
std::string sheet_of_rpdos(unsigned first) {
    std::string text =
        "[DeviceInfo]\nProductName=Receiver\nBaudRate_1000=1\n[2000]\nParameterName=Output\nObjectType=7\n"
        "DataType=5\nAccessType=rww\nPDOMapping=1\n";
    for (unsigned n = 0; n < rpdos_of_a_node; ++n) {
        text += fmt::format(
            "[{0:04X}]\nParameterName=RPDO\nObjectType=9\n"
            "[{0:04X}sub1]\nParameterName=COB-ID\nDataType=7\nAccessType=rw\nDefaultValue=0x{1:X}\n"
            "[{0:04X}sub2]\nParameterName=Type\nDataType=5\nAccessType=rw\nDefaultValue=255\n"
            "[{2:04X}]\nParameterName=Mapping\nObjectType=9\n"
            "[{2:04X}sub0]\nParameterName=Count\nDataType=5\nAccessType=rw\nDefaultValue=1\n"
            "[{2:04X}sub1]\nParameterName=Line\nDataType=7\nAccessType=rw\nDefaultValue=0x20000008\n",
            0x1400U + n, first + n, 0x1600U + n);
    }
    return text;
}

/// Makes nodes with eight RPDOs each, `count` RPDOs in total. The work sends one frame for each RPDO.
std::function<void()> rpdos_of(std::size_t count) {
    constexpr unsigned first_identifier = 0x181;
    std::vector<std::unique_ptr<host::DeviceNode>> nodes;
    for (unsigned n = 0; n < count / rpdos_of_a_node; ++n) {
        auto device =
            std::make_unique<host::GenericSimulation>(part_of(sheet_of_rpdos(first_identifier + n * rpdos_of_a_node)));
        device->set_node_id(static_cast<int>(n) + 1);
        nodes.push_back(std::make_unique<host::DeviceNode>(fmt::format("n{}", n + 1), std::move(device)));
    }
    auto session = session_of(std::move(nodes), {});
    session->advance_to(Instant{60000});
    return [session, count] {
        for (std::size_t n = 0; n < count; ++n) {
            Frame frame = data_frame(static_cast<std::uint32_t>(first_identifier + n), 1);
            frame.data[0] = 0x5A;
            expect(session->put(frame), "the bus takes an RPDO");
            session->advance_to(session->now() + milliseconds(1));
        }
        for (const auto& node : session->nodes()) {
            expect(node->device().objects()->read(0x2000, 0) == 0x5A, "each node takes its RPDOs");
        }
    };
}

/// Returns a bus of 125 kbit/s, the default bit rate, with `count` operational AX130751. `begin_ms`, the present time
/// of the bus, is shortly before their TPDOs are due. With default parameters each device sends ten TPDOs per second.
/// For `length_ms` from `begin_ms` on, the supply voltage of each device changes every millisecond.
std::shared_ptr<host::RunSession> busy_bus_of(std::size_t count, std::uint64_t begin_ms, std::uint64_t length_ms) {
    std::vector<std::unique_ptr<host::DeviceNode>> nodes;
    std::vector<host::Stimulus> stimuli;
    for (std::size_t n = 0; n < count; ++n) {
        auto device = host::make_device("ax130751");
        device->set_node_id(static_cast<int>(n) + 1);
        nodes.push_back(std::make_unique<host::DeviceNode>(fmt::format("n{}", n + 1), std::move(device)));
    }
    for (std::uint64_t ms = begin_ms + 1; ms <= begin_ms + length_ms; ++ms) {
        for (const auto& node : nodes) {
            stimuli.push_back(
                {"bench", Instant{1000 * ms}, node->name() + ".supply", 20.0 + static_cast<double>(ms % 10)});
        }
    }
    auto session = session_of(std::move(nodes), std::move(stimuli));
    session->advance_to(Instant{1000 * begin_ms});
    return session;
}

/// Runs `count` busy AX130751 for 80 ms, in which each sends one TPDO. A bus of 125 kbit/s carries the TPDOs of at most
/// 64 devices, so more devices are put on several buses.
std::function<void()> busy_buses_of(std::size_t count) {
    constexpr std::size_t most_on_a_bus = 64;
    constexpr std::uint64_t begin_ms = 240;  // the TPDOs are due at 250 ms: 200 ms after the start at 50 ms
    constexpr std::uint64_t measured_ms = 80;
    std::vector<std::shared_ptr<host::RunSession>> buses;
    for (std::size_t left = count; left > 0; left -= std::min(left, most_on_a_bus)) {
        buses.push_back(busy_bus_of(std::min(left, most_on_a_bus), begin_ms, measured_ms));
    }
    return [buses, count] {
        std::uint64_t sent = 0;
        for (const auto& bus : buses) {
            const std::uint64_t before = bus->bus().report(bus->now()).frames;
            bus->advance_to(bus->now() + milliseconds(measured_ms));
            sent += bus->bus().report(bus->now()).frames - before;
        }
        expect(sent >= count, fmt::format("each device sends a TPDO, not {} for {}", sent, count));
    };
}

/// Runs `count` AX130751 as busy_buses_of() does, but for 10 ms and without a bus.
std::function<void()> fleet_of(std::size_t count) {
    auto fleet = std::make_shared<Fleet>(count);
    fleet->run(milliseconds(95));
    return [fleet, count] {
        std::size_t frames = 0;
        for (int ms = 0; ms < 10; ++ms) {
            frames += fleet->run(milliseconds(1));
            for (std::size_t n = 0; n < count; ++n) {
                fleet->device(n).set_input("supply", 20.0 + ms, fleet->now());
            }
        }
        expect(frames >= count, fmt::format("each device sends a TPDO, not {} for {}", frames, count));
    };
}

}  // namespace

const std::vector<Load>& loads() {
    static const std::vector<Load> all{
        {"replay of a log", "lines", {500, 2000, 8000}, 1000000, 2500, replay_of},
        {"start-up from an EDS", "entries", {128, 512, 2048}, 10000, 10000, start_up_of},
        {"SDO requests for objects that are missing",
         "entries and requests",
         {250, 1000, 4000},
         10000,
         270,
         missing_objects_of},
        {"RPDOs on one bus, eight a node", "PDOs", {32, 128, 512}, 512, 7700, rpdos_of},
        {"busy AX130751 on buses of 64, 80 ms", "devices", {8, 32, 64}, 1000, 750000, busy_buses_of},
        {"busy AX130751 without a bus, 10 ms", "devices", {10, 100, 1000}, 1000, 74000, fleet_of},
    };
    return all;
}

}  // namespace canproof::bench
