// Start, storing, LSS and PDOs (AX188001, 1.4, 3.1, 3.2.7, 3.2.8, 3.2.14, 3.2.15, 3.4.22, 3.4.23).
#include <map>

#include "generated/ax188001/requirements.hpp"
#include "tests/devices/ax188001/tcs_bench.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr std::uint32_t save = 0x65766173;
constexpr std::uint32_t load = 0x64616F6C;

class Ax188001Startup : public TcsTest {
  protected:
    void start_with(std::uint32_t option) {
        EXPECT_EQ(write(0x5555, 0, 1, option), 0U);
        EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
    }
};
using Storage = TcsTest;
using Pdos = TcsTest;

class LssSession : public TcsTest {
  protected:
    void talk(const std::vector<Exchange>& table) { test::talk(static_cast<TcsBench&>(*this), table); }
};

}  // namespace

TEST_F(Ax188001Startup, WaitsForTheMasterAsShipped) {
    verifies<req::TCS_START_001, req::TCS_OD_5555, req::TCS_T3>();
    EXPECT_EQ(read(0x5555).value, 0U);
    EXPECT_EQ(read(0x5555).size, 1);
    EXPECT_EQ(pass(10000), Frames{});
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(write(0x5555, 0, 1, 3), too_high);
}

TEST_F(Ax188001Startup, OperationalAtOnce) {
    verifies<req::TCS_START_002, req::TCS_T3>();
    start_with(1);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(power_on(), (Frames{"77F#00", "1FF#A012A012"}));
    EXPECT_EQ(device->state(), NmtState::operational);
    const Frames frames = pass(5000);
    EXPECT_EQ(frames.size(), 5U);  // TPDO1 each second, no NMT command
    for (const char* reset : {"000#827F", "000#817F"}) {
        send("000#807F");
        EXPECT_EQ(device->state(), NmtState::pre_operational);
        send(reset);
        EXPECT_EQ(device->state(), NmtState::operational) << reset;
    }
}

TEST_F(Ax188001Startup, StartsTheOthersAfterTheDelay) {
    verifies<req::TCS_START_003, req::TCS_T3, req::TCS_OD_5556>();
    EXPECT_EQ(read(0x5556).value, 1000U);
    EXPECT_EQ(write(0x5556, 0, 2, 1500), 0U);
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    start_with(2);
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    EXPECT_EQ(device->state(), NmtState::operational);
    EXPECT_EQ(pass(60000), (Frames{"1500:000#0100"}));
}

TEST_F(Ax188001Startup, AMasterCancelsTheCommand) {
    verifies<req::TCS_START_003>();
    start_with(2);
    power_on();
    pass(500);
    send("000#807F");
    EXPECT_EQ(pass(5000), Frames{});
    power_on();
    pass(500);
    send("000#0200");
    EXPECT_EQ(pass(5000), Frames{});
    power_on();
    pass(500);
    send("000#0205");  // for another node: there is a master all the same
    EXPECT_EQ(device->state(), NmtState::operational);
    EXPECT_EQ(pass(5000), (Frames{"500:1FF#A012A012", "1500:1FF#A012A012", "2500:1FF#A012A012", "3500:1FF#A012A012",
                                  "4500:1FF#A012A012"}));
    for (const char* other : {"000#FF00", "201#0205"}) {  // no command, and a frame that only looks like one
        power_on();
        pass(500);
        send(other);
        const Frames frames = pass(600);
        EXPECT_NE(std::find(frames.begin(), frames.end(), "500:000#0100"), frames.end()) << other;
    }
}

TEST_F(Ax188001Startup, AFaultHoldsTheNodeAndItsCommandBack) {
    verifies<req::TCS_START_005>();
    write(0x5051, 1, 2, 0);
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    start_with(2);
    inputs.cpu_temperature = 120.0F;
    EXPECT_EQ(power_on(), (Frames{"77F#00", "0FF#0042010110000000"}));
    EXPECT_EQ(device->state(), NmtState::pre_operational);  // 1029h:3 is 0
    EXPECT_EQ(pass(5000), Frames{});
    EXPECT_EQ(send("000#827F"), (Frames{"77F#00"}));
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(pass(5000), Frames{});
    EXPECT_EQ(write(0x1029, 3, 1, 1), 0U);
    EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
    send("000#827F");
    EXPECT_EQ(device->state(), NmtState::operational);
    EXPECT_EQ(pass(5000), (Frames{"1000:000#0100"}));
}

TEST_F(Ax188001Startup, AFaultOfAChannelHoldsTheNodeBackToo) {
    verifies<req::TCS_START_005>();
    for (const int channel : {1, 2}) {
        write(0x4030, channel, 2, 0);
    }
    EXPECT_EQ(write(0x1029, 2, 1, 0), 0U);
    start_with(1);
    for (const int channel : {1, 2}) {
        inputs = {};
        heat(channel, 130.0);
        EXPECT_EQ(power_on(), (Frames{"77F#00", channel == 1 ? "0FF#11F0010110000000" : "0FF#11F0010210000000"}));
        EXPECT_EQ(device->state(), NmtState::pre_operational);
        EXPECT_EQ(send("000#827F"), (Frames{"77F#00"}));
        EXPECT_EQ(device->state(), NmtState::pre_operational);
    }
}

TEST_F(Ax188001Startup, DelayOfTheCommand) {
    verifies<req::TCS_START_004, req::TCS_OD_5556>();
    EXPECT_EQ(write(0x5556, 0, 2, 65001), too_high);
    EXPECT_EQ(write(0x5556, 0, 2, 65000), 0U);
    EXPECT_EQ(write(0x5556, 0, 2, 0), 0U);
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    start_with(2);
    const Frames frames = power_on();
    EXPECT_EQ(frames, (Frames{"77F#00", "000#0100"}));
}

TEST_F(Storage, TellsWhatItCanDo) {
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

namespace {

struct Parameter {
    int index;
    int sub;
    int size;
    std::uint32_t value;
};

/// A value other than the default for every writable entry, no two alike where the range allows it. Thresholds come in
/// an order in which each write keeps its distance to the others.
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

TEST_F(Storage, KeepsEveryParameterWhenSaved) {
    verifies<req::TCS_STORE_002, req::TCS_OD_1010, req::TCS_OD_1400, req::TCS_OD_1401, req::TCS_OD_1402,
             req::TCS_OD_1403, req::TCS_OD_1800, req::TCS_OD_1801, req::TCS_OD_1802, req::TCS_OD_1803, req::TCS_OD_1A00,
             req::TCS_OD_1A01, req::TCS_OD_1A02, req::TCS_OD_1A03>();
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);  // not valid: its mapping can be changed
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
    expect_all();  // each entry has a place of its own
    EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
    power_on();
    expect_all();
    EXPECT_EQ(write(0x1011, 1, 4, load), 0U);
    EXPECT_EQ(read(0x4030, 1).value, 1231U);
    power_on();
    EXPECT_EQ(read(0x4030, 1).value, 5000U);
}

TEST_F(Storage, LosesWhatWasNotSaved) {
    verifies<req::TCS_STORE_002>();
    write(0x4030, 1, 2, 1);
    power_on();
    EXPECT_EQ(read(0x4030, 1).value, 5000U);
}

TEST_F(Storage, SavesAndRestoresByGroup) {
    verifies<req::TCS_STORE_002, req::TCS_STORE_003, req::TCS_OD_1010, req::TCS_OD_1011>();
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

TEST_F(LssSession, ShippedAsNode127At125Kilobits) {
    verifies<req::TCS_LSS_001, req::TCS_K_NODE_ID, req::TCS_K_BIT_RATE>();
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    EXPECT_EQ(device->bit_rate(), 125000U);
    EXPECT_EQ(device->node_id(), 127);
}

TEST_F(LssSession, SetsTheNodeIdAsIn3_1_1_1) {
    verifies<req::TCS_LSS_002, req::TCS_LSS_005>();
    talk({{"7E5#0401", {}}, {"7E5#1150", {"7E4#110000"}}, {"7E5#17", {"7E4#170000"}}, {"7E5#0400", {"750#00"}}});
    node = 80;
    EXPECT_EQ(read(0x1800, 1).value, 0x40000180U + 80U);
    EXPECT_EQ(read(0x1801, 1).value, 0xC0000280U + 80U);
    EXPECT_EQ(read(0x1403, 1).value, 0xC0000500U + 80U);
    EXPECT_EQ(power_on(), (Frames{"750#00"}));
    write(0x4030, 1, 2, 0);
    heat(1, 130.0);
    EXPECT_EQ(read_once(), (Frames{"165:0D0#11F0010110000000"}));
}

TEST_F(LssSession, StoredCobIdsFollowUnlessTheyWereChosen) {
    verifies<req::TCS_LSS_005>();
    EXPECT_EQ(write(0x1801, 1, 4, 0xC0000333), 0U);
    EXPECT_EQ(write(0x1010, 1, 4, save), 0U);
    talk({{"7E5#0401", {}}, {"7E5#1120", {"7E4#110000"}}, {"7E5#17", {"7E4#170000"}}, {"7E5#0400", {"720#00"}}});
    node = 0x20;
    for (int round = 0; round < 2; ++round) {
        EXPECT_EQ(read(0x1800, 1).value, 0x400001A0U);
        EXPECT_EQ(read(0x1801, 1).value, 0xC0000333U);
        EXPECT_EQ(read(0x1402, 1).value, 0xC0000420U);
        power_on();
    }
}

TEST_F(LssSession, ChangesTheBitRateAsInTheCapture) {
    verifies<req::TCS_LSS_003, req::TCS_LSS_004, req::TCS_T4>();
    // Frames 95 to 102 on node 80: the capture begins with the node-ID already set.
    talk({{"7E5#0401", {}}, {"7E5#1150", {"7E4#110000"}}, {"7E5#17", {"7E4#170000"}}, {"7E5#0400", {"750#00"}}});
    node = 80;
    talk({{"7E5#0401", {}}, {"7E5#130003", {"7E4#130000"}}, {"7E5#158813", {}}});  // 1388h = 5000 ms
    pass(4999);
    EXPECT_EQ(device->bit_rate(), 125000U);
    pass(1);
    EXPECT_EQ(device->bit_rate(), 250000U);
    EXPECT_EQ(send("7E5#17"), Frames{});  // silent for a second delay
    pass(5000);
    talk({{"7E5#17", {"7E4#170000"}}, {"7E5#0400", {"750#00"}}});
    power_on();
    EXPECT_EQ(device->bit_rate(), 250000U);
}

TEST_F(LssSession, BitRatesOfTable4) {
    verifies<req::TCS_LSS_003, req::TCS_T4>();
    const std::vector<std::uint32_t> rates{1000000, 800000, 500000, 250000, 125000, 0, 50000, 20000, 10000};
    for (std::size_t index = 0; index < 12; ++index) {
        send("7E5#0401");
        const bool offered = index < rates.size() && rates[index] != 0;
        EXPECT_EQ(send(fmt::format("7E5#1300{:02X}", index)), (Frames{offered ? "7E4#130000" : "7E4#130100"})) << index;
        send("7E5#150100");
        pass(2);
        if (offered) {
            EXPECT_EQ(device->bit_rate(), rates[index]);
        }
        send("7E5#0400");
    }
}

TEST_F(LssSession, WithoutANodeIdItMeasuresAndStaysSilent) {
    verifies<req::TCS_LSS_002>();
    talk({{"7E5#0401", {}}, {"7E5#11FF", {"7E4#110000"}}, {"7E5#17", {"7E4#170000"}}});
    write(0x4030, 1, 2, 0);
    EXPECT_EQ(power_on(), Frames{});
    heat(1, 130.0);
    EXPECT_EQ(pass(20000), Frames{});
    talk({{"7E5#0401", {}}, {"7E5#1105", {"7E4#110000"}}});
    // The fault that lasted is told once there is a node-ID to tell it with.
    EXPECT_EQ(send("7E5#0400"), (Frames{"705#00", "085#11F0010110000000"}));
}

TEST_F(LssSession, AFaultThatCameAndWentWithoutANodeIdIsNotTold) {
    verifies<req::TCS_LSS_002, req::TCS_ERR_002>();
    talk({{"7E5#0401", {}}, {"7E5#11FF", {"7E4#110000"}}, {"7E5#17", {"7E4#170000"}}});
    EXPECT_EQ(power_on(), Frames{});
    heat(1, 130.0);
    EXPECT_EQ(pass(6000), Frames{});
    heat(1, 20.0);
    EXPECT_EQ(pass(1000), Frames{});
    talk({{"7E5#0401", {}}, {"7E5#1105", {"7E4#110000"}}, {"7E5#0400", {"705#00"}}});
}

TEST_F(Pdos, Tpdo1EachSecond) {
    verifies<req::TCS_PDO_001, req::TCS_OD_1800, req::TCS_OD_1A00>();
    EXPECT_EQ(read(0x1800, 1).value, 0x400001FFU);
    const std::vector<std::uint32_t> mapped{2, 0x71300110, 0x71300210, 0, 0};
    for (int sub = 0; sub <= 4; ++sub) {
        EXPECT_EQ(read(0x1A00, sub).value, mapped[static_cast<std::size_t>(sub)]) << sub;
    }
    heat(1, 100.0);
    heat(2, -15.0);
    read_once();
    EXPECT_EQ(pass(3000), Frames{});
    // 100 degC: 5968 = 1750h; -15 degC: 4128 = 1020h
    EXPECT_EQ(send("000#0100"), (Frames{"1FF#50172010"}));
    EXPECT_EQ(pass(2500), (Frames{"1000:1FF#50172010", "2000:1FF#50172010"}));
    EXPECT_EQ(send("1FF#R"), Frames{});  // bit 30: no RTR
}

TEST_F(Pdos, SentinelsOnTheWire) {
    verifies<req::TCS_PDO_001, req::TCS_VAL_005, req::TCS_VAL_006>();
    write(0x6112, 2, 1, 0);
    cut(1);
    settle();
    EXPECT_EQ(send("000#0100"), (Frames{"1FF#00FEFFFF"}));
}

TEST_F(Pdos, Tpdo2CarriesAverageAndColdJunctionWhenMadeValid) {
    verifies<req::TCS_PDO_002, req::TCS_OD_1801, req::TCS_OD_1A01, req::TCS_OD_2130, req::TCS_OD_3130>();
    EXPECT_EQ(read(0x1801, 1).value, 0xC00002FFU);
    EXPECT_EQ(read(0x1801, 5).value, 0U);
    const std::vector<std::uint32_t> mapped{2, 0x21300010, 0x31300010, 0, 0};
    for (int sub = 0; sub <= 4; ++sub) {
        EXPECT_EQ(read(0x1A01, sub).value, mapped[static_cast<std::size_t>(sub)]) << sub;
    }
    EXPECT_EQ(write(0x1801, 5, 2, 700), 0U);
    EXPECT_EQ(write(0x1801, 1, 4, 0x400002FF), 0U);
    EXPECT_EQ(write(0x1800, 1, 4, 0xC00001FF), 0U);
    heat(1, 75.0);
    heat(2, 25.0);
    inputs.cold_junction = 25.0F;
    set_inputs();
    read_once();
    // 50 degC: 5168 = 1430h; 25 degC: 4768 = 12A0h
    EXPECT_EQ(send("000#0100"), (Frames{"2FF#3014A012"}));
    EXPECT_EQ(pass(1400), (Frames{"700:2FF#3014A012", "1400:2FF#3014A012"}));
}

TEST_F(Pdos, Tpdo3And4AreEmpty) {
    verifies<req::TCS_PDO_003, req::TCS_OD_1802, req::TCS_OD_1803, req::TCS_OD_1A02, req::TCS_OD_1A03>();
    for (const int n : {2, 3}) {
        EXPECT_EQ(read(0x1800 + n, 1).value, 0xC00001FFU + static_cast<std::uint32_t>(n) * 0x100U);
        EXPECT_EQ(read(0x1800 + n, 5).value, 0U);
        for (int sub = 0; sub <= 4; ++sub) {
            EXPECT_EQ(read(0x1A00 + n, sub).value, 0U);
        }
    }
    EXPECT_EQ(send("000#0100"), (Frames{"1FF#A012A012"}));
}

TEST_F(Pdos, AreRemappedInFiveSteps) {
    verifies<req::TCS_PDO_004, req::TCS_OD_1A02, req::TCS_OD_6100, req::TCS_OD_6150, req::TCS_OD_5040>();
    EXPECT_EQ(write(0x1802, 1, 4, 0xC00003FF), 0U);
    EXPECT_EQ(write(0x1A02, 0, 1, 0), 0U);
    EXPECT_EQ(write(0x1A02, 1, 4, 0x50400220), 0U);  // supply, FLOAT32
    EXPECT_EQ(write(0x1A02, 2, 4, 0x61500108), 0U);
    EXPECT_EQ(write(0x1A02, 3, 4, 0x61500208), 0U);
    EXPECT_EQ(write(0x1A02, 4, 4, 0x71300110), 0U);
    EXPECT_EQ(write(0x1A02, 0, 1, 4), 0U);
    EXPECT_EQ(write(0x1802, 5, 2, 100), 0U);
    EXPECT_EQ(write(0x1802, 1, 4, 0x400003FF), 0U);
    EXPECT_EQ(write(0x1A02, 0, 1, 0), 0x08000022U);                                 // it exists now
    EXPECT_EQ(send("000#0100"), (Frames{"1FF#A012A012", "3FF#000070430000A012"}));  // 240.0F is 43700000h
}

TEST_F(Pdos, OnlyMeasuredValuesCanBeMapped) {
    verifies<req::TCS_OD_2010, req::TCS_OD_4000, req::TCS_OD_5040, req::TCS_OD_2100, req::TCS_OD_3100>();
    EXPECT_EQ(write(0x1A03, 1, 4, 0x21000020), 0U);
    EXPECT_EQ(write(0x1A03, 1, 4, 0x31000020), 0U);
    for (const std::uint32_t entry : {0x20100120U, 0x40000110U, 0x50400008U, 0x61120108U, 0x21120008U, 0x61100110U}) {
        EXPECT_EQ(write(0x1A03, 1, 4, entry), 0x06040041U) << fmt::format("{:08X}", entry);
    }
    EXPECT_EQ(write(0x1A03, 1, 4, 0x21300310), no_subindex);  // as the manual prints it
    EXPECT_EQ(write(0x1A03, 1, 4, 0x71300310), no_subindex);
}

TEST_F(Pdos, RpdosAreThereForFormsSake) {
    verifies<req::TCS_PDO_005, req::TCS_OD_1400, req::TCS_OD_1401, req::TCS_OD_1402, req::TCS_OD_1403, req::TCS_OD_1600,
             req::TCS_OD_1601, req::TCS_OD_1602, req::TCS_OD_1603>();
    for (int n = 0; n < 4; ++n) {
        EXPECT_EQ(read(0x1400 + n, 0).value, 5U);
        EXPECT_EQ(read(0x1400 + n, 1).value, 0xC000027FU + static_cast<std::uint32_t>(n) * 0x100U);
        EXPECT_EQ(read(0x1400 + n, 2).value, 255U);
        for (int sub = 3; sub <= 5; ++sub) {
            EXPECT_EQ(read(0x1400 + n, sub).value, 0U);
            EXPECT_EQ(read(0x1400 + n, sub).size, sub == 4 ? 1 : 2);
        }
        for (int sub = 0; sub <= 4; ++sub) {
            EXPECT_EQ(read(0x1600 + n, sub).value, 0U);
            EXPECT_EQ(write(0x1600 + n, sub, sub == 0 ? 1 : 4, 0), read_only);
        }
        EXPECT_EQ(read(0x1600 + n, 5).abort, no_subindex);
    }
    EXPECT_EQ(write(0x1400, 1, 4, 0x4000027F), 0U);
    send("000#0100");
    EXPECT_EQ(send("27F#0102030405060708"), Frames{});
}

TEST_F(Pdos, TransmissionTypesAreFixed) {
    verifies<req::TCS_PDO_006, req::TCS_OD_1800, req::TCS_OD_1801, req::TCS_OD_1802, req::TCS_OD_1803, req::TCS_OD_1A00,
             req::TCS_OD_1A01>();
    for (int n = 0; n < 4; ++n) {
        EXPECT_EQ(read(0x1800 + n, 0).value, 5U);
        EXPECT_EQ(write(0x1800 + n, 0, 1, 5), read_only);
        EXPECT_EQ(read(0x1800 + n, 1).size, 4);
        EXPECT_EQ(read(0x1800 + n, 3).value, 0U);
        EXPECT_EQ(read(0x1800 + n, 3).size, 2);
        EXPECT_EQ(read(0x1800 + n, 4).value, 0U);
        EXPECT_EQ(read(0x1800 + n, 4).size, 1);
        EXPECT_EQ(read(0x1800 + n, 5).size, 2);
        EXPECT_EQ(read(0x1800 + n, 6).abort, no_subindex);
        EXPECT_EQ(read(0x1400 + n, 6).abort, no_subindex);
        EXPECT_EQ(read(0x1A00 + n, 5).abort, no_subindex);
        EXPECT_EQ(write(0x1A00 + n, 0, 1, 5), too_high);
        EXPECT_EQ(read(0x1800 + n, 2).value, 254U);
        EXPECT_EQ(write(0x1800 + n, 2, 1, 1), read_only);
        EXPECT_EQ(write(0x1400 + n, 2, 1, 1), read_only);
    }
    EXPECT_EQ(read(0x1800, 5).value, 1000U);
    EXPECT_EQ(write(0x1800, 5, 2, 0), 0U);
    EXPECT_EQ(send("000#0100"), Frames{});
    heat(1, 100.0);  // a change sends nothing
    EXPECT_EQ(pass(5000), Frames{});
}

}  // namespace canproof::test
