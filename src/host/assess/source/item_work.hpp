// SPDX-License-Identifier: Apache-2.0
// Short marks of the code and the tests of an item. A review records them, so that a later change shows.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/assess/source/test_bodies.hpp"

namespace canproof::host {

/// The present marks, eight digits each, of the code that implements an item and of the tests that show it. A mark is
/// empty when there is no code or no test.
struct ItemWork {
    std::string code;
    std::string tests;
};

/// The marks by id of the item; an item with neither code nor tests is left out.
using WorkByItem = std::map<std::string, ItemWork>;

/// Computes marks of code and tests, eight digits each. Comments and layout do not change them. Reads each source once.
class WorkMarks {
  public:
    explicit WorkMarks(const std::filesystem::path& root) : root_{root}, bodies_{root} {}

    /// Returns the mark of the functions below links at these places (`src/…:line`); their order does not matter. Empty
    /// when there is no place. Throws InputError for a source that cannot be read.
    std::string of_code(const std::vector<std::string>& places);

    /// Returns the mark of the bodies of tests, each given as source and Suite.Name. Their order and the number of
    /// instances do not matter. Empty when there is no test.
    std::string of_tests(const std::vector<std::pair<std::string, std::string>>& tests);

  private:
    struct Source {
        std::vector<std::string> lines;
        std::vector<std::string> code;  ///< result of code_only()
    };

    std::string function_at(const std::string& place);

    std::filesystem::path root_;
    std::map<std::string, Source> sources_;
    TestBodies bodies_;
};

}  // namespace canproof::host
