// SPDX-License-Identifier: Apache-2.0
// Tests the slew rate of the CAN transceiver of the AX060805. It depends on 2000h (CAN Slew Rate), on the bit rate and
// on the stored parameters (manual, 4.3.1, 4.2.7), node 127.
#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class Ax060805SlewRate : public InclinometerTest {
  protected:
    void store_all() { write(0x1010, 1, 0x65766173, 4); }
    bool is_fast() const { return device->outputs().slew_rate_fast; }
    /// Activates the bit rate of `index` by LSS (Table 21: index 0 is 1 Mbit/s, 2 is 500 kbit/s, 3 is 250 kbit/s, 4 is
    /// 125 kbit/s).
    void activate(std::size_t index) {
        send("7E5#0401");
        send("7E5#1300" + hex_le(index, 1));
        send("7E5#150100");
        pass(2);
    }
    /// Activates and stores a bit rate, then returns to the LSS state waiting.
    void activate_and_store(std::size_t index) {
        activate(index);
        send("7E5#17");
        send("7E5#0400");
    }
    void expect_fast(bool fast, const char* when) {
        EXPECT_EQ(is_fast(), fast) << when;
        EXPECT_EQ(read(0x2000), fast ? 1U : 0U) << when;
    }
};

}  // namespace

TEST_F(Ax060805SlewRate, WrittenSlewRateTakesEffectAtOnce) {
    verifies<req::INC_SLEW_001, req::INC_OD_2000, req::INC_S_SLEW_RATE>();
    EXPECT_FALSE(device->outputs().slew_rate_fast);
    EXPECT_EQ(read(0x2000), 0U);
    write(0x2000, 0, 1, 1);
    EXPECT_TRUE(device->outputs().slew_rate_fast);
    write(0x2000, 0, 0, 1);
    EXPECT_FALSE(device->outputs().slew_rate_fast);
    EXPECT_EQ(refusal(0x2000, 0, 2, 1), "06090031");
}

TEST_F(Ax060805SlewRate, SlewRateFollowsTheBitRate) {
    verifies<req::INC_SLEW_002, req::INC_SLEW_003, req::INC_K_FAST_SLEW, req::INC_S_SLEW_RATE, req::INC_OD_2000>();
    // for each index of Table 21, whether its bit rate uses the fast slew rate
    const std::vector<bool> fast{true, true, true, false, false, false, false, false, false};
    for (std::size_t index = 0; index < fast.size(); ++index) {
        if (index != 5) {
            activate(index);
            EXPECT_EQ(device->outputs().slew_rate_fast, fast[index]) << index;
            EXPECT_EQ(read(0x2000), fast[index] ? 1U : 0U) << index;
        }
    }
    activate_and_store(0);
    power_on();
    EXPECT_TRUE(device->outputs().slew_rate_fast);  // at 1 Mbit/s the default is the fast slew rate
    write(0x2000, 0, 0, 1);
    store_all();
    power_on();
    // the stored value of 2000h (CAN slew rate) has priority over the bit rate
    EXPECT_FALSE(device->outputs().slew_rate_fast);
}

TEST_F(Ax060805SlewRate, SaveOfOtherParametersDoesNotStoreTheSlowSlewRate) {
    verifies<req::INC_SLEW_002, req::INC_STORE_001>();
    write(0x2003, 0, 7, 1);
    store_all();  // stores the parameters at 125 kbit/s
    power_on();
    expect_fast(false, "the rate of the save");
    activate_and_store(0);
    power_on();
    expect_fast(true, "1 Mbit/s");
    EXPECT_EQ(read(0x2003), 7U);
    send("000#8100");
    expect_fast(true, "after a reset as well");
}

TEST_F(Ax060805SlewRate, SaveOfOtherParametersDoesNotStoreTheFastSlewRate) {
    verifies<req::INC_SLEW_002>();
    activate_and_store(2);
    store_all();  // stores the parameters at 500 kbit/s
    power_on();
    expect_fast(true, "the rate of the save");
    activate_and_store(4);
    power_on();
    expect_fast(false, "125 kbit/s");
}

TEST_F(Ax060805SlewRate, StoredSlewRateIsKeptAtItsBitRate) {
    verifies<req::INC_SLEW_003, req::INC_STORE_001, req::INC_STORE_002>();
    write(0x2000, 0, 1, 1);
    store_all();
    power_on();
    expect_fast(true, "power-on");
    write(0x2000, 0, 0, 1);
    send("000#8100");
    expect_fast(true, "reset");
    write(0x1011, 3, 0x64616F6C, 4);
    power_on();
    expect_fast(false, "restored: as suits 125 kbit/s");
}

TEST_F(Ax060805SlewRate, StoredSlewRateIsReplacedAtANewBitRate) {
    verifies<req::INC_SLEW_002, req::INC_SLEW_003>();
    write(0x2000, 0, 1, 1);
    store_all();  // stores the fast slew rate at 125 kbit/s
    activate_and_store(3);
    expect_fast(false, "250 kbit/s, without power-on");
    power_on();
    expect_fast(false, "250 kbit/s, after power-on");
    activate_and_store(4);
    power_on();
    expect_fast(true, "the bit rate of the save again");
}

TEST_F(Ax060805SlewRate, SaveOfCommunicationParametersKeepsTheBitRateOfTheStoredSlewRate) {
    verifies<req::INC_SLEW_002, req::INC_SLEW_003, req::INC_STORE_001>();
    write(0x2000, 0, 1, 1);
    store_all();  // stores the fast slew rate at 125 kbit/s
    activate_and_store(3);
    // stores only the communication parameters, to which the slew rate does not belong
    write(0x1010, 2, 0x65766173, 4);
    power_on();
    expect_fast(false, "250 kbit/s");
    activate_and_store(4);
    power_on();
    expect_fast(true, "what was stored at 125 kbit/s");
}

TEST_F(Ax060805SlewRate, SlewRateSavedAtAnotherBitRateIsNotUsed) {
    verifies<req::INC_SLEW_002, req::INC_SLEW_003>();
    activate(2);  // 500 kbit/s applies only until the next power-on, because it is not stored
    send("7E5#0400");
    store_all();
    power_on();
    expect_fast(false, "125 kbit/s");
}

TEST_F(Ax060805SlewRate, RestoredSlewRateSuitsTheBitRateInUse) {
    verifies<req::INC_SLEW_002, req::INC_STORE_004>();
    activate_and_store(0);
    // in turn, 1011h:1 restores all parameter groups and 1011h:3 only the manufacturer group
    for (const std::uint8_t group : {std::uint8_t{1}, std::uint8_t{3}}) {
        power_on();
        write(0x2000, 0, 0, 1);
        store_all();
        power_on();
        expect_fast(false, "stored");
        write(0x1011, group, 0x64616F6C, 4);
        send("000#8100");
        expect_fast(true, "restored");
    }
}

}  // namespace canproof::test
