// SPDX-License-Identifier: Apache-2.0
// Tests the AX060805 on its network, node 127: LSS, storing, identity, heartbeat and self-start (manual, 4.1, 4.2).
#include <cmath>

#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/devices/ax060805/network_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(Ax060805Network, DeviceShipsAsNode127At125kbit) {
    verifies<req::INC_LSS_001, req::INC_K_NODE_ID, req::INC_K_BIT_RATE>();
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    EXPECT_EQ(device->node_id(), 127);
    EXPECT_EQ(device->bit_rate(), 125000U);
}

TEST_F(Ax060805Network, LssSessionOfTheManualSetsTheNodeId) {
    verifies<req::INC_LSS_002, req::INC_LSS_005, req::INC_LSS_006>();
    EXPECT_EQ(send("7E5#0401"), (Frames{}));
    EXPECT_EQ(send("7E5#1150"), (Frames{"7E4#110000"}));
    EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));
    EXPECT_EQ(send("7E5#0400"), (Frames{"750#00"}));
    node = 0x50;
    EXPECT_EQ(device->node_id(), 0x50);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(read(0x1400, 1), 0x40000250U);
    EXPECT_EQ(read(0x1403, 1), 0xC0000550U);
    EXPECT_EQ(read(0x1800, 1), 0x400001D0U);
    EXPECT_EQ(read(0x1803, 1), 0xC00004D0U);
    EXPECT_EQ(power_on(), (Frames{"750#00"}));
    send("7E5#0401");
    EXPECT_EQ(send("7E5#1180"), (Frames{"7E4#110100"}));  // 128 is no node-ID
}

TEST_F(Ax060805Network, DefaultCobIdsFollowANewNodeIdEvenWhenTheyWereStored) {
    verifies<req::INC_LSS_005>();
    write(0x1801, 1, 0xC00002FF, 4);
    write(0x1801, 1, 0x40000123 + 0x200, 4);  // COB-ID 323h, which is not the default for any node-ID
    store_all();
    for (const char* frame : {"7E5#0401", "7E5#1110", "7E5#17", "7E5#0400"}) {
        send(frame);
    }
    node = 0x10;
    EXPECT_EQ(read(0x1800, 1), 0x40000190U);
    EXPECT_EQ(read(0x1801, 1), 0x40000323U);
}

TEST_F(Ax060805Network, LssSessionOfTheManualSetsTheBitRate) {
    verifies<req::INC_LSS_003, req::INC_LSS_006, req::INC_T21>();
    EXPECT_EQ(send("7E5#0401"), (Frames{}));
    EXPECT_EQ(send("7E5#130003"), (Frames{"7E4#130000"}));
    EXPECT_EQ(send("7E5#158813"), (Frames{}));  // the switch delay is 1388h = 5000 ms
    EXPECT_EQ(pass(4999), (Frames{}));
    EXPECT_EQ(device->bit_rate(), 125000U);
    pass(1);
    EXPECT_EQ(device->bit_rate(), 250000U);
    pass(5000);
    EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));
    EXPECT_EQ(send("7E5#0400"), (Frames{"77F#00"}));
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    power_on();
    EXPECT_EQ(device->bit_rate(), 250000U);
}

TEST_F(Ax060805Network, LssAcceptsTheBitRatesOfTable21) {
    verifies<req::INC_LSS_004, req::INC_LSS_008, req::INC_T21>();
    const std::vector<std::uint32_t> rates{1000000, 800000, 500000, 250000, 125000, 0, 50000, 20000, 10000, 0, 0};
    configure_lss();
    for (std::size_t index = 0; index < rates.size(); ++index) {
        const std::string answer = rates[index] == 0 ? "7E4#130100" : "7E4#130000";
        EXPECT_EQ(send("7E5#1300" + hex_le(index, 1)), (Frames{answer})) << index;
        if (rates[index] != 0) {
            send("7E5#150100");
            pass(2);
            EXPECT_EQ(device->bit_rate(), rates[index]);
        }
    }
    EXPECT_EQ(send("7E5#130103"), (Frames{"7E4#130100"}));  // table selector 1 does not exist: LSS error 1
}

TEST_F(Ax060805Network, StoredBitRateAppliesAtTheNextPowerOn) {
    verifies<req::INC_LSS_004, req::CO_LSS_013, req::CO_LSS_017>();
    configure_lss();
    EXPECT_EQ(send("7E5#130003"), (Frames{"7E4#130000"}));  // index 3: 250 kbit/s
    EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));
    EXPECT_EQ(device->bit_rate(), 125000U);
    send("7E5#0400");
    EXPECT_EQ(device->bit_rate(), 125000U);
    power_on();
    EXPECT_EQ(device->bit_rate(), 250000U);
}

TEST_F(Ax060805Network, RestoringDefaultsKeepsTheNodeIdAndBitRateSetByLss) {
    verifies<req::INC_LSS_007>();
    configure_lss();
    EXPECT_EQ(send("7E5#1150"), (Frames{"7E4#110000"}));
    EXPECT_EQ(send("7E5#130003"), (Frames{"7E4#130000"}));  // 250 kbit/s
    EXPECT_EQ(send("7E5#17"), (Frames{"7E4#170000"}));
    EXPECT_EQ(send("7E5#0400"), (Frames{"750#00"}));
    power_on();
    EXPECT_EQ(send("650#2B17100032000000"), (Frames{"5D0#6017100000000000"}));  // 1017h: 50 ms
    EXPECT_EQ(send("650#2310100173617665"), (Frames{"5D0#6010100100000000"}));  // save
    EXPECT_EQ(send("650#231110016C6F6164"), (Frames{"5D0#6011100100000000"}));  // load: all parameters
    for (const char* reset : {"000#8250", "000#8150"}) {
        EXPECT_EQ(send(reset), (Frames{"750#00"}));
    }
    EXPECT_EQ(power_on(), (Frames{"750#00"}));
    EXPECT_EQ(pass(200), Frames{});  // the defaults are restored: the node does not start itself and sends no TPDO
    EXPECT_EQ(device->bit_rate(), 250000U);
}

TEST_F(Ax060805Network, ParametersAreStoredAndRestoredByGroup) {
    verifies<req::INC_STORE_001, req::INC_STORE_002, req::INC_STORE_004, req::INC_OD_1010, req::INC_OD_1011,
             req::INC_OD_1017, req::INC_STORE_005>();
    const auto change = [this] {
        write(0x1017, 0, 500, 2);
        write(0x2003, 0, 20, 1);
    };
    const auto reset = [this] { send("000#8100"); };
    change();
    power_on();
    EXPECT_EQ(read(0x1017), 0U);
    EXPECT_EQ(read(0x2003), 5U);
    change();
    write(0x1010, 2, 0x65766173, 4);
    power_on();
    EXPECT_EQ(read(0x1017), 500U);
    EXPECT_EQ(read(0x2003), 5U);
    change();
    write(0x1010, 3, 0x65766173, 4);
    power_on();
    EXPECT_EQ(read(0x1017), 500U);
    EXPECT_EQ(read(0x2003), 20U);
    write(0x1011, 2, 0x64616F6C, 4);
    EXPECT_EQ(read(0x1017), 500U);  // the default becomes valid only at the next reset
    reset();
    EXPECT_EQ(read(0x1017), 0U);
    EXPECT_EQ(read(0x2003), 20U);
    write(0x1011, 3, 0x64616F6C, 4);
    EXPECT_EQ(read(0x2003), 20U);
    reset();
    EXPECT_EQ(read(0x2003), 5U);
    change();
    store_all();
    reset();
    EXPECT_EQ(read(0x1017), 500U);
    EXPECT_EQ(read(0x2003), 20U);
    write(0x1011, 1, 0x64616F6C, 4);
    power_on();
    EXPECT_EQ(read(0x1017), 0U);
    EXPECT_EQ(read(0x2003), 5U);
    for (std::uint8_t sub = 1; sub <= 3; ++sub) {
        EXPECT_EQ(read(0x1010, sub), 1U);
        EXPECT_EQ(read(0x1011, sub), 1U);
        EXPECT_EQ(refusal(0x1010, sub, 0x64616F6C, 4), "08000020");
        EXPECT_EQ(refusal(0x1011, sub, 0x65766173, 4), "08000020");
    }
}

TEST_F(Ax060805Network, ParametersOfSeveralGroupsAreStoredButReceivedValuesAreNot) {
    verifies<req::INC_STORE_002, req::INC_OD_2500, req::INC_OD_2300>();
    write(0x2051, 3, 1234, 2);
    write_real(0x3095, 2, 1.5F);
    write_real(0x30A4, 1, -2.5F);
    write(0x5555, 0, 1, 1);
    write(0x5550, 0, 0, 1);
    write(0x4080, 0, 99, 4);
    write(0x2500, 2, 77, 2);
    store_all();
    power_on();
    pass(1);  // the node starts itself and sends its first TPDO
    EXPECT_EQ(read(0x2051, 3), 1234U);
    EXPECT_EQ(real(0x3095, 2), 1.5F);
    EXPECT_EQ(real(0x30A4, 1), -2.5F);
    EXPECT_EQ(read(0x5555), 1U);
    EXPECT_EQ(read(0x5550), 0U);
    EXPECT_EQ(read(0x4080), 99U);
    EXPECT_EQ(read(0x2500, 2), 0U);
}

TEST_F(Ax060805Network, IdentityAndSoftwareDateComeFromTheFactoryDataOfTheUnit) {
    verifies<req::INC_ID_001, req::INC_ID_002, req::INC_OD_1018, req::INC_OD_1020>();
    EXPECT_EQ(read(0x1018, 1), 0x55U);
    EXPECT_EQ(read(0x1018, 2), 0xAA060805U);
    EXPECT_EQ(read(0x1018, 3), 0x00010101U);
    EXPECT_EQ(read(0x1018, 4), 1U);
    EXPECT_EQ(read(0x1020, 1), 0x01012024U);
    EXPECT_EQ(read(0x1020, 2), 0U);
    factory.revision = 0x00020305;
    factory.serial_number = 0x12345678;
    factory.made_on = 0x30042014;  // the example of the manual: April 30th, 2014, 18:42; as BCD digits
    factory.made_at = 0x00001842;
    power_on();
    EXPECT_EQ(read(0x1018, 3), 0x00020305U);
    EXPECT_EQ(read(0x1018, 4), 0x12345678U);
    EXPECT_EQ(read(0x1020, 1), 0x30042014U);
    EXPECT_EQ(read(0x1020, 2), 0x00001842U);
    EXPECT_EQ(refusal(0x1020, 1, 0, 4), "06010002");
    send("000#8200");
    EXPECT_EQ(read(0x1018, 4), 0x12345678U);
}

TEST_F(Ax060805Network, HeartbeatPeriodIs0OrAtLeast10Milliseconds) {
    verifies<req::INC_HB_001, req::INC_HB_003, req::INC_OD_1017, req::INC_HB_004>();
    EXPECT_EQ(pass(100), (Frames{}));
    write(0x1017, 0, 10, 2);
    EXPECT_EQ(pass(20), (Frames{"10:77F#7F", "20:77F#7F"}));
    EXPECT_EQ(refusal(0x1017, 0, 1, 2), "06090032");
    EXPECT_EQ(refusal(0x1017, 0, 9, 2), "06090032");
    write(0x1017, 0, 65535, 2);
    write(0x1017, 0, 0, 2);
    EXPECT_EQ(pass(100), (Frames{}));
}

TEST_F(Ax060805Network, HeartbeatConsumerAcceptsNodeId255AndRefusesReservedBits) {
    verifies<req::INC_OD_1016>();
    EXPECT_EQ(refusal(0x1016, 1, 0x00FFFFFF, 4), "");  // node-ID 255 does not exist, so the entry monitors no node
    EXPECT_EQ(refusal(0x1016, 1, 0x01000000, 4), "06090031");
    EXPECT_EQ(refusal(0x1016, 1, 0x01220064, 4), "06090031");
    EXPECT_EQ(refusal(0x1016, 1, 0, 4), "");
}

TEST_F(Ax060805Network, ParameterWriteWithAutomaticUpdatesEnabledChangesNoOtherParameter) {
    verifies<req::INC_AUTO_001, req::INC_OD_5550>();
    EXPECT_EQ(read(0x5550), 1U);
    write(0x2031, 1, 1, 1);
    write_real(0x2040, 1, 5.0F);
    write(0x2030, 1, 10, 2);
    write(0x2100, 0, 0, 1);
    write(0x2050, 1, 1, 1);
    EXPECT_EQ(read(0x2031, 1), 1U);
    EXPECT_EQ(real(0x2040, 1), 5.0F);
    EXPECT_EQ(read(0x2030, 1), 10U);
    EXPECT_EQ(read(0x2051, 1), 10U);
    write(0x5550, 0, 0, 1);
    EXPECT_EQ(read(0x5550), 0U);
}

TEST_F(Ax060805Network, DeviceStartsItselfWhenStartInOperationalMode5555hIsStored) {
    verifies<req::INC_START_001, req::INC_START_003, req::INC_OD_5555>();
    pass(1000);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    write(0x5555, 0, 1, 1);
    store_all();
    EXPECT_EQ(power_on(), (Frames{"77F#00"}));
    EXPECT_EQ(pass(0), (Frames{"0:1FF#00000000000000"}));
    EXPECT_EQ(device->state(), NmtState::operational);
    write(0x5555, 0, 0, 1);
    store_all();
    power_on();
    pass(1000);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
}

TEST_F(Ax060805Network, UnsavedWriteToStartInOperationalMode5555hStartsNothingAfterAResetOfTheCommunication) {
    verifies<req::INC_START_003>();
    write(0x5555, 0, 1, 1);
    write(0x1010, 2, 0x65766173, 4);  // saves the communication parameters: not 5555h
    EXPECT_EQ(send("000#827F"), (Frames{"77F#00"}));
    send("7E5#0401");
    EXPECT_EQ(send("7E5#0400"), (Frames{"77F#00"}));
    pass(1000);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    EXPECT_EQ(read(0x5555), 1U) << "the written value stays readable";
    send("000#817F");
    EXPECT_EQ(device->state(), NmtState::pre_operational);
}

TEST_F(Ax060805Network, StoredStartMode5555hAppliesDespiteAnUnsavedWrite) {
    verifies<req::INC_START_001, req::INC_START_003>();
    for (const std::uint8_t group : {std::uint8_t{1}, std::uint8_t{3}}) {
        write(0x5555, 0, 1, 1);
        write(0x1010, group, 0x65766173, 4);
        write(0x5555, 0, 0, 1);
        send("000#827F");
        pass(0);
        EXPECT_EQ(device->state(), NmtState::operational) << group;
        write(0x1010, group, 0x65766173, 4);
        send("000#827F");
        pass(1000);
        EXPECT_EQ(device->state(), NmtState::pre_operational) << group;
    }
}

TEST_F(Ax060805Network, SensorErrorPreventsTheSelfStart) {
    verifies<req::INC_START_002, req::INC_ERR_011>();
    write(0x5555, 0, 1, 1);
    store_all();
    inputs.accelerometer_fault = true;
    power_on();
    pass(1000);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
}

TEST_F(Ax060805Network, SelfStartIsSuppressedDuringBusOffUnlessErrorBehaviour1029hKeepsTheState) {
    verifies<req::INC_START_002>();
    const auto state_after_power_on_in_bus_off = [this] {
        store_all();
        inputs.can_state = 3;
        power_on();
        inputs.can_state = 0;
        set_inputs();
        pass(1000);
        return device->state();
    };
    write(0x5555, 0, 1, 1);
    EXPECT_EQ(state_after_power_on_in_bus_off(), NmtState::pre_operational);
    write(0x1029, 1, 1, 1);
    EXPECT_EQ(state_after_power_on_in_bus_off(), NmtState::operational);
}

TEST_F(Ax060805Network, SensorErrorAlsoPreventsTheSelfStartAfterResetCommunication) {
    verifies<req::INC_START_002, req::INC_ERR_011>();
    write(0x5555, 0, 1, 1);
    store_all();
    inputs.accelerometer_fault = true;
    power_on();
    send("000#8200");
    pass(1000);
    EXPECT_EQ(device->state(), NmtState::pre_operational);
    write(0x1029, 2, 1, 1);  // 1029h:2 (error behaviour) is 1: sensor errors do not change the state
    store_all();
    send("000#8200");
    pass(1);
    EXPECT_EQ(device->state(), NmtState::operational);
    write(0x1029, 2, 0, 1);
    store_all();
    inputs.accelerometer_fault = false;
    set_inputs();
    pass(5);
    send("000#8200");
    pass(1);
    EXPECT_EQ(device->state(), NmtState::operational);
}

TEST_F(Ax060805Network, MeasuredSupplyAndTemperaturesKeepTheLastValueOutsideTheirRanges) {
    verifies<req::INC_GLOBAL_001, req::INC_GLOBAL_004, req::INC_GLOBAL_002, req::INC_GLOBAL_005, req::INC_FV_006,
             req::INC_FV_010, req::INC_OD_5020, req::INC_OD_5030, req::INC_OD_4060, req::INC_S_SUPPLY,
             req::INC_S_PROCESSOR_TEMPERATURE, req::INC_S_SENSOR_TEMPERATURE>();
    EXPECT_NEAR(real(0x5020), 23.2F, 1e-5F);
    EXPECT_EQ(real(0x5030), 30.0F);
    EXPECT_EQ(value(0x4060), 25);
    inputs.supply_voltage = 11.5F;
    inputs.processor_temperature = -20.25F;
    inputs.sensor_temperature = -12.6F;
    set_inputs();
    pass(5);
    EXPECT_EQ(real(0x5020), 11.5F);
    EXPECT_EQ(real(0x5030), -20.25F);
    EXPECT_EQ(value(0x4060), -13);
    inputs.supply_voltage = 70.5F;  // 70 V is the end of the range, so 5020h (supply) is not updated
    inputs.processor_temperature = 150.5F;
    inputs.sensor_temperature = NAN;
    set_inputs();
    pass(5);
    EXPECT_EQ(value(0x4060), -13);
    EXPECT_EQ(read(0x4020), 1U);
    EXPECT_EQ(real(0x5020), 11.5F);
    EXPECT_EQ(real(0x5030), -20.25F);
    inputs.supply_voltage = 70.0F;
    inputs.processor_temperature = 150.0F;
    set_inputs();
    pass(5);
    EXPECT_EQ(real(0x5020), 70.0F);
    EXPECT_EQ(real(0x5030), 150.0F);
    inputs.supply_voltage = -0.1F;
    inputs.processor_temperature = -50.1F;
    set_inputs();
    pass(5);
    EXPECT_EQ(real(0x5020), 70.0F);
    EXPECT_EQ(real(0x5030), 150.0F);
    power_on();  // after power-on, before the first sample
    EXPECT_EQ(real(0x5020), 0.0F);
    EXPECT_EQ(real(0x5030), 0.0F);
    EXPECT_EQ(value(0x4060), 0);
}

}  // namespace canproof::test
