// SPDX-License-Identifier: Apache-2.0
// Tests NODE in NAME@NODE and in --node: only 1…127 and 255 are node-IDs, but coding switches take any value (CBX-AO412
// 3.2.6).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "firmware/base/time.hpp"
#include "host/base/input_error.hpp"
#include "host/selection/chosen_devices.hpp"
#include "host/sim/devices/node_id.hpp"
#include "host/sim/replay/replay.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;

/// Returns the frames that the device sends in a tenth of a second from power-on.
std::string first_frames(ChosenDevice chosen) {
    ReplayInput input;
    input.until = Instant{100000};
    std::ostringstream out;
    replay(*chosen.device, input, out, nullptr);
    return out.str();
}

/// Returns the path of a data sheet that has only the mandatory objects of CiA 301.
std::string small_eds() {
    const std::string path = testing::TempDir() + "small.eds";
    std::ofstream{path}
        << "[FileInfo]\nFileName=small.eds\n[DeviceInfo]\nVendorName=a\nProductName=b\n"
           "BaudRate_125=1\n[MandatoryObjects]\nSupportedObjects=3\n1=0x1000\n2=0x1001\n3=0x1018\n"
           "[1000]\nParameterName=type\nObjectType=7\nDataType=7\nAccessType=ro\nDefaultValue=0\n"
           "[1001]\nParameterName=error\nObjectType=7\nDataType=5\nAccessType=ro\nDefaultValue=0\n"
           "[1018]\nParameterName=identity\nObjectType=9\nSubNumber=2\n"
           "[1018sub0]\nParameterName=count\nObjectType=7\nDataType=5\nAccessType=ro\nDefaultValue=1\n"
           "[1018sub1]\nParameterName=vendor\nObjectType=7\nDataType=7\nAccessType=ro\nDefaultValue=1\n";
    return path;
}

}  // namespace

TEST(NodeId, OnlyNodeIds1To127And255AreAccepted) {
    for (int number = -1; number <= 257; ++number) {
        const bool is_one = (number >= 1 && number <= 127) || number == 255;
        EXPECT_EQ(NodeId::is_one(number), is_one) << number;
        if (is_one) {
            EXPECT_EQ(int{NodeId{number}.value()}, number);
        } else {
            EXPECT_THROW(NodeId{number}, InputError) << number;
        }
    }
}

TEST(ChosenDevices, InvalidNodeIdIsRefused) {
    const std::string eds = small_eds();
    for (const char* node : {"0", "128", "200", "254", "256", "999", "", "x", "-1", "5x", "0x5", "1000"}) {
        for (const char* name : {"ax060805", "ax130751", "ax188001"}) {
            EXPECT_THROW(choose_device(std::string{name} + "@" + node), InputError) << name << "@" << node;
        }
        EXPECT_THROW(choose_eds(eds + "@" + node), InputError) << node;
        ChosenDevice chosen = choose_device("ax188001");
        EXPECT_THROW(set_node(chosen, node), InputError) << node;
    }
    try {
        choose_device("ax188001@200");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("ax188001@200"));
        EXPECT_THAT(error.what(), HasSubstr("1…127, or 255"));
    }
}

TEST(ChosenDevices, DeviceBootsWithNodeId1Or127_AndSendsNothingWith255) {
    EXPECT_THAT(first_frames(choose_device("ax188001@1")), HasSubstr("701#00"));
    EXPECT_THAT(first_frames(choose_device("ax188001@127")), HasSubstr("77F#00"));
    EXPECT_THAT(first_frames(choose_eds(small_eds() + "@127")), HasSubstr("77F#00"));
    EXPECT_EQ(first_frames(choose_device("ax188001@255")), "");
    EXPECT_EQ(first_frames(choose_eds(small_eds() + "@255")), "");
    EXPECT_EQ(choose_device("ax188001@255").notice, "");
}

TEST(ChosenDevices, CodingSwitchesAccept0To255_AndAnInvalidNodeIdIsReported) {
    for (int value = 0; value <= 255; ++value) {
        ChosenDevice chosen = choose_device("cbx-ao412@" + std::to_string(value));
        if (value >= 1 && value <= 127) {
            EXPECT_EQ(chosen.notice, "");
        } else {
            EXPECT_THAT(chosen.notice, HasSubstr("no node-ID")) << value;
            EXPECT_EQ(first_frames(std::move(chosen)), "") << value;
        }
    }
    EXPECT_THAT(choose_device("cbx-ao412@200").notice, HasSubstr("C8h"));  // 200 = 12 * 16 + 8
    const ChosenDevice at_0 = choose_device("cbx-ao412@0");
    at_0.device->power_on(Instant{});
    EXPECT_EQ(int{at_0.device->node_id()}, 255);  // 255 stands for no node-ID
    EXPECT_THROW(choose_device("cbx-ao412@256"), InputError);
    EXPECT_THROW(choose_device("cbx-ao412@"), InputError);
}

TEST(ChosenDevices, SwitchesTurnedToAValidNodeIdGiveNoNotice) {
    ChosenDevice chosen = choose_device("cbx-ao412@200");
    set_node(chosen, "4");
    EXPECT_EQ(chosen.notice, "");
    EXPECT_THAT(first_frames(std::move(chosen)), HasSubstr("704#00"));
}

}  // namespace canproof::host::test
