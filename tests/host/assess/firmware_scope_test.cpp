// SPDX-License-Identifier: Apache-2.0
#include "host/assess/firmware_scope.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace canproof::host {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(FirmwareScope, SimulatedBusesAndReplayOfTheHostAreASeparateScope) {
    EXPECT_EQ(judged_host_path("src/host/sim/bus/candump.cpp"), "src/host/sim/bus/candump.cpp");
    EXPECT_EQ(judged_host_path("/w/build/../src/host/sim/replay/replay.hpp"), "src/host/sim/replay/replay.hpp");
    for (const char* other :
         {"src/host/sim/run/pace.cpp", "src/host/sim/bus/", "src/host/sim/bus/linux_can_system.cpp",
          "src/host/sim/bus/linux_can_system.hpp", "src/firmware/base/crc.cpp", "xsrc/host/sim/bus/a.cpp"}) {
        EXPECT_EQ(judged_host_path(other), "") << other;
    }
    EXPECT_EQ(firmware_path("src/host/sim/bus/candump.cpp"), "");
}

TEST(FirmwareScope, ScopeHasTheSharedFirmwareAndThatOfEachDevice) {
    EXPECT_EQ(firmware_path("src/firmware/base/crc.cpp"), "src/firmware/base/crc.cpp");
    EXPECT_EQ(firmware_path("src/devices/ax130751/firmware/ramp.cpp"), "src/devices/ax130751/firmware/ramp.cpp");
    EXPECT_EQ(firmware_path("src/devices/new-one/firmware/deep/x.hpp"), "src/devices/new-one/firmware/deep/x.hpp");
}

TEST(FirmwareScope, ScopeHasTheDriversOfTheMicrocontroller) {
    EXPECT_EQ(firmware_path("src/target/stm32f405/flash.cpp"), "src/target/stm32f405/flash.cpp");
    EXPECT_EQ(firmware_path("src/target/zynqmp/can.cpp"), "src/target/zynqmp/can.cpp");
    EXPECT_EQ(firmware_path("src/target/zynqmp_image/relay.hpp"), "");
    EXPECT_EQ(firmware_path("src/target/startup.cpp"), "");
    EXPECT_EQ(firmware_path("src/target/stm32f405/"), "");
    EXPECT_TRUE(tests_the_firmware("tests/target/flash_test.cpp"));
}

TEST(FirmwareScope, OtherFilesOfTheProjectAreOutsideTheScope) {
    for (const char* other :
         {"src/host/base/reading.cpp", "src/devices/ax130751/simulation/model.cpp",
          "src/devices/ax130751/target/main.cpp", "src/devices/catalogue.hpp", "src/devices/firmware/x.cpp",
          "src/devices//firmware/x.cpp", "src/firmware", "", "src/firmware/", "src/devices/ax130751/firmware/",
          "tests/firmware/base/crc_test.cpp", "tests/devices/ax130751/firmware/x.cpp", "my-src/firmware/x.cpp",
          "src/target/src_firmware/x.cpp", "src/devices/a/simulation/firmware/x.cpp"}) {
        EXPECT_EQ(firmware_path(other), "") << other;
    }
}

TEST(FirmwareScope, FilePathsAreRelativeToTheProjectFolder) {
    EXPECT_EQ(firmware_path("/w/build/../src/firmware/a.hpp"), "src/firmware/a.hpp");
    EXPECT_EQ(firmware_path("../../src/devices/d/firmware/a.hpp"), "src/devices/d/firmware/a.hpp");
    EXPECT_EQ(firmware_path("/home/src/canproof/src/devices/d/firmware/a.hpp"), "src/devices/d/firmware/a.hpp");
    EXPECT_EQ(firmware_path("/src/firmware/project/src/firmware/a.hpp"), "src/firmware/a.hpp");
}

TEST(FirmwareScope, FirmwareTestsAreRecognisedByTheirPath) {
    for (const char* one :
         {"tests/conformance/sdo_test.cpp", "tests/firmware/bytes_test.cpp",
          "tests/devices/ax130751/blocks/ramp_test.cpp", "tests/devices/shared_test.cpp",
          "tests/devices/ax130751/other/simulation/x_test.cpp", "properties/lss_property.cpp",
          "properties/devices/ax130751/ramp_property.cpp", "fuzz/devices/ax130751/ax130751_fuzz.cpp"}) {
        EXPECT_TRUE(tests_the_firmware(one)) << one;
    }
    for (const char* other : {"tests/host/base/reading_test.cpp", "tests/devices/ax130751/simulation/figures_test.cpp",
                              "properties/host/replay_property.cpp", ""}) {
        EXPECT_FALSE(tests_the_firmware(other)) << other;
    }
}

TEST(FirmwareScope, ExistingFirmwareFoldersAreListed) {
    const fs::path root = fs::path{testing::TempDir()} / "firmware_scope";
    fs::remove_all(root);
    EXPECT_THAT(firmware_folders(root), IsEmpty());
    fs::create_directories(root / "src/devices/b-2/firmware");
    fs::create_directories(root / "src/devices/a/firmware");
    fs::create_directories(root / "src/devices/none/simulation");
    std::ofstream{root / "src/devices/catalogue.hpp"} << "x";
    EXPECT_THAT(firmware_folders(root), ElementsAre("src/devices/a/firmware", "src/devices/b-2/firmware"));
    fs::create_directories(root / "src/firmware/base");
    EXPECT_THAT(firmware_folders(root),
                ElementsAre("src/firmware", "src/devices/a/firmware", "src/devices/b-2/firmware"));
    fs::create_directories(root / "src/target/stm32f405");
    EXPECT_THAT(firmware_folders(root), ElementsAre("src/firmware", "src/devices/a/firmware",
                                                    "src/devices/b-2/firmware", "src/target/stm32f405"));
    fs::remove_all(root);
}

}  // namespace
}  // namespace canproof::host
