// SPDX-License-Identifier: Apache-2.0
// Tests the conformance cases that are built into the program.
#include <gtest/gtest.h>

#include <set>

#include "host/conform/run/cases.hpp"
#include "host/selection/built_in.hpp"

namespace canproof::host::conform::test {

TEST(BuiltInCases, ConformanceCasesNameExistingRequirements) {
    std::set<std::string> ids;
    const Part& shared = built_in_register().parts.front();
    built_in_register().for_each_item(shared, [&](const Item& item, const char*) { ids.insert(item.id); });
    for (const Case& one : built_in_cases().cases) {
        for (const std::string& id : one.tests) {
            EXPECT_EQ(ids.count(id), 1U) << one.place.file << ':' << one.place.line << ": " << one.id << " tests "
                                         << id;
        }
    }
}

TEST(BuiltInCases, EachTestNumberOfThePublicConformanceTranscriptIsInAtMostOneCase) {
    std::set<std::string> numbers;
    for (const Case& one : built_in_cases().cases) {
        for (const std::string& number : one.numbers) {
            EXPECT_TRUE(numbers.insert(number).second) << one.id << " has " << number << " as well";
        }
    }
    EXPECT_EQ(numbers.count("2.1"), 1U);
}

}  // namespace canproof::host::conform::test
