// SPDX-License-Identifier: Apache-2.0
// Generates actions for an AX188001 from arbitrary numbers, and a configuration in which most parameters of the two
// channels differ.
#pragma once

#include "properties/devices/ax188001/tcs_scenario.hpp"

namespace canproof::test {

/// The settings of the channels and of the whole unit before the first action.
struct TcsSetup {
    std::array<unsigned, 2> type{1, 2};
    std::array<int, 2> low_c{-40, -20};
    std::array<int, 2> high_c{80, 120};
    std::array<int, 2> shutdown_c{140, 200};
    std::array<unsigned, 2> delay_ms{400, 700};
    std::array<float, 2> factor{16.0F, 18.0F};
    std::array<float, 2> offset{4368.0F, 320.0F};
    std::array<unsigned, 2> fd_delay_ms{300, 500};
    std::array<unsigned, 4> event_ms{450, 1000, 330, 275};
    std::array<unsigned, 3> reaction{0, 1, 0};
    unsigned start{0};
    unsigned start_delay_ms{1000};
    bool is_stored{false};
};

constexpr std::array<unsigned, 8> tcs_types{1, 2, 4, 5, 6, 7, 9, 10};

inline TcsSetup setup_of(const std::vector<unsigned>& numbers) {
    std::size_t at = 0;
    const auto next = [&](unsigned count) { return at < numbers.size() ? numbers[at++] % count : 0U; };
    TcsSetup setup;
    for (std::size_t i = 0; i < 2; ++i) {
        setup.type[i] = tcs_types[next(8)];
        setup.low_c[i] = -20 - static_cast<int>(next(30)) + 41 * static_cast<int>(i);
        setup.high_c[i] = 70 + static_cast<int>(next(60)) + 73 * static_cast<int>(i);
        setup.shutdown_c[i] = setup.high_c[i] + 10 + static_cast<int>(next(50));
        setup.delay_ms[i] = next(3) == 0 ? 165 * next(4) : next(900) + 3 * static_cast<unsigned>(i);
        setup.factor[i] = static_cast<float>(next(40)) - 12.5F + static_cast<float>(i) * 0.25F;
        setup.offset[i] = static_cast<float>(next(9000)) - 4000.0F + static_cast<float>(i);
        setup.fd_delay_ms[i] = 100 + next(600);
    }
    setup.type[1] = setup.type[1] == setup.type[0] ? tcs_types[(next(7) + 1 + setup.type[0]) % 8] : setup.type[1];
    for (unsigned& one : setup.event_ms) {
        one = next(5) == 0 ? 0 : 50 + next(1200);
    }
    for (unsigned& one : setup.reaction) {
        one = next(3);
    }
    setup.start = next(3);
    setup.start_delay_ms = next(3) == 0 ? 0 : next(900);
    setup.is_stored = next(2) == 0;
    return setup;
}

inline std::uint32_t tenths(int celsius) {
    return static_cast<std::uint32_t>(celsius * 10) & 0xFFFFU;
}

/// Returns the writes that give a device with default parameters the settings of `setup`, in an order in which each
/// write is accepted.
inline std::vector<TcsAction> writes_of(const TcsSetup& setup) {
    std::vector<TcsAction> all;
    for (int sub = 1; sub <= 2; ++sub) {
        const auto i = static_cast<std::size_t>(sub - 1);
        all.push_back(written(0x6110, sub, 2, setup.type[i]));
        all.push_back(written(0x4000, sub, 2, tenths(-273)));
        all.push_back(written(0x4020, sub, 2, tenths(1735)));
        all.push_back(written(0x4010, sub, 2, tenths(setup.high_c[i])));
        all.push_back(written(0x4000, sub, 2, tenths(setup.low_c[i])));
        all.push_back(written(0x4020, sub, 2, tenths(setup.shutdown_c[i])));
        all.push_back(written(0x4030, sub, 2, setup.delay_ms[i]));
        all.push_back(written_real(0x6126, sub, setup.factor[i]));
        all.push_back(written_real(0x6127, sub, setup.offset[i]));
        all.push_back(written(0x5051, sub, 2, setup.fd_delay_ms[i]));
    }
    return all;
}

/// Returns the writes that remap all four TPDOs by the steps of the manual (3.2.15) and set 1029h (error behaviour).
inline std::vector<TcsAction> communication_of(const TcsSetup& setup) {
    const std::array<std::vector<std::uint32_t>, 4> mapped{{{0x71300110, 0x71300210},
                                                            {0x21300010, 0x31300010},
                                                            {0x61000120, 0x61000220},
                                                            {0x61500108, 0x61500208, 0x50400120}}};
    std::vector<TcsAction> all;
    for (int i = 0; i < 4; ++i) {
        const auto& entries = mapped[static_cast<std::size_t>(i)];
        const std::uint32_t id = 0x40000000U + 0x180U + 0x100U * static_cast<unsigned>(i) + 127U;
        all.push_back(written(0x1800 + i, 1, 4, id | 0x80000000U));
        all.push_back(written(0x1A00 + i, 0, 1, 0));
        int sub = 0;
        for (const std::uint32_t entry : entries) {
            all.push_back(written(0x1A00 + i, ++sub, 4, entry));
        }
        all.push_back(written(0x1A00 + i, 0, 1, static_cast<std::uint32_t>(entries.size())));
        all.push_back(written(0x1800 + i, 5, 2, setup.event_ms[static_cast<std::size_t>(i)]));
        all.push_back(written(0x1800 + i, 1, 4, id));
    }
    for (int sub = 1; sub <= 3; ++sub) {
        all.push_back(written(0x1029, sub, 1, setup.reaction[static_cast<std::size_t>(sub - 1)]));
    }
    return all;
}

/// Returns the writes of 5555h (Start in Operational Mode) and 5556h (Start in Operational NMT Delay), which act at the
/// next boot-up. Then either stores all parameters by 1010h and resets the node, or starts the node by NMT.
inline std::vector<TcsAction> start_of(const TcsSetup& setup) {
    std::vector<TcsAction> all{written(0x5555, 0, 1, setup.start), written(0x5556, 0, 2, setup.start_delay_ms)};
    if (setup.is_stored) {
        all.push_back(written(0x1010, 1, 4, 0x65766173));
    }
    TcsAction command;
    command.kind = TcsAction::command;
    command.value = setup.is_stored ? 0x81 : 0x01;
    all.push_back(command);
    return all;
}

/// Returns a pause in ms: none, about the period of the readings (165 ms), or about the delay of a fault.
inline std::uint64_t wait_of(const TcsSetup& setup, unsigned number) {
    const unsigned rest = number / 8;
    const unsigned delay = rest % 2 == 0 ? setup.delay_ms[rest / 2 % 2] : setup.fd_delay_ms[rest / 2 % 2];
    switch (number % 8) {
        case 0:
            return 0;
        case 1:
            return 1 + rest % 164;
        case 2:
            return 165 * (1 + rest % 6);
        case 3:
            return 164 + rest % 3;
        case 4:
            return delay;
        case 5:
            return delay + 1;
        case 6:
            return delay == 0 ? 0 : delay - 1;
        default:
            return rest % 1200;
    }
}

/// Returns a temperature near a limit of the channel or an end of the range of its type.
inline double celsius_near(const TcsSetup& setup, std::size_t i, unsigned number) {
    const double aside = static_cast<double>(number / 8 % 41) / 10.0 - 2.05;
    switch (number % 8) {
        case 0:
            return setup.low_c[i] + aside;
        case 1:
            return setup.high_c[i] + aside;
        case 2:
            return setup.shutdown_c[i] + aside;
        case 3:
            return setup.low_c[i] + 30 + aside;
        case 4:
            return 25 + aside;
        case 5:
            return naive_tcs::sensor(setup.type[i]).lowest_c;
        case 6:
            return static_cast<double>(naive_tcs::sensor(setup.type[i]).curve->highest());
        default:
            return static_cast<double>(number % 1200);
    }
}

/// Returns a write of one parameter of a channel or of the unit.
inline TcsAction write_of(const TcsSetup& setup, unsigned which, unsigned number) {
    const int sub = 1 + static_cast<int>(number % 2);
    const auto i = static_cast<std::size_t>(sub - 1);
    const unsigned rest = number / 2;
    const int near = static_cast<int>(rest % 5) - 2;
    switch (which % 24) {
        case 0:
        case 1:
            return written(0x6112, sub, 1, rest % 5 == 0 ? 2 : rest % 2);
        case 2:
            return written(0x6110, sub, 2, rest % 12);
        case 3:
            return written(0x2000, sub, 1, rest % 2);
        case 4:
            return written(0x4000, sub, 2, tenths(setup.low_c[i] + near * 3));
        case 5:
            return written(0x4010, sub, 2, (tenths(setup.high_c[i]) + static_cast<std::uint32_t>(near)) & 0xFFFFU);
        case 6:
            return written(0x4020, sub, 2, tenths(setup.high_c[i] + 10) + rest % 3 - 1U);
        case 7:
        case 8:
            return written(0x4030, sub, 2, rest % 3 == 0 ? 60000 + rest / 3 % 2 : rest % 1000);
        case 9:
            return written_real(0x6126, sub, static_cast<float>(rest % 2100) - 1050.0F);
        case 10:
            return written_real(0x6127, sub, static_cast<float>(rest % 21000) - 10500.0F);
        case 11:
            return written(0x2020, 0, 1, rest % 3 == 0 ? 50 : 60);
        case 12:
            return written(0x2112, 0, 1, rest % 3);
        case 13:
            return written_real(0x2126, 0, static_cast<float>(rest % 60) - 30.0F);
        case 14:
            return written_real(0x2127, 0, static_cast<float>(rest % 8000) - 4000.0F);
        case 15:
            return written_real(rest % 2 == 0 ? 0x3126 : 0x3127, 0, static_cast<float>(rest % 60) - 30.0F);
        case 16:
            return written(0x5041, 1 + static_cast<int>(rest % 3), 2, 80 + number % 1200);
        case 17:
            return written(0x5042, 1 + static_cast<int>(rest % 3), 2, 80 + number % 1100);
        case 18:
            return written(0x5050, sub, 1, rest % 2);
        case 19:
            return written(0x5051, sub, 2, rest % 3 == 0 ? 10000 + rest / 3 % 2 : rest % 1000);
        case 20:
            return written(0x5555, 0, 1, rest % 4);
        case 21:
            return written(0x5556, 0, 2, rest % 800);
        case 22:
            return written(0x1029, 1 + static_cast<int>(rest % 3), 1, rest / 3 % 4);
        default:
            return written(0x1800 + static_cast<int>(rest % 4), 5, 2, rest / 4 % 3 == 0 ? 0 : 40 + rest % 900);
    }
}

inline TcsAction input_of(const TcsSetup& setup, const std::array<unsigned, 4>& numbers) {
    TcsAction action;
    action.channel = 1 + static_cast<int>(numbers[1] % 2);
    const unsigned number = numbers[1] / 2;
    switch (numbers[2] % 8) {
        case 0:
            action.kind = TcsAction::wire;
            action.value = number % 2;
            break;
        case 1:
            action.kind = TcsAction::voltage;
            action.value = static_cast<double>(number % 170000) - 85000.0;
            break;
        case 2:
            action.kind = TcsAction::cold_junction;
            action.value = static_cast<double>(number % 1600) / 10.0 - 45.0;
            break;
        case 3:
            action.kind = TcsAction::cpu;
            action.value = 80.0 + static_cast<double>(number % 350) / 10.0;
            break;
        case 4:
            action.kind = TcsAction::supply;
            action.value = number % 2 == 0 ? 8.5 + number % 40 / 10.0 : 47.0 + number % 40 / 10.0;
            break;
        case 5:
            action.kind = TcsAction::hum;
            action.sub = static_cast<int>(number % 2);
            action.value = number % 3000;
            break;
        default:
            action.kind = TcsAction::heat;
            action.value = celsius_near(setup, numbers[1] % 2, number);
            break;
    }
    return action;
}

inline TcsAction action_of(const TcsSetup& setup, const std::array<unsigned, 4>& numbers) {
    TcsAction action;
    switch (numbers[0] % 12) {
        case 0:
        case 1:
        case 2:
            action = write_of(setup, numbers[2], numbers[1]);
            break;
        case 3: {
            static constexpr std::array<int, 10> commands{0x01, 0x01, 0x01, 0x80, 0x02, 0x81, 0x81, 0x82, 0x82, 0x05};
            action.kind = TcsAction::command;
            action.value = commands[numbers[1] % 10];
            action.sub = numbers[2] % 5 == 0 ? 5 : static_cast<int>(numbers[2] % 2) * 127;
            break;
        }
        case 4: {
            const bool clears = numbers[1] % 3 == 0;
            action = clears ? written(0x1003, 0, 1, 0) : written(0x1010, 1, 4, 0x65766173);
            if (numbers[1] % 6 == 1) {
                action = written(0x1011, 1, 4, 0x64616F6C);
            }
            action.kind = numbers[1] % 6 == 5 ? TcsAction::power_cycle : action.kind;
            break;
        }
        case 5:
            action.kind = numbers[1] % 4 < 2 ? TcsAction::overrun : TcsAction::can;
            action.value = numbers[1] % 4 < 2 ? numbers[1] % 2 : std::max(2U, numbers[2] % 4);
            break;
        default:
            action = input_of(setup, numbers);
            break;
    }
    action.wait_ms = wait_of(setup, numbers[3]);
    return action;
}

}  // namespace canproof::test
