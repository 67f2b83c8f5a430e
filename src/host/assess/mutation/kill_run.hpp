// SPDX-License-Identifier: Apache-2.0
// Determines which tests notice a mutant of the items that they verify. Each test runs alone with mutants of its items,
// one after the other, until it has noticed one mutant of each item or the time for the item is over.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "host/assess/trace/kill_record.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

struct KillSetup {
    std::filesystem::path root;      ///< folder of the project
    std::filesystem::path programs;  ///< folder of canproof_tests, canproof_properties and code_mutants
    unsigned jobs{2};
};

/// Returns `known` without the tests that no longer exist and with new results. Runs each new or changed test, and each
/// test whose items' code has changed, with mutants. A mutant of an item is an altered generated cell of the item, or a
/// mutant of a function that implements the item (implementing_mutants.hpp). `progress` receives the number of tests
/// that are done, the number of all tests to run, and the record so far. Throws InputError when a test fails without
/// any mutant.
KillRecord record_kills(const KillSetup& setup, const Register& content, KillRecord known,
                        const std::function<void(std::size_t, std::size_t, const KillRecord&)>& progress);

}  // namespace canproof::host
