// SPDX-License-Identifier: Apache-2.0
// The shared rules (spec/canopen) of a project: those of the canproof package, or its own.
#include <gtest/gtest.h>

#include "host/register/spec_files.hpp"

namespace canproof::host {

TEST(SharedRules, CanopenRulesOfThePackageAreAddedInTheFolderCanproof) {
    const SpecFiles package{{"spec/canopen/nmt.toml", "a"}, {"spec/devices/x/device.toml", "b"}};
    const SpecFiles own{{"spec/devices/y/device.toml", "c"}};
    const SpecFiles expected{{"canproof/spec/canopen/nmt.toml", "a"}, {"spec/devices/y/device.toml", "c"}};
    EXPECT_EQ(with_shared_rules(own, package), expected);
    EXPECT_EQ(with_shared_rules(own, expected), expected);
}

TEST(SharedRules, CanopenRulesOfTheProjectReplaceThoseOfThePackage) {
    const SpecFiles package{{"spec/canopen/nmt.toml", "a"}};
    const SpecFiles own{{"spec/canopen/own.toml", "c"}, {"spec/devices/y/device.toml", "d"}};
    EXPECT_EQ(with_shared_rules(own, package), own);
}

}  // namespace canproof::host
