// SPDX-License-Identifier: Apache-2.0
// Changes one parameter or input of a running AX188001 at a time, and compares the device with one that had all these
// values from power-on. After the change, the device must not use values that it computed for another type, voltage or
// cold junction (manual, 1.1, 3.3, 3.4).
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include "generated/ax188001/requirements.hpp"
#include "properties/devices/ax188001/tcs_generator.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// All parameters and inputs that determine the values of a device.
struct TcsState {
    std::array<unsigned, 2> type{1, 2};
    std::array<unsigned, 2> enabled{1, 1};
    std::array<unsigned, 2> compensated{1, 1};
    std::array<int, 2> factor{16, 18};
    std::array<int, 2> offset{4368, 320};
    std::array<int, 2> high_c{200, 300};  ///< 4010h (high warning threshold); 4020h (shutdown) stays 1735 degC
    std::array<double, 2> uv{4000.0, 9000.0};
    std::array<unsigned, 2> open{0, 0};
    double cold_junction_c{25.0};
    unsigned filter_hz{60};
    unsigned averages{1};
    int average_factor{16};
    int average_offset{4368};
    int cj_factor{16};
    int cj_offset{4368};
    double cpu_c{35.0};
    double supply_v{24.0};
    unsigned fd_high{1100};
};

void put(TcsBench& bench, const TcsState& state) {
    for (std::size_t i = 0; i < 2; ++i) {
        bench.inputs.tc_microvolts[i] = static_cast<float>(state.uv[i]);
        bench.inputs.tc_open[i] = state.open[i] != 0;
    }
    bench.inputs.cold_junction = static_cast<float>(state.cold_junction_c);
    bench.inputs.cpu_temperature = static_cast<float>(state.cpu_c);
    bench.inputs.supply = static_cast<float>(state.supply_v);
}

/// Writes the parameters whose values in `after` differ from those in `before`.
void write_changes(TcsRig& rig, const TcsState& before, const TcsState& after) {
    const auto change = [&](int index, int sub, int size, auto old_value, auto value) {
        if (old_value != value) {
            rig.happen(written(index, sub, size, static_cast<std::uint32_t>(value)));
        }
    };
    const auto change_real = [&](int index, int sub, int old_value, int value) {
        if (old_value != value) {
            rig.happen(written_real(index, sub, static_cast<float>(value)));
        }
    };
    for (std::size_t i = 0; i < 2; ++i) {
        const int sub = static_cast<int>(i) + 1;
        change(0x6110, sub, 2, before.type[i], after.type[i]);
        change(0x6112, sub, 1, before.enabled[i], after.enabled[i]);
        change(0x2000, sub, 1, before.compensated[i], after.compensated[i]);
        change_real(0x6126, sub, before.factor[i], after.factor[i]);
        change_real(0x6127, sub, before.offset[i], after.offset[i]);
        change(0x4010, sub, 2, tenths(before.high_c[i]), tenths(after.high_c[i]));
    }
    change(0x2020, 0, 1, before.filter_hz, after.filter_hz);
    change(0x2112, 0, 1, before.averages, after.averages);
    change_real(0x2126, 0, before.average_factor, after.average_factor);
    change_real(0x2127, 0, before.average_offset, after.average_offset);
    change_real(0x3126, 0, before.cj_factor, after.cj_factor);
    change_real(0x3127, 0, before.cj_offset, after.cj_offset);
    change(0x5041, 1, 2, before.fd_high, after.fd_high);
}

/// Waits for 13 readings, enough for a change of the filter (four readings) and for two changes of the gain until an
/// open circuit is found (1 + 2 * 4 readings).
void settle(TcsRig& rig) {
    rig.bench.pass(13 * TcsBench::period_ms);
}

/// Starts a device with wide limits and without delays, and sets the parameters and inputs of `state`.
void start(TcsRig& rig, const TcsState& state) {
    const TcsState shipped{{1, 1}, {1, 1}, {1, 1}, {16, 16}, {4368, 4368}, {125, 125}};
    put(rig.bench, state);
    rig.bench.set_inputs();
    for (int sub = 1; sub <= 2; ++sub) {
        rig.happen(written(0x4020, sub, 2, tenths(1735)));
        rig.happen(written(0x4030, sub, 2, 0));
        rig.happen(written(0x5051, sub, 2, 0));
    }
    write_changes(rig, shipped, state);
    settle(rig);
}

/// Changes one member of `state`: `which` chooses the member, `number` the channel and the new value.
void change_one(TcsState& state, unsigned which, unsigned number) {
    const std::size_t i = number % 2;
    const unsigned rest = number / 2;
    const auto other = [&](auto& target, auto value, auto instead) { target = target == value ? instead : value; };
    switch (which % 18) {
        case 0:
        case 1:
            return other(state.type[i], tcs_types[rest % 8], tcs_types[(rest + 1) % 8]);
        case 2:
            return other(state.enabled[i], 1U, 0U);
        case 3:
            return other(state.compensated[i], 1U, 0U);
        case 4:
            return other(state.factor[i], static_cast<int>(rest % 50) + 1, -7);
        case 5:
            return other(state.offset[i], static_cast<int>(rest % 5000), -77);
        case 6:
            return other(state.high_c[i], static_cast<int>(rest % 400) * 2 + 100, 99);
        case 7:
        case 8:
            return other(state.uv[i], static_cast<double>(rest % 16000) - 1000.0, 1234.5);
        case 9:
            return other(state.open[i], 1U, 0U);
        case 10:
        case 11:
            return other(state.cold_junction_c,
                         number % 2 == 0 ? static_cast<double>(rest % 1500) / 10.0 - 40.0 : state.cold_junction_c + 0.3,
                         21.5);
        case 12:
            return other(state.filter_hz, 50U, 60U);
        case 13:
            return other(state.averages, 0U, 1U);
        case 14:
            return other(rest % 2 == 0 ? state.average_factor : state.cj_factor, static_cast<int>(rest % 50) + 1, -7);
        case 15:
            return other(rest % 2 == 0 ? state.average_offset : state.cj_offset, static_cast<int>(rest % 5000), -77);
        case 16:
            return other(rest % 2 == 0 ? state.cpu_c : state.supply_v, 20.0 + static_cast<double>(rest % 25), 19.0);
        default:
            return other(state.fd_high, 850U + rest % 400, 849U + 402U);
    }
}

/// Returns the values that a settled device shows: all but 6150h (TC Status), which may depend on the previous
/// temperature.
std::vector<std::uint32_t> shown(const TcsRig& rig) {
    const auto read = [&](int index, int sub) {
        return rig.bench.device->objects().read(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
    };
    std::vector<std::uint32_t> all;
    for (int sub = 1; sub <= 2; ++sub) {
        for (const int index : {0x2010, 0x5040, 0x6100, 0x7130}) {
            // During an open circuit, 2010h (TC Input Microvolts) keeps the last voltage, so it is not compared.
            const bool is_kept = index == 0x2010 && rig.bench.inputs.tc_open[static_cast<std::size_t>(sub - 1)];
            all.push_back(is_kept ? 0 : read(index, sub));
        }
    }
    for (const int index : {0x2100, 0x2130, 0x3100, 0x3130}) {
        all.push_back(read(index, 0));
    }
    return all;
}

}  // namespace

RC_GTEST_PROP(Ax188001OneChange, DeviceAfterEachParameterOrInputChangeMatchesAFreshDevice, ()) {
    verifies<req::TCS_IN_009, req::TCS_IN_014, req::TCS_VAL_001, req::TCS_AVG_002, req::TCS_CJ_001, req::TCS_CJ_003,
             req::TCS_LIM_010, req::TCS_LIM_014>("property");
    const auto changes = *rc::gen::container<std::vector<std::pair<unsigned, unsigned>>>(
        6, rc::gen::pair(rc::gen::inRange(0U, 1000U), rc::gen::inRange(0U, 1000000U)));
    TcsState state;
    TcsRig running;
    start(running, state);
    for (const auto& [which, number] : changes) {
        const TcsState before = state;
        change_one(state, which, number);
        put(running.bench, state);
        running.bench.set_inputs();
        write_changes(running, before, state);
        settle(running);
        TcsRig fresh;
        start(fresh, state);
        RC_LOG() << "change " << which % 18 << " by " << number << "\n";
        RC_ASSERT(shown(running) == shown(fresh));
    }
}

}  // namespace canproof::test
