// SPDX-License-Identifier: Apache-2.0
// Tests the names by which a user selects a device of a run.
#include "host/sim/run/device_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/input_error.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;

std::string refusal(const std::vector<std::string>& names, const std::string& name) {
    try {
        find_device(names, name);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(DeviceNames, FullNameMatches_EvenWhenAnotherNameBeginsWithIt) {
    EXPECT_EQ(find_device({"ax188001@5", "ax130751"}, "ax188001@5"), 0U);
    EXPECT_EQ(find_device({"ax188001@5", "ax130751"}, "ax130751"), 1U);
    EXPECT_EQ(find_device({"ax188001@5", "ax188001"}, "ax188001"), 1U);
}

TEST(DeviceNames, NodeIdMayBeOmittedWhenTheNameIsUnique) {
    EXPECT_EQ(find_device({"cbx-ao412@3", "ax188001@5"}, "ax188001"), 1U);
    EXPECT_EQ(find_device({"my@box@5"}, "my@box"), 0U);  // `my@box` is a device from the EDS file my@box.eds
    EXPECT_EQ(refusal({"ax188001@5", "ax188001@6", "ax130751"}, "ax188001"),
              "`ax188001` is the name of ax188001@5, ax188001@6; write one of these");
}

TEST(DeviceNames, UnknownDeviceNameIsRefusedAndTheRunningDevicesAreListed) {
    EXPECT_EQ(refusal({"ax188001@5", "cbx-ao412"}, "ax1"), "no device `ax1` runs here; there is ax188001@5, cbx-ao412");
    EXPECT_THAT(refusal({"ax188001@5"}, "ax188001@6"), HasSubstr("there is ax188001@5"));
    EXPECT_THAT(refusal({"ax188001@5"}, ""), HasSubstr("no device ``"));
    EXPECT_THAT(refusal(std::vector<std::string>(127, "a@1"), "b"), HasSubstr("and 107 more"));
}

}  // namespace canproof::host::test
