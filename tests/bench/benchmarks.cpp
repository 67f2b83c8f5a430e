// SPDX-License-Identifier: Apache-2.0
// Measures times with Google Benchmark: the times of the transactions of tests/bench/count, of a whole node and of the
// host tools. tests/bench/compare compares a run with the stored baseline.
#include <benchmark/benchmark.h>

#include "devices/catalogue.hpp"
#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/run/device_node.hpp"
#include "tests/bench/fleet.hpp"
#include "tests/bench/transactions.hpp"

namespace canproof::bench {

namespace {

void tick_idle(benchmark::State& state) {
    Fleet fleet{1, false};
    fleet.run(milliseconds(1000));
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(fleet.run(milliseconds(1)));
    }
}

/// Configures each AX130751: its lookup tables take received value 1 (7300h:1) as input, its math and logic blocks take
/// lookup tables. The blocks stay disabled. By default, analogue output 1 also follows received value 1.
void configure(Fleet& fleet) {
    const auto write = [&fleet](unsigned index, unsigned subindex, unsigned value) {
        char text[32];
        std::snprintf(text, sizeof(text), "601#2F%02X%02X%02X%02X000000", index & 0xFFU, index >> 8U, subindex, value);
        fleet.receive(host::parse_frame(text, "configuration"));
    };
    for (unsigned table = 1; table <= 10; ++table) {
        const unsigned first = table < 10 ? 0x3000 + table * 0x10 : 0x3100;
        write(first, 0, 1);      // source: CANopen message
        write(first + 1, 0, 1);  // number of the received value that is the input
    }
    for (unsigned block = 1; block <= 4; ++block) {
        for (unsigned input = 1; input <= 4; ++input) {
            write(0x4000 + block * 0x100, input, 3);          // source: lookup table
            write(0x4000 + block * 0x100 + 1, input, block);  // number of the lookup table
        }
    }
    for (unsigned block = 1; block <= 3; ++block) {
        for (unsigned condition : {0x11U, 0x12U, 0x13U, 0x21U, 0x22U, 0x23U, 0x31U, 0x32U, 0x33U}) {
            write(0x3300 + block * 0x100 + condition, 1, 3);
            write(0x3300 + block * 0x100 + condition, 2, 1);
        }
    }
}

void tick_configured(benchmark::State& state) {
    Fleet fleet{1};
    configure(fleet);
    std::uint8_t value = 0;
    for ([[maybe_unused]] auto _ : state) {
        Frame command = data_frame(0x201, 5);  // the default mapping of RPDO1: 7300h:1, 7300h:2, 6220h:3
        command.data[0] = ++value;
        fleet.receive(command);
        benchmark::DoNotOptimize(fleet.run(milliseconds(1)));
    }
}

void power_on(benchmark::State& state) {
    const auto device = host::make_device("ax130751");
    for ([[maybe_unused]] auto _ : state) {
        device->power_on(Instant{});
        benchmark::DoNotOptimize(device->queue().pop());
    }
}

/// Simulates one second of a bus with 127 nodes, all operational with their default PDOs.
void bus_of_127(benchmark::State& state) {
    std::vector<std::unique_ptr<host::DeviceNode>> nodes;
    host::ArbitratedBus bus{"bench", 1000000, host::BusFaultRates{}};
    for (int id = 1; id <= 127; ++id) {
        auto device = host::make_device("ax130751");
        device->set_node_id(id);
        nodes.push_back(std::make_unique<host::DeviceNode>("n" + std::to_string(id), std::move(device)));
        nodes.back()->power_on(Instant{});
        bus.attach(*nodes.back());
    }
    Instant now{};
    bus.put(host::parse_frame("000#0100", "start"), now);
    const auto next = [&] {
        Instant due = bus.next_deadline();
        for (const auto& node : nodes) {
            due = earliest(due, node->device().next_deadline());
        }
        return due;
    };
    for ([[maybe_unused]] auto _ : state) {
        const Instant end = now + milliseconds(1000);
        for (Instant due = next(); due <= end; due = next()) {
            for (const auto& node : nodes) {
                if (node->device().next_deadline() <= due) {
                    node->device().advance(due);
                }
            }
            bus.advance(due);
            now = due;
        }
        now = end;
    }
    state.counters["frames"] = static_cast<double>(bus.report(now).frames);
}

void register_compile(benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(host::load_register(host::embedded_spec()).content.parts.size());
    }
}

void audit_all(benchmark::State& state) {
    const host::LoadResult loaded = host::load_register(host::embedded_spec());
    const host::Evidence evidence;
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(host::audit_all(loaded.content, evidence).size());
    }
}

void register_all() {
    for (const Transaction& transaction : transactions()) {
        benchmark::RegisterBenchmark(transaction.name.c_str(), [&transaction](benchmark::State& state) {
            TestNode node;
            transaction.prepare(node);
            for ([[maybe_unused]] auto _ : state) {
                transaction.run(node);
            }
        });
    }
    benchmark::RegisterBenchmark("tick of an idle AX130751, 1 ms", tick_idle);
    benchmark::RegisterBenchmark("RPDO and tick of a configured AX130751, 1 ms", tick_configured);
    benchmark::RegisterBenchmark("power-on of an AX130751", power_on);
    benchmark::RegisterBenchmark("bus of 127 AX130751, 1 s", bus_of_127)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("register compile", register_compile)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("audit", audit_all)->Unit(benchmark::kMillisecond);
}

}  // namespace

}  // namespace canproof::bench

int main(int argc, char** argv) {
    canproof::bench::register_all();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
