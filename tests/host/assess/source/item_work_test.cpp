// SPDX-License-Identifier: Apache-2.0
// Tests the review marks of an item, which are hashes of its code and its tests. A mark changes only when this code or
// these tests change.
#include "host/assess/source/item_work.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "host/base/input_error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace canproof::host::test {

namespace {

const std::string code =
    "static_assert(implements<req::A>);\nint f() {\n    return 1;\n}\nint g() {\n    return 2;\n}\n";
const std::string tests = "TEST(F, IsOne) {\n    EXPECT_EQ(f(), 1);\n}\nTEST(G, IsTwo) {\n    EXPECT_EQ(g(), 2);\n}\n";

class ItemWorkHashes : public testing::Test {
  protected:
    void write(const std::string& name, const std::string& text) const {
        const auto file = folder_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream{file} << text;
    }
    std::string code_mark(const std::string& text) const {
        write("src/f.cpp", text);
        return WorkMarks{folder_ / ""}.of_code({"src/f.cpp:1"});
    }
    std::string test_mark(const std::string& text) const {
        write("tests/f_test.cpp", text);
        return WorkMarks{folder_ / ""}.of_tests({{"tests/f_test.cpp", "F.IsOne"}});
    }
    static std::string edited(std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    }

    canproof::test::ScratchFolder folder_;
};

}  // namespace

TEST_F(ItemWorkHashes, CodeHashOfAnItemChangesWithItsLinkedFunctionOnly) {
    const std::string before = code_mark(code);
    EXPECT_EQ(before.size(), 8U);
    EXPECT_NE(code_mark(edited(code, "return 1", "return 3")), before);
    EXPECT_EQ(code_mark(edited(code, "return 2", "return 3")), before);
    EXPECT_EQ(code_mark(edited(code, "    return 1;", "  return  1;  // one")), before);
}

TEST_F(ItemWorkHashes, TestHashOfAnItemChangesWithTheBodyOfItsTestOnly) {
    const std::string before = test_mark(tests);
    EXPECT_EQ(before.size(), 8U);
    EXPECT_NE(test_mark(edited(tests, "f(), 1", "f(), 3")), before);
    EXPECT_EQ(test_mark(edited(tests, "g(), 2", "g(), 3")), before);
}

TEST_F(ItemWorkHashes, RenamedTestKeepsItsHash) {
    const std::string before = test_mark(tests);
    write("tests/f_test.cpp", edited(tests, "F, IsOne", "Function, IsAlwaysOne"));
    EXPECT_EQ(WorkMarks{folder_ / ""}.of_tests({{"tests/f_test.cpp", "Function.IsAlwaysOne"}}), before);
}

TEST_F(ItemWorkHashes, TestHashDoesNotDependOnOrderOrRepetitionOfTests) {
    write("tests/f_test.cpp", tests);
    WorkMarks marks{folder_ / ""};
    const std::pair<std::string, std::string> f{"tests/f_test.cpp", "F.IsOne"};
    const std::pair<std::string, std::string> g{"tests/f_test.cpp", "G.IsTwo"};
    EXPECT_EQ(marks.of_tests({f, g}), marks.of_tests({g, f, f}));
    EXPECT_NE(marks.of_tests({f, g}), marks.of_tests({f}));
}

TEST_F(ItemWorkHashes, HashOfNoCodeOrTestsIsEmpty_AndAMissingSourceIsAnError) {
    WorkMarks marks{folder_ / ""};
    EXPECT_EQ(marks.of_code({}), "");
    EXPECT_EQ(marks.of_tests({}), "");
    EXPECT_THROW(marks.of_code({"src/none.cpp:1"}), InputError);
}

}  // namespace canproof::host::test
