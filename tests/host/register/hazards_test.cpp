// SPDX-License-Identifier: Apache-2.0
// Hazards are read as written; the items that they name must exist, and every output must be named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string items = R"([[requirement]]
id = "AO4-R-1"
text = "When the bus is lost, the box shall put its output to 0 V."
source = ["M1:1"]
kind = "functional"
verify = ["test"]
[[signal]]
id = "AO4-S-OUT"
name = "out"
direction = "output"
type = "REAL32"
text = "Voltage."
source = ["M1:1"]
[[hazard]]
id = "AO4-H-1"
text = "The output has a voltage that nobody asked for."
at = ["AO4-S-OUT"]
safe_state = "0 V"
[[hazard.failure]]
text = "The bus is lost."
prevented_by = ["AO4-R-1"]
[[hazard.failure]]
text = "The converter fails."
reason = "The box does not measure its output."
)";

std::string edited(const std::string& from, const std::string& to) {
    std::string text = items;
    return text.replace(text.find(from), from.size(), to);
}

std::string faults_of(const std::string& text) {
    return all_faults(load_register(with(items_file, text)));
}

}  // namespace

TEST(RegisterHazards, HazardsAreReadAsWritten) {
    const LoadResult loaded = load_register(with(items_file, items));
    EXPECT_THAT(all_faults(loaded), Not(HasSubstr("AO4-H-1")));
    const Hazard& hazard = loaded.content.part("box")->hazards.at(0);
    EXPECT_THAT(hazard.at, ElementsAre("AO4-S-OUT"));
    EXPECT_EQ(hazard.safe_state, "0 V");
    ASSERT_EQ(hazard.failures.size(), 2U);
    EXPECT_THAT(hazard.failures[0].prevented_by, ElementsAre("AO4-R-1"));
    EXPECT_EQ(hazard.failures[1].reason, "The box does not measure its output.");
}

TEST(RegisterHazards, UnknownItemsNamedByAHazardAreRefused) {
    EXPECT_THAT(faults_of(edited("prevented_by = [\"AO4-R-1\"]", "prevented_by = [\"AO4-R-9\"]")),
                HasSubstr("AO4-R-9 is no requirement or is retired; name a requirement that prevents the failure"));
    EXPECT_THAT(faults_of(edited("at = [\"AO4-S-OUT\"]", "at = [\"AO4-R-1\"]")),
                HasSubstr("AO4-R-1 is neither a signal nor an object"));
    EXPECT_THAT(faults_of(edited("safe_state =", "decisions = [\"AO4-D-9\"]\nsafe_state =")),
                HasSubstr("AO4-D-9 is no decision"));
}

TEST(RegisterHazards, EachFailureOfAHazardNeedsEitherAPreventionOrAReason) {
    EXPECT_THAT(faults_of(edited("prevented_by = [\"AO4-R-1\"]\n", "")), HasSubstr("needs `prevented_by` or `reason`"));
    EXPECT_THAT(faults_of(edited("reason = \"The", "prevented_by = [\"AO4-R-1\"]\nreason = \"The")),
                HasSubstr("needs `prevented_by` or `reason`, and not both"));
    EXPECT_THAT(faults_of(items.substr(0, items.find("[[hazard.failure]]"))), HasSubstr("AO4-H-1 has no failure"));
}

TEST(RegisterHazards, OutputThatNoHazardOfItsDeviceNamesIsReported) {
    const std::string second =
        "[[signal]]\nid = \"AO4-S-LED\"\nname = \"led\"\ndirection = \"output\"\ntype = "
        "\"BOOLEAN\"\ntext = \"Lamp.\"\nsource = [\"M1:1\"]\n";
    EXPECT_THAT(faults_of(second + items), HasSubstr("no hazard names the output AO4-S-LED"));
    EXPECT_THAT(faults_of(second + items.substr(0, items.find("[[hazard]]"))), Not(HasSubstr("no hazard names")));
}

}  // namespace canproof::host::test
