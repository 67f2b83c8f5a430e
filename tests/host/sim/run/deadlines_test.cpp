// SPDX-License-Identifier: Apache-2.0
// Tests the search for the earliest of many deadlines, and the list of those that are due.
#include "host/sim/run/deadlines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

}  // namespace

TEST(Deadlines, FirstDeadlineIsTheEarliestThatIsSet) {
    Deadlines deadlines{5};
    EXPECT_EQ(deadlines.first(), never);
    deadlines.set(4, Instant{40});
    deadlines.set(0, Instant{20});
    EXPECT_EQ(deadlines.first(), Instant{20});
    deadlines.set(0, Instant{60});
    EXPECT_EQ(deadlines.first(), Instant{40});
    deadlines.set(4, never);
    EXPECT_EQ(deadlines.first(), Instant{60});
}

TEST(Deadlines, DueDeadlinesAreListedInAscendingNumber) {
    Deadlines deadlines{6};
    deadlines.set(5, Instant{10});
    deadlines.set(1, Instant{30});
    deadlines.set(2, Instant{31});
    EXPECT_THAT(deadlines.due_at(Instant{9}), IsEmpty());
    EXPECT_THAT(deadlines.due_at(Instant{30}), ElementsAre(1U, 5U));
}

TEST(Deadlines, FirstAndDueDeadlinesAreFoundInAListOfOneOrNone) {
    Deadlines one{1};
    one.set(0, Instant{7});
    EXPECT_EQ(one.first(), Instant{7});
    EXPECT_THAT(one.due_at(Instant{7}), ElementsAre(0U));
    const Deadlines none{0};
    EXPECT_EQ(none.first(), never);
    EXPECT_THAT(none.due_at(Instant{7}), IsEmpty());
}

}  // namespace canproof::host::test
