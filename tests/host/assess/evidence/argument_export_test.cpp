// SPDX-License-Identifier: Apache-2.0
// The graph of the argument.
#include "host/assess/evidence/argument_export.hpp"

#include <gmock/gmock.h>

namespace canproof::host::test {

namespace {

/// Returns the graph of one claim whose only evidence has this title.
std::string graph_with(const std::string& title) {
    Claim claim;
    claim.id = "top";
    claim.evidence = {"one"};
    Argument argument;
    argument.claims = {claim};
    Exhibit exhibit;
    exhibit.title = title;
    return argument_graph(argument, {{"one", exhibit}});
}

// A box has space for 13 characters: a longer title keeps 12 and gets an ellipsis.
TEST(ArgumentGraph, TitleIsShortenedByCharactersAndNotByBytes) {
    EXPECT_THAT(graph_with("abcdefghijklm"), testing::HasSubstr(">abcdefghijklm<"));
    EXPECT_THAT(graph_with("abcdefghijklmn"), testing::HasSubstr(">abcdefghijkl…<"));
    EXPECT_THAT(graph_with("äöüäöüäöüäöüä"), testing::HasSubstr(">äöüäöüäöüäöüä<"));
    EXPECT_THAT(graph_with("abcdefghijkäöü"), testing::HasSubstr(">abcdefghijkä…<"));
    EXPECT_THAT(graph_with("±5 % → 10 µs…!"), testing::HasSubstr(">±5 % → 10 µs…<"));
}

}  // namespace

}  // namespace canproof::host::test
