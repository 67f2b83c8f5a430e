// SPDX-License-Identifier: Apache-2.0
// Compiles the shipped sources and the harness of a proof to LLVM bitcode. The harness is the C++ file with the
// theorems.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace canproof::host::prove {

struct SourceTree {
    std::filesystem::path generated;  ///< headers that the build wrote
    std::filesystem::path scratch;    ///< folder for the files that compiling makes
    std::filesystem::path overlay{};  ///< folder whose files replace those with the same path below src/; empty: none
    unsigned jobs{2};                 ///< number of compilers that run at the same time
};

/// Compiles with clang++-19, each source once. Paths are relative to the project's folder, which must be the current
/// one.
class Compiler {
  public:
    explicit Compiler(const SourceTree& tree) : tree_{tree} {}

    /// Compiles these proofs, and every source of the firmware whose header one of them includes, directly or through
    /// other headers. Throws InputError with the messages of the compiler.
    void compile(const std::vector<std::filesystem::path>& proofs);
    /// Returns the bitcode files of a proof that compile() has compiled: first the proof's own, then those of the
    /// sources that it needs.
    std::vector<std::filesystem::path> bitcode(const std::filesystem::path& proof) const;
    /// Compiles a program that runs one theorem natively under sanitizers, and returns its path. Throws InputError when
    /// it does not compile.
    std::filesystem::path native(const std::filesystem::path& proof, const std::string& theorem);

  private:
    /// Starts the compiler; collect() waits for its end.
    struct Run;
    Run start(const std::filesystem::path& source);
    void collect(const Run& run);
    /// The source file of a proof and the sources that it needs.
    std::vector<std::filesystem::path> sources(const std::filesystem::path& proof) const;
    std::vector<std::string> include_flags() const;
    std::filesystem::path in_tree(const std::filesystem::path& source) const;

    SourceTree tree_;
    std::map<std::filesystem::path, std::filesystem::path> done_{};                ///< the bitcode file of each source
    std::map<std::filesystem::path, std::vector<std::filesystem::path>> needs_{};  ///< the other sources that each
                                                                                   ///< source needs
};

}  // namespace canproof::host::prove
