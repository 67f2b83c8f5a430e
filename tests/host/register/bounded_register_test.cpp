// SPDX-License-Identifier: Apache-2.0
// Registers that are nested too deeply or too large are reported as faults, in bounded time and memory. A pipe, a
// device or a file that is too large in the place of a `.toml` file is refused.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "host/base/input_error.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "host/register/toml_depth.hpp"
#include "tests/host/register/small_register.hpp"

namespace canproof::host::test {

namespace {

using testing::HasSubstr;

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) {
        all += text;
    }
    return all;
}

std::string told(const std::string& items) {
    return all_faults(load_register(with(items_file, items)));
}

/// Returns a table with these inputs, one output `o`, and these rows.
std::string table(const std::string& inputs, const std::string& rows) {
    return "[[table]]\nid = \"AO4-T1\"\ntitle = \"t\"\nsource = [\"M1:1\"]\ninputs = [" + inputs +
           "]\noutputs = [\"o\"]\nrows = [" + rows + "]\n";
}

class RegisterFolder : public testing::Test {
  protected:
    RegisterFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "register-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    ~RegisterFolder() override { std::filesystem::remove_all(folder_); }

    std::string refusal() const {
        try {
            read_spec_files(folder_);
        } catch (const InputError& error) {
            return error.what();
        }
        return "read";
    }

    std::filesystem::path folder_;
};

}  // namespace

TEST(TomlDepth, DepthOfDottedKeysAndBracketsIsLimited) {
    EXPECT_EQ(too_deep_in("a" + repeated(".a", 31) + " = 1\n"), std::nullopt);  // 32 parts
    EXPECT_EQ(too_deep_in("a" + repeated(".a", 32) + " = 1\n"), 1U);
    EXPECT_EQ(too_deep_in("x = 1\n[a" + repeated(" . \"b\"", 32) + "]\n"), 2U);
    EXPECT_EQ(too_deep_in("a = " + repeated("[", 32) + repeated("]", 32) + "\n"), std::nullopt);
    EXPECT_EQ(too_deep_in("a = " + repeated("[\n", 33) + repeated("]", 33) + "\n"), 33U);
    EXPECT_EQ(too_deep_in("a = " + repeated("{ b = ", 33) + "1" + repeated(" }", 33) + "\n"), 1U);
    EXPECT_EQ(too_deep_in(repeated("a.b = 1.5\n[c.d]\n", 1000)), std::nullopt);
}

TEST(TomlDepth, KeysAndBracketsInTextsAndCommentsAreNotCounted) {
    const std::string dots = repeated(".[", 40);
    for (const std::string quote : {"\"", "'", "\"\"\"", "'''"}) {
        EXPECT_EQ(too_deep_in("a = " + quote + dots + quote + "\n"), std::nullopt) << quote;
        EXPECT_EQ(too_deep_in("a = " + quote + quote + "\n[b" + dots + "]\n"), 2U) << quote;
    }
    EXPECT_EQ(too_deep_in("# " + dots + "\n"), std::nullopt);
    EXPECT_EQ(too_deep_in("a = \"\\\"" + dots + "\"\n"), std::nullopt);  // \" does not end the text
    EXPECT_EQ(too_deep_in("a = '\\'\nb" + dots + "\n"), 2U);             // a backslash has no special meaning in '…'
    EXPECT_EQ(too_deep_in("a = \"\"\"\n" + dots + "\n\"\"\"\n"), std::nullopt);
    EXPECT_EQ(too_deep_in("a = \"\"\"x\"\"\"\"\"\nb" + dots + "\n"), 2U);  // x"" is the text
    EXPECT_EQ(too_deep_in("a = \"open\nb" + dots + "\n"), 2U);
    EXPECT_EQ(too_deep_in("a = \"\"\"" + dots), std::nullopt);
    EXPECT_EQ(too_deep_in("a = \"\\"), std::nullopt);
}

TEST(BoundedRegister, KeyOrArrayOfDepth100000IsAFault) {
    const std::string deep = "a" + repeated(".a", 100000);
    for (const std::string& text : {deep + " = 1\n", "[" + deep + "]\n", "a = " + repeated("[", 100000) + "\n"}) {
        EXPECT_EQ(
            told(text),
            items_file + ":1: keys or values go more than 32 levels deep; write shorter keys and fewer brackets\n");
    }
}

TEST(BoundedRegister, NumberOfReportedFaultsOfManyUnknownKeysIsLimited) {
    std::string keys;
    for (int i = 0; i < 200000; ++i) {
        keys += fmt::format("k{} = 1\n", i);
    }
    const LoadResult loaded = load_register(with(items_file, keys));
    EXPECT_EQ(loaded.faults.size(), 10000U);
    EXPECT_EQ(loaded.faults.left_out(), 190000U);
    EXPECT_THAT(loaded.faults.front().text(), HasSubstr("the key `k"));
}

TEST(BoundedRegister, NamesOfAMillionCharactersAreFaults) {
    const std::string name(1000000, 'A');
    const std::string digits(1000000, '1');
    EXPECT_THAT(
        told("[[constant]]\nid = \"" + name + "\"\nname = \"x\"\ntype = \"REAL32\"\nvalue = 1\nsource = [\"M1:1\"]\n"),
        HasSubstr("id AAAA"));
    EXPECT_THAT(told("[[constant]]\nid = \"AO4-C-1\"\nname = \"" + name +
                     "-\"\ntype = \"REAL32\"\nvalue = 1\nsource = [\"M1:1\"]\n"),
                HasSubstr("AAA…; use letters"));
    EXPECT_EQ(told(table("\"a\"", "[\"" + digits + ".." + digits + "\", 1]")), "");  // the cell is a text, not a range
    EXPECT_LT(told("[[constant]]\nid = \"" + name + "\"\n").size(), 10000U);
}

TEST(BoundedRegister, TableOfMoreThan32InputsIsAFault) {
    std::string inputs;
    std::string row;
    for (int i = 0; i < 33; ++i) {
        inputs += fmt::format("\"i{}\", ", i);
        row += "true, ";
    }
    EXPECT_THAT(told(table(inputs, "[" + row + "1]")), HasSubstr("AO4-T1 has 33 inputs; divide the table into tables"));
}

TEST(BoundedRegister, TableOfTooManyCombinationsIsAFault) {
    std::string inputs;
    std::string row;
    for (int i = 0; i < 20; ++i) {
        inputs += fmt::format("{{ name = \"i{}\", values = [\"a\", \"b\", \"c\", \"d\"] }}, ", i);
        row += "\"*\", ";
    }
    EXPECT_THAT(told(table(inputs, "[" + row + "1]")),
                HasSubstr("AO4-T1 has too many rows and combinations to be checked; divide the table"));
    std::string rows;
    for (int i = 0; i < 20000; ++i) {
        rows += fmt::format("[{}, 1],\n", i);
    }
    EXPECT_THAT(told(table("\"i\"", rows)), HasSubstr("AO4-T1 has too many rows and combinations to be checked"));
}

TEST_F(RegisterFolder, FolderWithoutTomlFilesIsRefused) {
    EXPECT_THAT(refusal(), HasSubstr("contains no .toml file; name the folder of a register"));
}

TEST_F(RegisterFolder, FolderWithAPipeOrDeviceAsTomlFileIsRefused) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe.toml").c_str(), 0600), 0);
    EXPECT_THAT(refusal(), HasSubstr("pipe.toml: it is a pipe without a writer"));
    std::filesystem::remove(folder_ / "pipe.toml");
    std::filesystem::create_symlink("/dev/zero", folder_ / "zero.toml");
    EXPECT_THAT(refusal(), HasSubstr("zero.toml: it has more than 16777216 bytes"));
    std::filesystem::remove(folder_ / "zero.toml");
    std::filesystem::create_directory(folder_ / "folder.toml");
    std::ofstream{folder_ / "folder.toml" / "a.toml"} << "x = 1\n";
    EXPECT_EQ(refusal(), "read");
}

}  // namespace canproof::host::test
