// What the code and the tests of an item are now, as short marks: a review was of these.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/assess/source/test_bodies.hpp"

namespace canproof::host {

/// What implements and what shows an item now, as marks of eight digits; empty where there is nothing.
struct ItemWork {
    std::string code;
    std::string tests;
};

/// By id of the item; what has neither code nor tests is left out.
using WorkByItem = std::map<std::string, ItemWork>;

/// Marks code and tests with eight digits each. Comments and layout do not count. Reads each source once.
class WorkMarks {
  public:
    explicit WorkMarks(const std::filesystem::path& root) : root_{root}, bodies_{root} {}

    /// Marks the functions below links at these places (`src/…:line`), in any order. Empty when there is no place.
    /// Throws InputError for a source that cannot be read.
    std::string of_code(const std::vector<std::string>& places);

    /// Marks the bodies of tests, each a source and Suite.Name, in any order and with any number of instances. Empty
    /// when there is none.
    std::string of_tests(const std::vector<std::pair<std::string, std::string>>& tests);

  private:
    struct Source {
        std::vector<std::string> lines;
        std::vector<std::string> code;  ///< of code_only()
    };

    std::string function_at(const std::string& place);

    std::filesystem::path root_;
    std::map<std::string, Source> sources_;
    TestBodies bodies_;
};

}  // namespace canproof::host
