// SPDX-License-Identifier: Apache-2.0
#include "host/prove/code_hash.hpp"

#include <llvm/Config/llvm-config.h>
#include <llvm/IR/DebugInfo.h>
#include <llvm/IR/Module.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/Transforms/Utils/Cloning.h>
#include <z3.h>

#include <set>
#include <vector>

#include "host/base/read_file.hpp"
#include "host/base/sha256.hpp"
#include "host/prove/place_in_source.hpp"

namespace canproof::host::prove {

namespace {

constexpr std::size_t longest_program = std::size_t{1} << 30U;

/// Collects the functions and global variables that a theorem reaches: by calls, by addresses, and by the initial
/// values of global variables.
class Reached {
  public:
    explicit Reached(const llvm::Function& theorem) {
        add(theorem);
        while (!waiting_.empty()) {
            const llvm::GlobalValue& next = *waiting_.back();
            waiting_.pop_back();
            if (const auto* function = llvm::dyn_cast<llvm::Function>(&next)) {
                for (const llvm::BasicBlock& block : *function) {
                    for (const llvm::Instruction& instruction : block) {
                        add_operands(instruction);
                    }
                }
            } else {
                add_operands(next);
            }
        }
    }
    bool has(const llvm::GlobalValue& value) const { return all_.count(&value) != 0; }

  private:
    void add(const llvm::GlobalValue& value) {
        if (all_.insert(&value).second) {
            waiting_.push_back(&value);
        }
    }
    void add_operands(const llvm::User& user) {
        for (const llvm::Value* operand : user.operands()) {
            if (const auto* global = llvm::dyn_cast<llvm::GlobalValue>(operand)) {
                add(*global);
            } else if (const auto* constant = llvm::dyn_cast<llvm::Constant>(operand)) {
                if (constants_.insert(constant).second) {
                    add_operands(*constant);
                }
            }
        }
    }

    std::set<const llvm::GlobalValue*> all_{};
    std::set<const llvm::Constant*> constants_{};
    std::vector<const llvm::GlobalValue*> waiting_{};
};

template <typename Values>
void erase_unused(Values values) {
    for (auto one = values.begin(); one != values.end();) {
        auto& value = *one++;
        if (value.isDeclaration() && value.use_empty()) {
            value.eraseFromParent();
        }
    }
}

std::string text_of(llvm::Module& module) {
    erase_unused(module.functions());
    erase_unused(module.globals());
    std::string text;
    llvm::raw_string_ostream stream{text};
    module.print(stream, nullptr);
    return text;
}

bool is_in_base(const llvm::Function& function) {
    return !function.isDeclaration() && file_of(function).find("src/firmware/base/") != std::string::npos;
}

/// Returns a module of the code that a theorem reaches.
std::unique_ptr<llvm::Module> own_module(const llvm::Module& module, const llvm::Function& theorem) {
    const Reached reached{theorem};
    llvm::ValueToValueMapTy map;
    auto own = llvm::CloneModule(module, map, [&](const llvm::GlobalValue* value) { return reached.has(*value); });
    own->setModuleIdentifier("");
    own->setSourceFileName("");
    return own;
}

const std::string& prover_hash() {
    static const std::string hash =
        sha256(read_file("/proc/self/exe", longest_program) + Z3_get_full_version() + LLVM_VERSION_STRING);
    return hash;
}

}  // namespace

std::set<std::string> reached_base(const Program& program, const std::string& theorem) {
    const Reached reached{program.theorem(theorem)};
    std::set<std::string> names;
    for (const llvm::Function& function : program.module()) {
        if (reached.has(function) && is_in_base(function)) {
            names.insert(readable_name(function));
        }
    }
    return names;
}

ReachedCode reached_code(const Program& program, const std::string& theorem, const std::set<std::string>& covered,
                         const std::string& theory) {
    const auto own = own_module(program.module(), program.theorem(theorem));
    ReachedCode code;
    std::vector<std::string> left_out;  // names in LLVM
    for (const llvm::Function& function : *own) {
        if (is_in_base(function) && covered.count(readable_name(function)) != 0) {
            code.left_out.insert(readable_name(function));
            left_out.push_back(function.getName().str());
        }
    }
    llvm::StripDebugInfo(*own);
    code.whole = sha256(prover_hash() + theorem + text_of(*own));
    for (const std::string& name : left_out) {
        if (llvm::Function* function = own->getFunction(name)) {
            function->deleteBody();
        }
    }
    code.outer = sha256(prover_hash() + theorem + theory + text_of(*own));
    return code;
}

}  // namespace canproof::host::prove
