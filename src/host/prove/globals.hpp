// SPDX-License-Identifier: Apache-2.0
// The constants, global variables and functions of a program as terms and objects.
#pragma once

#include <llvm/IR/Constants.h>
#include <llvm/IR/DataLayout.h>
#include <llvm/IR/Function.h>
#include <llvm/IR/GlobalVariable.h>

#include <map>
#include <string>

#include "host/prove/cell_contents.hpp"
#include "host/prove/proof.hpp"

namespace canproof::host::prove {

/// The value of an instruction as a list of scalars. Most types have one scalar; structures and arrays may have
/// several.
using Value = std::vector<Term>;

class Globals {
  public:
    Globals(Proof& proof, const llvm::DataLayout& layout) : proof_{proof}, layout_{layout} {}

    Value value(const llvm::Constant& constant);
    /// Returns the function whose object has this number; nullptr when the object is not a function.
    const llvm::Function* function(ObjectId id) const;
    /// Returns the text that a constant address points to.
    std::string text(const Term& address);

  private:
    Term scalar(const llvm::Constant& constant);
    Term of_expression(const llvm::ConstantExpr& expression);
    Term address_of(const llvm::GlobalValue& global);
    ObjectId add(const llvm::GlobalValue& global);
    void fill(std::vector<Cell>& cells, std::uint64_t at, const llvm::Constant& constant);

    Proof& proof_;
    const llvm::DataLayout& layout_;
    std::map<const llvm::GlobalValue*, ObjectId> ids_;
    std::map<ObjectId, const llvm::Function*> functions_;
};

}  // namespace canproof::host::prove
