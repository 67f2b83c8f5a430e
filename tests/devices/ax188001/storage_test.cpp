// SPDX-License-Identifier: Apache-2.0
// Storing and restoring of parameters of the AX188001 (manual, 3.2.7, 3.2.8).
#include <map>

#include "generated/ax188001/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr std::uint32_t load = 0x64616F6C;

using Ax188001Storage = TcsTest;

struct Parameter {
    int index;
    int sub;
    int size;
    std::uint32_t value;
};

/// Returns a value for every writable entry. Each value differs from the default and, where the range allows it, from
/// all other values. The thresholds come in an order in which each write keeps their least distance.
std::vector<Parameter> every_parameter() {
    std::vector<Parameter> all{{0x100C, 0, 2, 101},  {0x100D, 0, 1, 3},    {0x1017, 0, 2, 60000}, {0x1029, 1, 1, 1},
                               {0x1029, 2, 1, 2},    {0x1029, 3, 1, 1},    {0x2020, 0, 1, 50},    {0x2112, 0, 1, 0},
                               {0x5041, 1, 2, 1101}, {0x5041, 2, 2, 501},  {0x5041, 3, 2, 91},    {0x5042, 1, 2, 851},
                               {0x5042, 2, 2, 481},  {0x5042, 3, 2, 121},  {0x5050, 1, 1, 0},     {0x5050, 2, 1, 0},
                               {0x5051, 1, 2, 4321}, {0x5051, 2, 2, 4322}, {0x5555, 0, 1, 0},     {0x5556, 0, 2, 2000},
                               {0x6110, 1, 2, 9},    {0x6110, 2, 2, 10},   {0x6112, 1, 1, 0},     {0x6112, 2, 1, 0}};
    std::uint32_t n = 0;
    for (int sub = 1; sub <= 4; ++sub) {
        all.push_back({0x1016, sub, 4, 0x00310064U + 0x00010001U * static_cast<std::uint32_t>(sub)});
    }
    for (int pdo = 0; pdo < 4; ++pdo) {
        for (const int base : {0x1400, 0x1800}) {
            ++n;
            all.push_back({base + pdo, 1, 4, 0xC0000300U + n});
            all.push_back({base + pdo, 3, 2, 0x1100U + n});
            all.push_back({base + pdo, 4, 1, 0x20U + n});
            all.push_back({base + pdo, 5, 2, 0x3300U + n});
        }
        all.push_back({0x1A00 + pdo, 0, 1, 0});
        const std::uint32_t mapped[]{0x61000120, 0x71300210, 0x61500108, 0x61500208};
        for (int sub = 1; sub <= 4; ++sub) {
            all.push_back({0x1A00 + pdo, sub, 4, mapped[(sub + pdo) % 4]});
        }
        all.push_back({0x1A00 + pdo, 0, 1, pdo % 2 == 0 ? 4U : 3U});
    }
    for (int sub = 1; sub <= 2; ++sub) {
        const auto part = static_cast<std::uint32_t>(sub);
        all.push_back({0x2000, sub, 1, 0});
        all.push_back({0x4020, sub, 2, 3000 + part});
        all.push_back({0x4010, sub, 2, 1300 + part});
        all.push_back({0x4000, sub, 2, 0xFF00 + part});
        all.push_back({0x4030, sub, 2, 1230 + part});
        all.push_back({0x6126, sub, 4, 0x40000000 + part});
        all.push_back({0x6127, sub, 4, 0x40100000 + part});
    }
    for (const int index : {0x2126, 0x2127, 0x3126, 0x3127}) {
        all.push_back({index, 0, 4, 0x40200000 + static_cast<std::uint32_t>(index)});
    }
    return all;
}

}  // namespace

TEST_F(Ax188001Storage, StoreAndRestoreObjects1010hAnd1011hReportTheirCapability) {
    verifies<req::TCS_STORE_001, req::TCS_OD_1010, req::TCS_OD_1011>();
    for (const int index : {0x1010, 0x1011}) {
        EXPECT_EQ(read(index, 0).value, 4U);
        for (int sub = 1; sub <= 4; ++sub) {
            EXPECT_EQ(read(index, sub).value, 1U);
        }
        EXPECT_EQ(read(index, 5).abort, no_subindex);
        EXPECT_EQ(write(index, 1, 4, 0x12345678), 0x08000020U);
    }
}

TEST_F(Ax188001Storage, EverySavedParameterIsKeptAfterPowerOn) {
    verifies<req::TCS_STORE_002, req::TCS_OD_1010, req::TCS_OD_1400, req::TCS_OD_1401, req::TCS_OD_1402,
             req::TCS_OD_1403, req::TCS_OD_1800, req::TCS_OD_1801, req::TCS_OD_1802, req::TCS_OD_1803, req::TCS_OD_1A00,
             req::TCS_OD_1A01, req::TCS_OD_1A02, req::TCS_OD_1A03>();
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);  // TPDO1 is not valid now, so its mapping can be changed
    const auto parameters = every_parameter();
    std::map<std::pair<int, int>, Parameter> last;
    for (const auto& one : parameters) {
        ASSERT_EQ(write(one.index, one.sub, one.size, one.value), 0U) << fmt::format("{:04X}:{}", one.index, one.sub);
        last[{one.index, one.sub}] = one;
    }
    const auto expect_all = [&] {
        for (const auto& [place, one] : last) {
            EXPECT_EQ(read(one.index, one.sub).value, one.value) << fmt::format("{:04X}:{}", one.index, one.sub);
            EXPECT_EQ(read(one.index, one.sub).size, one.size) << fmt::format("{:04X}:{}", one.index, one.sub);
        }
    };
    expect_all();  // each entry has its own value
    EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
    power_on();
    expect_all();
    EXPECT_EQ(write(0x1011, 1, 4, load), 0U);
    EXPECT_EQ(read(0x4030, 1).value, 1231U);
    power_on();
    EXPECT_EQ(read(0x4030, 1).value, 5000U);
}

TEST_F(Ax188001Storage, UnsavedParametersAreLostAtPowerOn) {
    verifies<req::TCS_STORE_004>();
    write(0x4030, 1, 2, 1);
    power_on();
    EXPECT_EQ(read(0x4030, 1).value, 5000U);  // the default

    write(0x4030, 1, 2, 2);
    EXPECT_EQ(write(0x1010, 1, 4, 0x65766173), 0U);
    write(0x4030, 1, 2, 3);
    write(0x4030, 2, 2, 4);
    power_on();
    EXPECT_EQ(read(0x4030, 1).value, 2U);  // the stored value
    EXPECT_EQ(read(0x4030, 2).value, 5000U);
}

TEST_F(Ax188001Storage, ParametersAreSavedAndRestoredByGroup) {
    verifies<req::TCS_STORE_005, req::TCS_STORE_003, req::TCS_STORE_006, req::TCS_OD_1010, req::TCS_OD_1011>();
    struct Group {
        int sub;
        int index;
        int element;
        std::uint32_t changed;
        std::uint32_t shipped;
    };
    const std::vector<Group> groups{{2, 0x1017, 0, 500, 0}, {3, 0x6110, 1, 2, 1}, {4, 0x4030, 1, 77, 5000}};
    for (const auto& chosen : groups) {
        for (const auto& one : groups) {
            write(one.index, one.element, 2, one.changed);
        }
        EXPECT_EQ(write(0x1010, chosen.sub, 4, save), 0U);
        power_on();
        for (const auto& one : groups) {
            EXPECT_EQ(read(one.index, one.element).value, one.sub == chosen.sub ? one.changed : one.shipped);
        }
        EXPECT_EQ(write(0x1011, chosen.sub, 4, load), 0U);
        EXPECT_EQ(read(chosen.index, chosen.element).value, chosen.changed);
        send("000#817F");
        EXPECT_EQ(read(chosen.index, chosen.element).value, chosen.shipped);
    }
}

}  // namespace canproof::test
