// SPDX-License-Identifier: Apache-2.0
// Runs one test alone with mutants of the items that it verifies, one after the other, until it has noticed one mutant
// of each item or the time for the item is over.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/assess/mutation/code_mutation.hpp"
#include "host/assess/mutation/test_server.hpp"
#include "host/assess/trace/kill_record.hpp"

namespace canproof::host {

using MutantNumbers = std::vector<std::size_t>;

/// The mutants of each item: the numbers of altered cells (values in generated tables) and of mutants of code, by the
/// item's id.
struct ItemMutants {
    std::map<std::string, MutantNumbers> cells;  ///< numbers of altered cells
    std::map<std::string, MutantNumbers> code;   ///< mutants of code; the numbers of each item are in ascending order
    std::vector<bool> at_startup;  ///< for each mutant of code, whether it changes a computation at program start
};

/// A test, and the items that it verifies.
struct ClaimingTest {
    std::string name;
    std::string body;  ///< hash of the test's body
    bool is_property{false};
    std::set<std::string> claims;
    std::string code{};  ///< hash of the code that implements the items in `claims`
};

/// Owns the running test programs. Each thread has its own object.
class KillJudge {
  public:
    /// `programs` is the folder of canproof_tests, canproof_properties and code_mutants. `told` has the tests of the
    /// program code_mutants by name, each with the mutants that it reaches. The object keeps references to `mutants`
    /// and `told`.
    KillJudge(std::filesystem::path programs, const ItemMutants& mutants, const std::map<std::string, ToldTest>& told);

    /// Runs the test with mutants. Returns the items of which the test notices a mutant, and the items without mutants.
    KillLine judge(const ClaimingTest& test);

  private:
    double seconds_of(const ClaimingTest& test) const;
    bool notices_cell(const ClaimingTest& test, const MutantNumbers& cells);
    bool notices_code(const ClaimingTest& test, const MutantNumbers& code);
    bool notices_at_startup(const std::filesystem::path& program, const ClaimingTest& test,
                            const MutantNumbers& numbers) const;

    std::filesystem::path programs_;
    TestServer tests_;
    TestServer properties_;
    TestServer code_;
    const ItemMutants& mutants_;
    const std::map<std::string, ToldTest>& told_;
    std::map<std::size_t, bool> noticed_;  ///< for each mutant of code, whether the current test notices it
};

}  // namespace canproof::host
