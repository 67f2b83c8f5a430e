// SPDX-License-Identifier: Apache-2.0
// Links from code to the register (implements<>) must be above the code that implements the requirement, and at most
// three in one place.
#include "host/assess/trace/link_places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace canproof::host {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Lines = std::vector<std::string>;

std::vector<std::string> misplaced(const Lines& lines) {
    return misplaced_in("src/firmware/a.cpp", lines);
}

}  // namespace

TEST(ImplementsLinkPlaces, LinkAboveAFunctionIsAccepted) {
    EXPECT_THAT(misplaced({"static_assert(implements<req::A> && implements<req::B> &&",
                           "              implements<req::C>);", "void do_it() {", "}"}),
                IsEmpty());
}

TEST(ImplementsLinkPlaces, CommentMayBeBetweenLinkAndFunction) {
    EXPECT_THAT(misplaced({"static_assert(implements<req::A>);", "/// Does it.", "void do_it() {", "}"}), IsEmpty());
}

TEST(ImplementsLinkPlaces, LinkAboveAMemberFunctionIsAccepted) {
    EXPECT_THAT(misplaced({"class X {", "    static_assert(implements<req::A>);",
                           "    bool operator==(const X& other) const {", "        return true;", "    }", "};"}),
                IsEmpty());
}

TEST(ImplementsLinkPlaces, LinkAboveDataOrAClassIsMisplaced) {
    for (const Lines& below : {Lines{"constexpr const NodeProfile& profile = own::profile;"}, Lines{"class X {", "};"},
                               Lines{"const Circuit circuit{gain(1.0), steps};"}, Lines{"bool member_{false};"},
                               Lines{"const Duration cycle =", "    milliseconds(1);"}}) {
        for (const Lines& above : {Lines{}, Lines{"namespace a {", "void other() {", "    if (b) {", "    }", "}"},
                                   Lines{"class Y {", "  public:"}}) {
            Lines lines{above};
            lines.emplace_back("static_assert(implements<req::A>);");
            lines.insert(lines.end(), below.begin(), below.end());
            EXPECT_THAT(misplaced(lines), ElementsAre(HasSubstr("the code below implements<> is no function")));
        }
    }
}

TEST(ImplementsLinkPlaces, LinkAboveAStatementOfAFunctionIsAccepted) {
    EXPECT_THAT(misplaced({"void do_it() {", "    static_assert(implements<req::A>);", "    if (due) {", "    }", "}"}),
                IsEmpty());
}

TEST(ImplementsLinkPlaces, MoreThanThreeLinksInOnePlaceAreReported) {
    EXPECT_THAT(misplaced({"void other() {}", "static_assert(implements<req::A> && implements<req::B> &&",
                           "              implements<req::C> && implements<req::D>);", "void do_it() {", "}"}),
                ElementsAre(HasSubstr("src/firmware/a.cpp:2: implements<> names 4 items in one place, but at most 3")));
}

TEST(ImplementsLinkPlaces, AdjacentImplementsLinksCountAsOnePlaceInTheCode) {
    EXPECT_THAT(misplaced({"static_assert(implements<req::A> && implements<req::B>);",
                           "static_assert(implements<req::C> && implements<req::D>);", "void do_it() {", "}"}),
                ElementsAre(HasSubstr(":1: implements<> names 4 items in one place")));
}

TEST(ImplementsLinkPlaces, LinkAboveNoCodeIsMisplaced) {
    for (const Lines& below : {Lines{""}, Lines{"}"}, Lines{"namespace x {"}, Lines{"using X = Y;"},
                               Lines{"#include \"b.hpp\""}, Lines{"  private:"}, Lines{"case A:"}, Lines{"default:"},
                               Lines{"break;"}, Lines{"friend class X;"}, Lines{"{"}, Lines{}}) {
        Lines lines{"static_assert(implements<req::A>);"};
        lines.insert(lines.end(), below.begin(), below.end());
        EXPECT_THAT(misplaced(lines), ElementsAre(HasSubstr(":1: no code follows that can implement the item")));
    }
}

TEST(ImplementsLinkPlaces, LinkInACommentIsIgnored) {
    EXPECT_THAT(misplaced({"// static_assert(implements<req::A>);", "", "void do_it() {}"}), IsEmpty());
}

}  // namespace canproof::host
