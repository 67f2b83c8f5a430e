// Which tests notice a mutant of what they claim: each test runs alone with mutants of its items, until it notices one
// of each.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "host/assess/trace/kill_record.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

struct KillSetup {
    std::filesystem::path root;      ///< of the project
    std::filesystem::path programs;  ///< folder of canproof_tests, canproof_properties and code_mutants
    unsigned jobs{2};
};

/// Judges the tests that `known` does not hold as they are, and forgets those that are gone. A mutant of an item is an
/// altered cell of it, or a mutant of a function that implements it (implementing_mutants.hpp). `progress` is told how
/// many of how many are judged, and what is known by then. Throws InputError when a test fails without any mutant.
KillRecord record_kills(const KillSetup& setup, const Register& content, KillRecord known,
                        const std::function<void(std::size_t, std::size_t, const KillRecord&)>& progress);

}  // namespace canproof::host
