// The shipped sources and a proof's harness as LLVM's bitcode.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace canproof::host::prove {

struct SourceTree {
    std::filesystem::path generated;  ///< headers that the build wrote
    std::filesystem::path scratch;    ///< folder for what is compiled
    std::filesystem::path overlay{};  ///< files here stand in for those of the same name below src/; empty: none
    unsigned jobs{2};                 ///< compilers at once
};

/// Compiles with clang++-19; each source once. Paths are relative to the project's folder, which is the current one.
class Compiler {
  public:
    explicit Compiler(const SourceTree& tree) : tree_{tree} {}

    /// Compiles these proofs, and every source of the firmware whose header one of them includes, directly or by way of
    /// others. Throws InputError with what the compiler says.
    void compile(const std::vector<std::filesystem::path>& proofs);
    /// The bitcode of a proof that was compiled, and behind it that of the sources it needs.
    std::vector<std::filesystem::path> bitcode(const std::filesystem::path& proof) const;
    /// A program that runs one theorem natively under sanitizers; empty when it does not compile.
    std::filesystem::path native(const std::filesystem::path& proof, const std::string& theorem);

  private:
    /// Starts the compiler; collect() waits for it.
    struct Run;
    Run start(const std::filesystem::path& source);
    void collect(const Run& run);
    /// A proof and the sources that it needs.
    std::vector<std::filesystem::path> sources(const std::filesystem::path& proof) const;
    std::vector<std::string> include_flags() const;
    std::filesystem::path in_tree(const std::filesystem::path& source) const;

    SourceTree tree_;
    std::map<std::filesystem::path, std::filesystem::path> done_{};                ///< bitcode by source
    std::map<std::filesystem::path, std::vector<std::filesystem::path>> needs_{};  ///< sources by source
};

}  // namespace canproof::host::prove
