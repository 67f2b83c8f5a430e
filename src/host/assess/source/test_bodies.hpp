// SPDX-License-Identifier: Apache-2.0
// Hashes of the bodies of tests in the sources of a project.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace canproof::host {

/// Computes hashes of the bodies of tests. Each source is read once, and each body is hashed once.
class TestBodies {
  public:
    explicit TestBodies(std::filesystem::path root) : root_{std::move(root)} {}

    /// Returns a hash of sixteen digits that changes with the test's body, but not with its name, comments, spaces and
    /// line breaks. Returns an empty text when the source does not define the test. `file` is relative to the project's
    /// folder.
    const std::string& hash(const std::string& file, const std::string& test);

    /// Returns whether the source defines a test whose body has the hash `wanted`, under any name.
    bool has(const std::string& file, const std::string& wanted);

  private:
    const std::string& text_of(const std::string& file);
    std::string hash_of(const std::string& file, const std::string& definition);

    std::filesystem::path root_;
    std::map<std::string, std::string> sources_;  ///< text of each file without comments and spaces, by path
    std::map<std::string, std::string> hashes_;   ///< hashes by file and definition
};

}  // namespace canproof::host
