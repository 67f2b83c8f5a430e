// SPDX-License-Identifier: Apache-2.0
// The register that is built into the program. A device that is read alone equals the same device in the whole
// register.
#include "host/selection/built_in.hpp"

#include <gtest/gtest.h>

#include "host/base/input_error.hpp"
#include "host/codegen/write_literals.hpp"
#include "host/codegen/write_objects.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "host/sim/bus/candump.hpp"
#include "tests/support/every_device.hpp"

namespace canproof::host::test {

namespace {

TEST(BuiltIn, DeviceLoadedAloneEqualsThatOfTheWholeRegister) {
    const LoadResult whole = load_register(embedded_spec());
    ASSERT_TRUE(whole.faults.empty()) << whole.faults.front().text();
    for (const std::string& name : canproof::test::every_device()) {
        const Part& alone = device_named(name);
        const Part* part = whole.content.part(name);
        ASSERT_NE(part, nullptr) << name;
        EXPECT_EQ(alone.files, part->files) << name;
        EXPECT_EQ(write_eds(whole.content, alone), write_eds(whole.content, *part)) << name;
        EXPECT_EQ(write_objects(alone), write_objects(*part)) << name;
        EXPECT_EQ(write_signals(alone), write_signals(*part)) << name;
        EXPECT_EQ(write_enumerations(alone), write_enumerations(*part)) << name;
    }
}

TEST(BuiltIn, ConstantsAndEdsOfTheBuiltInRegisterEqualThoseOfTheCheckedRegister) {
    const LoadResult checked = load_register(embedded_spec());
    ASSERT_EQ(built_in_register().parts.size(), checked.content.parts.size());
    for (std::size_t i = 0; i < checked.content.parts.size(); ++i) {
        const Part& part = built_in_register().parts[i];
        EXPECT_EQ(write_constants(part), write_constants(checked.content.parts[i])) << part.name;
        EXPECT_EQ(write_eds(built_in_register(), part), write_eds(checked.content, checked.content.parts[i]));
    }
}

// The front pages of the manuals name the order number of the CAN-CBX-AO412 and the variants of the Axiomatic devices.
TEST(BuiltIn, DeviceIsFoundByItsPartNumberInUpperOrLowerCase) {
    EXPECT_EQ(device_named("C.3040.02").name, "cbx-ao412");
    EXPECT_EQ(device_named("ax130771").name, "ax130751");
    EXPECT_EQ(device_named("AX060841").name, "ax060805");
    EXPECT_EQ(&device_named("AX060835"), &device_named("ax060805")) << "read once";
}

TEST(BuiltIn, UnknownDeviceIsRefused) {
    EXPECT_THROW(device_named("canopen"), InputError);
    EXPECT_THROW(device_named(""), InputError);
    EXPECT_THROW(device_named("ax1307"), InputError);
}

TEST(BuiltIn, DeviceDecisionsHazardsAndReviewsAreNotEmbedded) {
    for (const auto& [path, text] : embedded_spec()) {
        EXPECT_EQ(text.find("[[review]]"), std::string::npos) << path;
        EXPECT_EQ(text.find("[[hazard]]"), std::string::npos) << path;
        EXPECT_EQ(path.find("/decisions/"), std::string::npos) << path;
        EXPECT_TRUE(path.find("spec/devices/") != 0 || text.find("[[decision]]") == std::string::npos) << path;
    }
    EXPECT_EQ(embedded_spec().count("spec/devices/cbx-ao412/device.toml"), 1U);
}

TEST(BuiltIn, RegisterFileThatNeedsAnotherFileIsRefusedWithoutIt) {
    // The range of the entry refers to a table in another file.
    const SpecFiles alone{{"spec/devices/box/objects.toml", R"([[object]]
index = 0x2000
name = "Rate"
type = "UNSIGNED8"
access = "rw"
default = 0
range = { table = "CO-T-RATES" }
source = ["M1:1"]
)"}};
    EXPECT_FALSE(read_sound_register(alone).has_value());
}

}  // namespace

}  // namespace canproof::host::test
