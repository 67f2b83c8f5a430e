// SPDX-License-Identifier: Apache-2.0
// The harness of a proof, linked with the firmware that it calls, as an LLVM module.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace llvm {
class Function;
class LLVMContext;
class Module;
}  // namespace llvm

namespace canproof::host::prove {

class Program {
  public:
    /// Links the bitcode files. The first must contain the theorems. Throws InputError when they cannot be read or
    /// linked.
    explicit Program(const std::vector<std::filesystem::path>& bitcode);
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program();

    const llvm::Module& module() const { return *module_; }
    /// Returns the names of the theorems in the order of the first bitcode file. A theorem is a function in it with the
    /// declaration `void canproof::proofs::NAME()`.
    const std::vector<std::string>& theorems() const { return theorems_; }
    const llvm::Function& theorem(const std::string& name) const;

  private:
    void prepare();

    std::unique_ptr<llvm::LLVMContext> context_;
    std::unique_ptr<llvm::Module> module_;
    std::vector<std::string> theorems_;
};

}  // namespace canproof::host::prove
