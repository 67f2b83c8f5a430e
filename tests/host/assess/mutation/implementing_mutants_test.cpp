// SPDX-License-Identifier: Apache-2.0
// Tests which mutants of the code lie in functions that implement an item.
#include "host/assess/mutation/implementing_mutants.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace canproof::host::test {

TEST(ImplementingMutants, MutantsOfAnItemAreInItsLinkedFunctionAndTheFunctionsThatItCalls) {
    const auto root = std::filesystem::temp_directory_path() / ("canproof-implementing-" + std::to_string(getpid()));
    std::filesystem::create_directories(root / "src" / "one");
    std::ofstream{root / "src" / "one" / "relay.cpp"} << "#include \"one/filter.hpp\"\n"
                                                         "static_assert(implements<req::A>);\n"
                                                         "void Relay::close() {\n"
                                                         "    state_ = smooth(1);\n"
                                                         "}\n"
                                                         "void Relay::open() { state_ = 0; }\n";
    std::ofstream{root / "src" / "one" / "filter.cpp"} << "int smooth(int a) { return half(a); }\n"
                                                          "int half(int a) { return a / 2; }\n"
                                                          "int twice(int a) { return a * 2; }\n";
    const std::vector<AlteredCell> mutants{{0, "src/one/relay.cpp", "Relay::close, line 4", "x"},
                                           {1, "src/one/relay.cpp", "Relay::open, line 6", "x"},
                                           {2, "src/one/filter.cpp", "smooth, line 1", "x"},
                                           {3, "src/one/filter.cpp", "half, line 2", "x"},
                                           {4, "src/one/filter.cpp", "twice, line 3", "x"}};
    Evidence evidence;
    evidence.implemented["A"] = {"src/one/relay.cpp:2"};
    evidence.implemented["B"] = {"src/none.cpp:1"};
    evidence.implemented_by = {{"D", "A"}};
    auto found = implementing_mutants(root, evidence, mutants);
    std::filesystem::remove_all(root);
    EXPECT_EQ(found["A"], (std::vector<std::size_t>{0, 2, 3}));
    EXPECT_TRUE(found["B"].empty());
    EXPECT_EQ(found["D"], found["A"]);
}

TEST(ImplementingMutants, LinkInABlockSelectsMutantsOfTheBlockItsConditionAndTheirCallees) {
    const auto root = std::filesystem::temp_directory_path() / ("canproof-condition-" + std::to_string(getpid()));
    std::filesystem::create_directories(root / "src" / "one");
    std::ofstream{root / "src" / "one" / "relay.cpp"} << "int Relay::save() {\n"
                                                         "    if (store() != 0) {\n"
                                                         "        static_assert(implements<req::A>);\n"
                                                         "        return failed - 1;\n"
                                                         "    }\n"
                                                         "    return 2 + 3;\n"
                                                         "}\n"
                                                         "int Relay::store() { return 4 + 5; }\n"
                                                         "int Relay::next() { return 6 + 7; }\n";
    const std::vector<AlteredCell> mutants{{0, "src/one/relay.cpp", "Relay::save, line 2", "x"},
                                           {1, "src/one/relay.cpp", "Relay::save, line 4", "x"},
                                           {2, "src/one/relay.cpp", "Relay::save, line 6", "x"},
                                           {3, "src/one/relay.cpp", "Relay::store, line 8", "x"},
                                           {4, "src/one/relay.cpp", "Relay::next, line 9", "x"}};
    Evidence evidence;
    evidence.implemented["A"] = {"src/one/relay.cpp:3"};
    auto found = implementing_mutants(root, evidence, mutants);
    std::filesystem::remove_all(root);
    EXPECT_EQ(found["A"], (std::vector<std::size_t>{0, 1, 3}));
}

}  // namespace canproof::host::test
