// SPDX-License-Identifier: Apache-2.0
// Computes the review marks of an item: short hashes of its code and of its tests. A review records these hashes, so
// that a later change is visible.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/assess/source/test_bodies.hpp"

namespace canproof::host {

/// A function that implements an item, or a test that verifies it.
struct WorkPart {
    std::string file;  ///< source relative to the project's folder; for a function with the line of its link
    std::string name;  ///< name of the function, or Suite.Name of the test; empty for statements
    std::string hash;  ///< hash of the code; empty when the source does not contain the test
};

/// The present review marks of an item, eight hexadecimal digits each: of the code that implements it, and of the tests
/// that verify it. A mark is empty when the item has no code or no test.
struct ItemWork {
    std::string code;
    std::string tests;
    std::vector<WorkPart> functions{};  ///< the functions or statements below the links of the item
    std::vector<WorkPart> bodies{};     ///< the tests that verify the item
};

/// The review marks of each item by its id. Items with neither code nor tests are left out.
using WorkByItem = std::map<std::string, ItemWork>;

/// Computes review marks (hashes of code and of tests). A change of comments or layout does not change a mark. Reads
/// each source once.
class WorkMarks {
  public:
    explicit WorkMarks(const std::filesystem::path& root) : root_{root}, bodies_{root} {}

    /// Returns the hash of the functions below the links (implements<> assertions) at these places (`src/…:line`),
    /// whatever the order of the places. Returns an empty text when there is no place. Throws InputError for a source
    /// that cannot be read.
    std::string of_code(const std::vector<std::string>& places);

    /// Returns the hash of the bodies of these tests, each given as source and Suite.Name. The order of the tests and
    /// their number of instances have no influence. Returns an empty text when there is no test.
    std::string of_tests(const std::vector<std::pair<std::string, std::string>>& tests);

    /// Returns the functions below the links at these places. Throws InputError as of_code() does.
    std::vector<WorkPart> functions(const std::vector<std::string>& places);

    /// Returns these tests with the hashes of their bodies.
    std::vector<WorkPart> bodies(const std::vector<std::pair<std::string, std::string>>& tests);

  private:
    struct Source {
        std::vector<std::string> lines;
        std::vector<std::string> code;  ///< source as code_only() returns it
    };

    std::string code_at(const std::string& place);

    std::filesystem::path root_;
    std::map<std::string, Source> sources_;
    TestBodies bodies_;
};

}  // namespace canproof::host
