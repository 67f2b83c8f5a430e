// SPDX-License-Identifier: Apache-2.0
#include "host/prove/program.hpp"

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>
#include <llvm/IR/Verifier.h>
#include <llvm/IRReader/IRReader.h>
#include <llvm/Linker/Linker.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Support/SourceMgr.h>
#include <llvm/Transforms/Scalar/SROA.h>

#include "host/base/input_error.hpp"
#include "host/prove/place_in_source.hpp"

namespace canproof::host::prove {

namespace {

const std::string theorem_scope = "canproof::proofs::";

std::unique_ptr<llvm::Module> read(const std::filesystem::path& file, llvm::LLVMContext& context) {
    llvm::SMDiagnostic wrong;
    auto module = llvm::parseIRFile(file.string(), wrong, context);
    if (!module) {
        throw InputError{file.string() + ": " + wrong.getMessage().str()};
    }
    return module;
}

}  // namespace

Program::Program(const std::vector<std::filesystem::path>& bitcode) : context_{std::make_unique<llvm::LLVMContext>()} {
    module_ = read(bitcode.front(), *context_);
    for (const llvm::Function& one : *module_) {
        const std::string name = readable_name(one);
        const bool is_theorem = !one.isDeclaration() && one.hasExternalLinkage() && one.arg_empty() &&
                                name.rfind(theorem_scope, 0) == 0 &&
                                name.find(':', theorem_scope.size()) == std::string::npos;
        if (is_theorem) {
            theorems_.push_back(name.substr(theorem_scope.size(), name.size() - theorem_scope.size() - 2));
        }
    }
    for (std::size_t i = 1; i < bitcode.size(); ++i) {
        if (llvm::Linker::linkModules(*module_, read(bitcode[i], *context_))) {
            throw InputError{bitcode[i].string() + " cannot be linked with the harness"};
        }
    }
    prepare();
}

Program::~Program() = default;

/// Converts each local variable to plain values if its address is not used. No other pass of LLVM runs, because a pass
/// might remove code that the prover must judge.
void Program::prepare() {
    llvm::LoopAnalysisManager loops;
    llvm::FunctionAnalysisManager functions;
    llvm::CGSCCAnalysisManager components;
    llvm::ModuleAnalysisManager modules;
    llvm::PassBuilder builder;
    builder.registerModuleAnalyses(modules);
    builder.registerCGSCCAnalyses(components);
    builder.registerFunctionAnalyses(functions);
    builder.registerLoopAnalyses(loops);
    builder.crossRegisterProxies(loops, functions, components, modules);
    llvm::FunctionPassManager passes;
    passes.addPass(llvm::SROAPass{llvm::SROAOptions::PreserveCFG});
    for (llvm::Function& one : *module_) {
        if (!one.isDeclaration()) {
            passes.run(one, functions);
        }
    }
    if (llvm::verifyModule(*module_)) {
        throw InputError{"LLVM rejects the program after simplifying it; please report this as a defect of canproof"};
    }
}

const llvm::Function& Program::theorem(const std::string& name) const {
    for (const llvm::Function& one : *module_) {
        if (!one.isDeclaration() && readable_name(one) == theorem_scope + name + "()") {
            return one;
        }
    }
    throw InputError{"no theorem has this name (`canproof prove` lists the theorems): " + name};
}

}  // namespace canproof::host::prove
