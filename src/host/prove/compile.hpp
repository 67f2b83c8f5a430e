// SPDX-License-Identifier: Apache-2.0
// Compiles the shipped sources and the harness of a proof to LLVM bitcode. A harness is a C++ file with theorems.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace canproof::host::prove {

struct SourceTree {
    std::filesystem::path generated;  ///< folder with the headers that the build wrote
    std::filesystem::path scratch;    ///< folder for the files that the compiler writes
    /// folder with files that replace those with the same path below src/; empty: no replacement
    std::filesystem::path overlay{};
    unsigned jobs{2};  ///< number of compilers that run at the same time
};

/// Compiles with clang++-19, each source once. Paths are relative to the project's folder, which must be the current
/// folder.
class Compiler {
  public:
    explicit Compiler(const SourceTree& tree) : tree_{tree} {}

    /// Compiles these proofs, and every source of the firmware whose header a proof includes, directly or through other
    /// headers, with the invariants of these sources. Throws InputError with the messages of the compiler.
    void compile(const std::vector<std::filesystem::path>& proofs);
    /// Returns the bitcode files of a proof that compile() has compiled. The first is that of the proof; those of the
    /// sources it needs follow.
    std::vector<std::filesystem::path> bitcode(const std::filesystem::path& proof) const;
    /// Compiles a program that runs one theorem natively under sanitizers, and returns its path. Throws InputError when
    /// it does not compile.
    std::filesystem::path native(const std::filesystem::path& proof, const std::string& theorem);

  private:
    /// A compiler that was started. collect() waits for its end.
    struct Run;
    Run start(const std::filesystem::path& source);
    void collect(const Run& run);
    /// Returns the source file of a proof and the sources that it needs.
    std::vector<std::filesystem::path> sources(const std::filesystem::path& proof) const;
    std::vector<std::string> include_flags() const;
    std::filesystem::path in_tree(const std::filesystem::path& source) const;

    SourceTree tree_;
    std::map<std::filesystem::path, std::filesystem::path> done_{};  ///< bitcode file of each compiled source
    /// other sources that each source needs
    std::map<std::filesystem::path, std::vector<std::filesystem::path>> needs_{};
};

}  // namespace canproof::host::prove
