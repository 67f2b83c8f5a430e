// SPDX-License-Identifier: Apache-2.0
// Checks that no value that the AX060805 computes depends on an earlier value of a parameter. After a change of one
// parameter, the device must give the same values as a device that had the new value of the parameter from the start.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// One parameter with its length in bytes. `values` are values of the parameter with different effects.
struct Key {
    std::uint16_t index{0};
    std::uint8_t sub{0};
    int bytes{1};
    std::vector<std::uint32_t> values;
};

std::uint32_t bits(float value) {
    return InclinometerBench::bits_of(value);
}

/// Adds the parameters that have a sub-index for each angle, axis or received value. Then adds the parameters of
/// filters, angles and constants that have one value for the whole device.
void add_angle_keys(std::vector<Key>& keys) {
    for (std::uint8_t sub = 1; sub <= 3; ++sub) {
        keys.push_back({0x2010, sub, 2, {1000, 500, 10}});
        keys.push_back({0x2011, sub, 1, {0, 1}});
        keys.push_back({0x2020, sub, 4, {bits(0.0F), bits(100.0F)}});
        keys.push_back({0x2030, sub, 2, {1000, 500, 10}});
        keys.push_back({0x2031, sub, 1, {0, 1}});
        keys.push_back({0x2040, sub, 4, {bits(0.0F), bits(-70.0F)}});
        keys.push_back({0x2050, sub, 1, {0, 1}});
        keys.push_back({0x2051, sub, 2, {1, 2, 5}});
        keys.push_back({0x2500, sub, 2, {0, 7, 250}});
        keys.push_back({0x2501, sub, 2, {1000, 250}});
        keys.push_back({0x2502, sub, 4, {bits(0.0F), bits(1.5F)}});
    }
    keys.push_back({0x2002, 0, 1, {0, 1}});
    keys.push_back({0x2003, 0, 1, {5, 50}});
    keys.push_back({0x2052, 0, 2, {5, 10}});
    keys.push_back({0x2100, 0, 1, {0, 1}});
    keys.push_back({0x2200, 0, 4, {bits(0.0F), bits(15.0F)}});
    keys.push_back({0x2210, 0, 4, {bits(0.0F), bits(-25.0F)}});
    keys.push_back({0x4070, 0, 4, {bits(2.5F), bits(-4.0F)}});
    keys.push_back({0x4080, 0, 4, {3, 12}});
}

/// Adds the parameters of the function blocks. The source of an input is a measured, received or constant value, or a
/// function block with a lower number.
void add_function_keys(std::vector<Key>& keys) {
    for (std::uint16_t n = 0; n < 10; ++n) {
        const auto at = static_cast<std::uint16_t>(0x3010 + 0x10 * n);
        const auto plus = [at](unsigned more) { return static_cast<std::uint16_t>(at + more); };
        std::vector<std::uint32_t> sources{0, 1, 2, 3, 5, 6, 7, 8, 20, 21, 22, 23, 24};
        for (std::uint32_t before = 0; before < n; ++before) {
            sources.push_back(10 + before);
        }
        for (std::uint8_t sub = 1; sub <= 2; ++sub) {
            keys.push_back({at, sub, 1, sources});
            keys.push_back({plus(1), sub, 1, {0, 1}});
            keys.push_back({plus(2), sub, 4, {bits(5.0F), bits(-2.0F)}});
            keys.push_back({plus(3), sub, 1, {0, 1, 3}});
            keys.push_back({plus(4), sub, 4, {bits(1.0F), bits(3.0F)}});
            keys.push_back({plus(5), sub, 4, {bits(0.0F), bits(8.0F)}});
        }
        const auto of_function = static_cast<std::uint8_t>(n + 1);
        keys.push_back({0x300A, of_function, 1, {1, 2, 3, 6, 7, 10}});
        keys.push_back({0x300B, of_function, 4, {bits(1.0F), bits(-2.0F)}});
        keys.push_back({0x300C, of_function, 4, {bits(0.0F), bits(30.0F)}});
    }
}

const std::vector<Key>& all_keys() {
    static const std::vector<Key> all = [] {
        std::vector<Key> keys;
        add_angle_keys(keys);
        add_function_keys(keys);
        return keys;
    }();
    return all;
}

class Told : public InclinometerBench {
  public:
    /// Makes a device. Parameter i gets the value with number choice[i] (modulo the number of its possible values).
    explicit Told(const std::vector<std::size_t>& choice) {
        power_on();
        turn(10.0, 20.0);
        power_on();  // the first sample after this power-on already has the new position
        for (std::size_t i = 0; i < choice.size(); ++i) {
            tell(i, choice[i]);
        }
    }
    void tell(std::size_t key, std::size_t choice) {
        const Key& one = all_keys()[key];
        const std::uint32_t value = one.values[choice % one.values.size()];
        write(one.index, one.sub, value, one.bytes);
    }
    /// Returns all measured and computed values.
    std::vector<int> shown() {
        std::vector<int> values = accelerations();
        for (const int angle : angles()) {
            values.push_back(angle);
        }
        for (const std::uint16_t index : {std::uint16_t{0x4010}, std::uint16_t{0x4020}, std::uint16_t{0x4060}}) {
            values.push_back(value(index));
        }
        for (std::uint8_t sub = 1; sub <= 10; ++sub) {
            values.push_back(value(0x3000, sub));
        }
        return values;
    }
};

}  // namespace

RC_GTEST_PROP(InclinometerCacheLaw, ParameterWrittenLaterHasTheSameEffectAsOneSetFromTheStart, ()) {
    verifies<req::INC_ANGLE_017, req::INC_BIN_012, req::INC_BIN_013>("property");
    std::vector<std::size_t> choice(all_keys().size());
    for (std::size_t& one : choice) {
        one = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, 60));
    }
    const auto changed = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, choice.size()));
    Told one{choice};
    one.pass(200);
    choice[changed] += *rc::gen::element<std::size_t>(1, 2);
    one.tell(changed, choice[changed]);
    Told other{choice};
    other.pass(200);
    RC_LOG() << fmt::format("{:04X}h:{}", all_keys()[changed].index, all_keys()[changed].sub);
    for (const std::uint64_t ms : {std::uint64_t{5}, std::uint64_t{195}}) {
        one.pass(ms);
        other.pass(ms);
        RC_ASSERT(one.shown() == other.shown());
    }
    one.turn(-35.0, 50.0);
    other.turn(-35.0, 50.0);
    for (const std::uint64_t ms : {std::uint64_t{5}, std::uint64_t{5}, std::uint64_t{10}, std::uint64_t{30}}) {
        one.pass(ms);
        other.pass(ms);
        RC_ASSERT(one.shown() == other.shown());
    }
}

}  // namespace canproof::test
