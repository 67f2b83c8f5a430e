// SPDX-License-Identifier: Apache-2.0
// Checks the data sheets that this program writes by the rules of `canproof eds check`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "host/datasheet/check/check_eds.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/selection/built_in.hpp"

namespace canproof::host::test {

namespace {

/// Returns the rules that give warnings because of what the manual of the device says.
std::set<std::string> caused_by_the_manual(const std::string& device) {
    if (device == "cbx-ao412") {
        return {};
    }
    // AX060805, AX130751 and AX188001: the manuals list sub-index 4 of the PDO communication parameters, the
    // compatibility entry of older issues of CiA 301.
    std::set<std::string> rules{"pdo-sub-reserved"};
    if (device == "ax130751") {
        // The manual allows receive and transmit PDOs for 6220h, 7300h, 2223h, 2250h and 2500h. Only access rw
        // expresses both.
        rules.insert({"mapping-no-direction", "map-no-direction"});
    }
    return rules;
}

}  // namespace

TEST(OwnSheets, DataSheetsOfOurDevicesHaveOnlyWarningsCausedByTheirManuals) {
    std::size_t devices = 0;
    for (const Part& part : built_in_register().parts) {
        if (!part.is_device()) {
            continue;
        }
        ++devices;
        for (const Reals reals : {Reals::without_limits, Reals::bits}) {
            std::set<std::string> rules;
            for (const EdsFinding& finding :
                 check_eds(write_eds(built_in_register(), part, reals), part.name + ".eds")) {
                EXPECT_EQ(finding.rule.severity, EdsSeverity::warning) << part.name << ": " << finding.what;
                rules.insert(finding.rule.id);
            }
            EXPECT_EQ(rules, caused_by_the_manual(part.name)) << part.name;
        }
    }
    EXPECT_EQ(devices, 4U);
}

}  // namespace canproof::host::test
