// SPDX-License-Identifier: Apache-2.0
// Tests every parameter of the AX060805 at the ends of its range and just beyond them. Also tests whether it is stored
// and can be mapped (manual, chapter 4). Node 127.
#include <fmt/format.h>

#include <tuple>

#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// The values of an entry that the device accepts or refuses, as bit patterns. The first accepted value differs from
/// the default.
struct Limits {
    std::uint16_t index;
    int subs;  ///< number of sub-indices from 1 on; 0 for a variable
    int bytes;
    std::vector<std::uint32_t> taken;
    std::vector<std::uint32_t> too_low;
    std::vector<std::uint32_t> too_high;

    std::uint8_t first_sub() const { return subs == 0 ? 0 : 1; }
};

constexpr std::uint32_t infinite = 0x7F800000;
constexpr std::uint32_t no_number = 0x7FC00000;
constexpr std::uint32_t negative = 0x80000000;

Limits real(std::uint16_t index, int subs) {
    // FFFFFFFFh as a float is 2^32 (4F800000h). The values are -2^32, 0 and 2^32, and the next floats beyond each end.
    return {index, subs, 4, {0xCF800000, 0, 0x4F800000}, {0xCF800001}, {0x4F800001}};
}

// The value ranges of section 4.3, written by hand.
std::vector<Limits> manufacturer_limits() {
    std::vector<Limits> all{
        {0x2000, 0, 1, {1, 0}, {}, {2}},
        {0x2002, 0, 1, {0, 1}, {}, {2}},
        {0x2003, 0, 1, {1, 50}, {0}, {51}},
        {0x2010, 3, 2, {1000, 1}, {0}, {1001}},
        {0x2011, 3, 1, {1, 0}, {}, {2}},
        real(0x2020, 3),
        {0x2030, 3, 2, {1000, 1}, {0}, {1001}},
        {0x2031, 3, 1, {1, 0}, {}, {2}},
        real(0x2040, 3),
        {0x2050, 3, 1, {1, 2, 0}, {}, {3}},
        {0x2051, 3, 2, {1, 60000}, {0}, {60001}},
        {0x2052, 0, 2, {1, 60000}, {0}, {60001}},
        {0x2100, 0, 1, {0, 1}, {}, {2}},
        {0x2200, 0, 4, {0xC2B40000, 0x42B40000}, {0xC2B40001}, {0x42B40001}},  // -90 to 90 degrees
        {0x2210, 0, 4, {0xC3340000, 0x43340000}, {0xC3340001}, {0x43340001}},  // -180 to 180 degrees
        {0x2501, 3, 2, {10, 1000}, {0, 9}, {1001}},
        real(0x2502, 3),
        {0x300A, 10, 1, {20, 0}, {}, {21}},
        real(0x300B, 10),
        real(0x300C, 10),
        real(0x4070, 0),
        {0x4080, 0, 4, {0xFFFFFFFF, 0}, {}, {}},
        {0x5550, 0, 1, {0, 1}, {}, {}},
        {0x5555, 0, 1, {1, 0}, {}, {}},
    };
    for (int function = 1; function <= 10; ++function) {
        const auto at = [function](int parameter) {
            return static_cast<std::uint16_t>(0x3000 + 0x10 * function + parameter);
        };
        all.push_back({at(0), 2, 1, {28, 0}, {}, {29}});
        all.push_back({at(1), 2, 1, {1, 0}, {}, {2}});
        all.push_back(real(at(2), 2));
        all.push_back({at(3), 2, 1, {3, 0}, {}, {4}});
        all.push_back(real(at(4), 2));
        all.push_back(real(at(5), 2));
    }
    return all;
}

std::string name(std::uint16_t index, int sub, std::uint32_t value) {
    return fmt::format("{:04X}h:{} = {:X}h", index, sub, value);
}

class Ax060805Parameters : public InclinometerTest {
  protected:
    /// Calls visit(index, sub, limits) for each sub-index of each entry in `limits`.
    template <typename Visit>
    static void for_each(const std::vector<Limits>& limits, const Visit& visit) {
        for (const auto& one : limits) {
            for (int sub = one.first_sub(); sub <= one.subs; ++sub) {
                visit(one.index, static_cast<std::uint8_t>(sub), one);
            }
        }
    }
    void store_all() { write(0x1010, 1, 0x65766173, 4); }
};

/// Links a test to the requirements of the sixty parameter objects of the ten binary functions.
void verifies_every_function() {
    verifies<req::INC_OD_3010, req::INC_OD_3011, req::INC_OD_3012, req::INC_OD_3013, req::INC_OD_3014, req::INC_OD_3015,
             req::INC_OD_3020, req::INC_OD_3021, req::INC_OD_3022, req::INC_OD_3023, req::INC_OD_3024, req::INC_OD_3025,
             req::INC_OD_3030, req::INC_OD_3031, req::INC_OD_3032, req::INC_OD_3033, req::INC_OD_3034, req::INC_OD_3035,
             req::INC_OD_3040, req::INC_OD_3041>();
    verifies<req::INC_OD_3042, req::INC_OD_3043, req::INC_OD_3044, req::INC_OD_3045, req::INC_OD_3050, req::INC_OD_3051,
             req::INC_OD_3052, req::INC_OD_3053, req::INC_OD_3054, req::INC_OD_3055, req::INC_OD_3060, req::INC_OD_3061,
             req::INC_OD_3062, req::INC_OD_3063, req::INC_OD_3064, req::INC_OD_3065, req::INC_OD_3070, req::INC_OD_3071,
             req::INC_OD_3072, req::INC_OD_3073>();
    verifies<req::INC_OD_3074, req::INC_OD_3075, req::INC_OD_3080, req::INC_OD_3081, req::INC_OD_3082, req::INC_OD_3083,
             req::INC_OD_3084, req::INC_OD_3085, req::INC_OD_3090, req::INC_OD_3091, req::INC_OD_3092, req::INC_OD_3093,
             req::INC_OD_3094, req::INC_OD_3095, req::INC_OD_30A0, req::INC_OD_30A1, req::INC_OD_30A2, req::INC_OD_30A3,
             req::INC_OD_30A4, req::INC_OD_30A5>();
}

/// A communication parameter and a value for it that is not its default.
struct Setting {
    std::uint16_t index;
    std::uint8_t sub;
    std::uint32_t value;
    int bytes;
};

std::vector<Setting> communication_settings() {
    std::vector<Setting> all{{0x100C, 0, 300, 2},   {0x100D, 0, 3, 1}, {0x1016, 1, 0x00110064, 4},
                             {0x1017, 0, 60000, 2}, {0x1029, 1, 1, 1}, {0x1029, 2, 2, 1}};
    for (std::uint16_t pdo = 0; pdo < 4; ++pdo) {
        for (const auto& [communication, mapping, mapped] :
             {std::tuple{0x1400, 0x1600, 0x25000210U}, std::tuple{0x1800, 0x1A00, 0x40500010U}}) {
            const auto parameters = static_cast<std::uint16_t>(communication + pdo);
            const auto entries = static_cast<std::uint16_t>(mapping + pdo);
            all.push_back({parameters, 1, 0xC0000111U + 0x120U + pdo, 4});
            all.push_back({parameters, 3, 50U + pdo, 2});
            all.push_back({parameters, 4, 7U + pdo, 1});
            all.push_back({parameters, 5, 70U + pdo, 2});
            all.push_back({entries, 0, 0, 1});
            for (std::uint8_t sub = 1; sub <= 4; ++sub) {
                all.push_back({entries, sub, mapped, 4});
            }
            all.push_back({entries, 0, 4, 1});
        }
    }
    return all;
}

}  // namespace

TEST_F(Ax060805Parameters, EveryManufacturerParameterAcceptsItsRangeAndRefusesValuesBeyond) {
    verifies<req::INC_OD_2000, req::INC_OD_2002, req::INC_OD_2003, req::INC_OD_2010, req::INC_OD_2011, req::INC_OD_2020,
             req::INC_OD_2030, req::INC_OD_2031, req::INC_OD_2040, req::INC_OD_2050, req::INC_OD_2051, req::INC_OD_2052,
             req::INC_OD_2100, req::INC_OD_2200, req::INC_OD_2210, req::INC_OD_2501, req::INC_OD_2502>();
    verifies<req::INC_OD_300A, req::INC_OD_300B, req::INC_OD_300C, req::INC_OD_4070, req::INC_OD_4080, req::INC_OD_5550,
             req::INC_OD_5555, req::INC_T1, req::INC_T4, req::INC_T9, req::INC_T10>();
    verifies_every_function();
    EXPECT_EQ(refusal(0x5550, 0, 2, 1), "06090030");
    EXPECT_EQ(refusal(0x5555, 0, 2, 1), "06090030");
    for_each(manufacturer_limits(), [this](std::uint16_t index, std::uint8_t sub, const Limits& limits) {
        const std::uint32_t before = read(index, sub);
        for (const std::uint32_t value : limits.too_low) {
            EXPECT_EQ(refusal(index, sub, value, limits.bytes), "06090032") << name(index, sub, value);
        }
        for (const std::uint32_t value : limits.too_high) {
            EXPECT_EQ(refusal(index, sub, value, limits.bytes), "06090031") << name(index, sub, value);
        }
        EXPECT_EQ(read(index, sub), before);
        for (const std::uint32_t value : limits.taken) {
            EXPECT_EQ(refusal(index, sub, value, limits.bytes), "") << name(index, sub, value);
            EXPECT_EQ(read(index, sub), value);
        }
        write(index, sub, before, limits.bytes);
    });
}

TEST_F(Ax060805Parameters, Real32ParametersRefuseInfinityAndNan) {
    verifies<req::INC_OD_2020, req::INC_OD_2040, req::INC_OD_2200, req::INC_OD_2210, req::INC_OD_2502, req::INC_OD_300B,
             req::INC_OD_300C, req::INC_OD_4070>();
    for_each(manufacturer_limits(), [this](std::uint16_t index, std::uint8_t sub, const Limits& limits) {
        if (limits.bytes == 4 && index != 0x4080) {
            for (const std::uint32_t value : {infinite, infinite | negative, no_number, no_number | negative}) {
                EXPECT_NE(refusal(index, sub, value, 4), "") << name(index, sub, value);
            }
        }
    });
}

TEST_F(Ax060805Parameters, EveryManufacturerParameterIsStored) {
    verifies<req::INC_STORE_002, req::INC_OD_1010, req::INC_OD_2000, req::INC_OD_2002, req::INC_OD_2003,
             req::INC_OD_2010, req::INC_OD_2011, req::INC_OD_2020, req::INC_OD_2030, req::INC_OD_2031, req::INC_OD_2040,
             req::INC_OD_2050, req::INC_OD_2051, req::INC_OD_2052, req::INC_OD_2100, req::INC_OD_2200>();
    verifies<req::INC_OD_2210, req::INC_OD_2501, req::INC_OD_2502, req::INC_OD_300A, req::INC_OD_300B, req::INC_OD_300C,
             req::INC_OD_4070, req::INC_OD_4080, req::INC_OD_5550, req::INC_OD_5555>();
    verifies_every_function();
    for_each(manufacturer_limits(), [this](std::uint16_t index, std::uint8_t sub, const Limits& limits) {
        write(index, sub, limits.taken[0], limits.bytes);
    });
    store_all();
    power_on();
    pass(1);  // 5555h (Start in Operational Mode) was stored as 1: the node starts itself and sends its first TPDO
    for_each(manufacturer_limits(), [this](std::uint16_t index, std::uint8_t sub, const Limits& limits) {
        EXPECT_EQ(read(index, sub), limits.taken[0]) << name(index, sub, limits.taken[0]);
    });
    write(0x1011, 1, 0x64616F6C, 4);
    power_on();
    for_each(manufacturer_limits(), [this](std::uint16_t index, std::uint8_t sub, const Limits& limits) {
        EXPECT_NE(read(index, sub), limits.taken[0]) << name(index, sub, limits.taken[0]);
    });
}

TEST_F(Ax060805Parameters, EveryCommunicationParameterIsStored) {
    verifies<req::INC_STORE_002, req::INC_OD_100C, req::INC_OD_100D, req::INC_OD_1016, req::INC_OD_1017,
             req::INC_OD_1029, req::INC_OD_1400, req::INC_OD_1401, req::INC_OD_1402, req::INC_OD_1403, req::INC_OD_1600,
             req::INC_OD_1601, req::INC_OD_1602, req::INC_OD_1603>();
    verifies<req::INC_OD_1800, req::INC_OD_1801, req::INC_OD_1802, req::INC_OD_1803, req::INC_OD_1A00, req::INC_OD_1A01,
             req::INC_OD_1A02, req::INC_OD_1A03>();
    for (const auto& setting : communication_settings()) {
        write(setting.index, setting.sub, setting.value, setting.bytes);
    }
    store_all();
    power_on();
    for (const auto& setting : communication_settings()) {
        const bool passing = setting.sub == 0 && setting.value == 0;  // 0 was written here only as a step of the
                                                                      // remapping
        if (!passing) {
            EXPECT_EQ(read(setting.index, setting.sub), setting.value)
                << name(setting.index, setting.sub, setting.value);
        }
    }
}

TEST_F(Ax060805Parameters, CommandsAndProcessValuesAreNotStored) {
    verifies<req::INC_STORE_003, req::INC_STORE_002, req::INC_OD_2300, req::INC_OD_2500, req::INC_OD_1003,
             req::INC_OD_1010, req::INC_OD_1011>();
    for (std::uint8_t sub = 1; sub <= 3; ++sub) {
        EXPECT_EQ(refusal(0x2500, sub, 0x8000, 2), "");
        EXPECT_EQ(refusal(0x2500, sub, 0x7FFF, 2), "");
    }
    inputs.accelerometer_fault = true;
    set_inputs();
    pass(5);
    EXPECT_EQ(read(0x1003), 1U);
    store_all();
    inputs.accelerometer_fault = false;
    power_on();
    for (std::uint8_t sub = 1; sub <= 3; ++sub) {
        EXPECT_EQ(read(0x2500, sub), 0U);
        EXPECT_EQ(read(0x1010, sub), 1U);
        EXPECT_EQ(read(0x1011, sub), 1U);
    }
    EXPECT_EQ(read(0x1003), 0U);
    EXPECT_EQ(read(0x1003, 1), 0U);
    EXPECT_EQ(read(0x2300), 0U);
}

TEST_F(Ax060805Parameters, ExactlyTheEntriesThatTheManualNamesAreMappable) {
    verifies<req::INC_PDO_007, req::INC_PDO_008, req::INC_OD_2500, req::INC_OD_3000, req::INC_OD_4000>();
    // the mappable entries of each object: index, first and last sub-index, number of bits
    struct Mappable {
        std::uint16_t index;
        int from, to, bits;
        bool received;
    };
    const std::vector<Mappable> mappable{
        {0x2500, 1, 3, 16, true},  {0x3000, 1, 10, 16, false}, {0x4000, 1, 3, 16, false}, {0x4010, 0, 0, 16, false},
        {0x4020, 0, 0, 8, false},  {0x4030, 0, 0, 16, false},  {0x4040, 0, 0, 16, false}, {0x4050, 0, 0, 16, false},
        {0x4060, 0, 0, 16, false}, {0x4070, 0, 0, 32, false},  {0x4080, 0, 0, 32, false}, {0x5020, 0, 0, 32, false},
        {0x5030, 0, 0, 32, false}};
    const auto is_mappable = [&](std::uint32_t index, std::uint32_t sub, std::uint32_t bits, bool received) {
        for (const auto& one : mappable) {
            const bool inside = static_cast<int>(sub) >= one.from && static_cast<int>(sub) <= one.to;
            if (one.index == index && inside && one.bits == static_cast<int>(bits) && one.received == received) {
                return true;
            }
        }
        return false;
    };
    for (std::uint32_t index = 0x1000; index <= 0x5555; ++index) {
        const std::string probe = send("67F#40" + hex_le(index, 2) + "0000000000").at(0);
        if (probe.substr(12) == "00000206") {
            continue;
        }
        for (std::uint32_t sub = 0; sub <= 10; ++sub) {
            for (const std::uint32_t bits : {8U, 16U, 32U}) {
                const std::uint32_t entry = (index << 16U) | (sub << 8U) | bits;
                EXPECT_EQ(refusal(0x1601, 1, entry, 4) == "", is_mappable(index, sub, bits, true)) << std::hex << entry;
                EXPECT_EQ(refusal(0x1A03, 1, entry, 4) == "", is_mappable(index, sub, bits, false))
                    << std::hex << entry;
            }
        }
    }
    // Dummy entries: 0001h (BOOLEAN) to 0007h (UNSIGNED32), CiA 301; 0008h would be REAL32.
    const std::vector<std::uint32_t> dummies{0x00010001, 0x00020008, 0x00030010, 0x00040020,
                                             0x00050008, 0x00060010, 0x00070020};
    for (const std::uint32_t entry : dummies) {
        EXPECT_EQ(refusal(0x1601, 1, entry, 4), "") << std::hex << entry;
        EXPECT_NE(refusal(0x1A03, 1, entry, 4), "") << std::hex << entry;
    }
    EXPECT_NE(refusal(0x1601, 1, 0x00080020, 4), "");
}

}  // namespace canproof::test
