// SPDX-License-Identifier: Apache-2.0
// Tests the graph of the assurance argument: its claims, and the evidence that supports them.
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

/// Returns the texts of the graph from the title of the evidence on; the last one is its state.
std::vector<std::string> texts_of(const std::string& graph) {
    std::vector<std::string> texts;
    for (auto at = graph.find("<text"); at != std::string::npos; at = graph.find("<text", at + 1)) {
        const auto begin = graph.find('>', at) + 1;
        texts.push_back(graph.substr(begin, graph.find('<', begin) - begin));
    }
    texts.erase(texts.begin(), texts.begin() + 2);  // id and state of the claim
    return texts;
}

// A line of text in a box of the graph has space for 15 characters.
TEST(ArgumentGraph, TitleIsSplitBetweenWordsAndNotShortened) {
    using testing::ElementsAre;
    EXPECT_THAT(texts_of(graph_with("abcdefg hijklmn")), ElementsAre("abcdefg hijklmn", "not measured"));
    EXPECT_THAT(texts_of(graph_with("abcdefg hijklmno")), ElementsAre("abcdefg", "hijklmno", "not measured"));
    EXPECT_THAT(texts_of(graph_with("äöüäöüä öüäöüäö")), ElementsAre("äöüäöüä öüäöüäö", "not measured"));
    EXPECT_THAT(texts_of(graph_with("one two-and-a-long-word")),
                ElementsAre("one", "two-and-a-long-word", "not measured"));
}

TEST(ArgumentGraph, NodeBoxIsAsHighAsItsLinesOfText) {
    // Heights in pixels: one line and the state have 2 * 14 + 12; four lines and the state have 5 * 14 + 12.
    EXPECT_THAT(graph_with("abc"), testing::HasSubstr("height=\"40\" rx=\"20\""));
    EXPECT_THAT(graph_with("Mutation of the firmware's operators and conditions"),
                testing::HasSubstr("height=\"82\" rx=\"20\""));
}

}  // namespace

}  // namespace canproof::host::test
