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
    /// Links the bitcode files; the first must hold the theorems. Throws InputError.
    explicit Program(const std::vector<std::filesystem::path>& bitcode);
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program();

    const llvm::Module& module() const { return *module_; }
    /// Returns the names of the theorems: the functions `void canproof::proofs::NAME()` of the first bitcode file, in
    /// the order of that file.
    const std::vector<std::string>& theorems() const { return theorems_; }
    const llvm::Function& theorem(const std::string& name) const;

  private:
    void prepare();

    std::unique_ptr<llvm::LLVMContext> context_;
    std::unique_ptr<llvm::Module> module_;
    std::vector<std::string> theorems_;
};

}  // namespace canproof::host::prove
