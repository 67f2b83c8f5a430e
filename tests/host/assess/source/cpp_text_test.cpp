// SPDX-License-Identifier: Apache-2.0
// Tests how C++ sources are read as text: code without comments, ends of blocks, and the function below an implements<>
// link.
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

Lines condition_of(const std::string& source, std::size_t link) {
    return condition_around(split_lines(code_only(source)), link);
}

}  // namespace

TEST(CppText, CommentsAndLiteralsAreReplacedByBlanksAndLineBreaksStay) {
    EXPECT_EQ(code_only("int a;  // {\nf(\"}\"); /* {\n} */ b = 1'000;"),
              "int a;      \nf(   );     \n     b = 1'000;");
}

TEST(CppText, RawLiteralsAreReplacedByBlanks) {
    EXPECT_EQ(code_only("f(R\"({\")\", x);"), "f(R      , x);");
}

TEST(CppText, BlockEndsAtItsBrace) {
    EXPECT_EQ(block_end("a{b{}'}'c}d}", 0), 10U);
    EXPECT_EQ(block_end("a{b{}", 0), 5U);
    EXPECT_EQ(block_end("}{}", 0), 3U);
}

TEST(FunctionBelowAnImplementsLink, LinkedFunctionEndsWithItsBlock) {
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

TEST(FunctionBelowAnImplementsLink, BracesInLiteralsDoNotEndAFunction) {
    EXPECT_EQ(function_of("static_assert(implements<req::A>);\nint f() {\n    return g('}', \"}\");\n}\n", 1),
              (Lines{2, 4}));
}

TEST(FunctionBelowAnImplementsLink, LinkedStatementsEndWithTheBlockAroundTheLink) {
    const std::string source =
        "int f() {\n"
        "    if (fails()) {\n"
        "        static_assert(implements<req::A>);\n"
        "        return 1;\n"
        "    } else {\n"
        "        static_assert(implements<req::B>);\n"
        "        g();\n"
        "        h();\n"
        "    }\n"
        "    static_assert(implements<req::C>);\n"
        "    const int a = 2;\n"
        "    return a;\n"
        "}\n"
        "int next() { return 3; }\n";
    EXPECT_EQ(function_of(source, 3), (Lines{4, 4}));
    EXPECT_EQ(function_of(source, 6), (Lines{7, 8}));
    EXPECT_EQ(function_of(source, 10), (Lines{11, 12}));
    EXPECT_EQ(function_of("void f() {\n    static_assert(implements<req::A>);\n}\nvoid g() {}\n", 2), (Lines{0, 0}));
}

TEST(FunctionBelowAnImplementsLink, LinkedStatementThatOpensABlockEndsWithThatBlock) {
    const std::string source =
        "void f() {\n"
        "    static_assert(implements<req::A>);\n"
        "    if (g()) {\n"
        "        h();\n"
        "    }\n"
        "    i();\n"
        "}\n";
    EXPECT_EQ(function_of(source, 2), (Lines{3, 5}));
}

TEST(ConditionAroundAnImplementsLink, ConditionIsThatOfTheInnermostIfOrLoopAroundTheLink) {
    const std::string source =
        "void f() {\n"
        "    g();\n"
        "    if (a() &&\n"
        "        b()) {\n"
        "        static_assert(implements<req::A>);\n"
        "        h();\n"
        "    } else if (c()) {\n"
        "        static_assert(implements<req::B>);\n"
        "        h();\n"
        "    } else {\n"
        "        i();\n"
        "        static_assert(implements<req::C>);\n"
        "        h();\n"
        "    }\n"
        "    for (int i = 0; i < 3; ++i) {\n"
        "        static_assert(implements<req::D>);\n"
        "        h();\n"
        "    }\n"
        "}\n";
    EXPECT_EQ(condition_of(source, 5), (Lines{3, 4}));
    EXPECT_EQ(condition_of(source, 8), (Lines{7, 7}));
    EXPECT_EQ(condition_of(source, 12), (Lines{7, 7}));
    EXPECT_EQ(condition_of(source, 16), (Lines{15, 15}));
}

TEST(ConditionAroundAnImplementsLink, FunctionAndClassAreNoCondition) {
    EXPECT_EQ(condition_of("void f(int) {\n    static_assert(implements<req::A>);\n    g();\n}\n", 2), (Lines{0, 0}));
    EXPECT_EQ(condition_of("class C {\n    static_assert(implements<req::A>);\n    void g() {}\n};\n", 2),
              (Lines{0, 0}));
    EXPECT_EQ(condition_of("static_assert(implements<req::A>);\nvoid f() {}\n", 1), (Lines{0, 0}));
}

}  // namespace canproof::host::test
