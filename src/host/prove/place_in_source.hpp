// SPDX-License-Identifier: Apache-2.0
// Returns names of functions and places of instructions in the source, for messages.
#pragma once

#include <string>

namespace llvm {
class Function;
class Instruction;
}  // namespace llvm

namespace canproof::host::prove {

/// Returns the name of a function as the source spells it, such as
/// `canproof::ByteView::part(unsigned long, unsigned long) const`.
std::string readable_name(const llvm::Function& function);
/// Returns whether a function has this name, such as "Crc16::add". Outer namespaces and parameters can be left out.
bool is_named(const llvm::Function& function, const std::string& name);
/// Returns function, file and line of an instruction, such as
/// `canproof::ByteView::part(…) const, src/firmware/base/bytes.hpp:64`.
std::string where_is(const llvm::Instruction& instruction);
/// Returns the path of a function's source file as it was given to the compiler; empty when the bitcode has no line
/// tables.
std::string file_of(const llvm::Function& function);
unsigned line_of(const llvm::Function& function);

}  // namespace canproof::host::prove
