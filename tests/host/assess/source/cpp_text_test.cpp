// SPDX-License-Identifier: Apache-2.0
// C++ sources as text: code without comments, ends of blocks, the function of a link.
#include "host/assess/source/cpp_text.hpp"

#include <gtest/gtest.h>

#include "host/assess/source/linked_function.hpp"
#include "host/base/lines.hpp"

namespace canproof::host::test {

namespace {

using Lines = std::pair<std::size_t, std::size_t>;

Lines function_of(const std::string& source, std::size_t link) {
    return function_below(split_lines(code_only(source)), link);
}

}  // namespace

TEST(CppText, CommentsAndLiteralsAreReplacedByBlanksAndLineBreaksStay) {
    EXPECT_EQ(code_only("int a;  // {\nf(\"}\"); /* {\n} */ b = 1'000;"),
              "int a;      \nf(   );     \n     b = 1'000;");
}

TEST(CppText, RawLiteralsAreReplacedByBlanksToo) {
    EXPECT_EQ(code_only("f(R\"({\")\", x);"), "f(R      , x);");
}

TEST(CppText, BlockEndsAtItsBrace) {
    EXPECT_EQ(block_end("a{b{}'}'c}d}", 0), 10U);
    EXPECT_EQ(block_end("a{b{}", 0), 5U);
    EXPECT_EQ(block_end("}{}", 0), 3U);
}

TEST(FunctionBelowALink, FunctionBelowALinkEndsWithItsBlock) {
    const std::string source =
        "static_assert(implements<req::A> &&\n"
        "              implements<req::B>);\n"
        "static_assert(implements<req::C>);\n"
        "int f() noexcept {  // {\n"
        "    if (g()) {\n"
        "    }\n"
        "}\n"
        "int h() {}\n";
    for (const std::size_t link : {1U, 2U, 3U}) {
        EXPECT_EQ(function_of(source, link), (Lines{4, 7}));
    }
    EXPECT_EQ(function_of("static_assert(implements<req::A>);\n", 1), (Lines{0, 0}));
}

TEST(FunctionBelowALink, BracesInLiteralsDoNotEndAFunction) {
    EXPECT_EQ(function_of("static_assert(implements<req::A>);\nint f() {\n    return g('}', \"}\");\n}\n", 1),
              (Lines{2, 4}));
}

}  // namespace canproof::host::test
