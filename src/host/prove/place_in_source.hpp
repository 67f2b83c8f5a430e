// Where an instruction stands in the source.
#pragma once

#include <string>

namespace llvm {
class Function;
class Instruction;
}  // namespace llvm

namespace canproof::host::prove {

/// `canproof::ByteView::part(unsigned long, unsigned long) const`.
std::string readable_name(const llvm::Function& function);
/// `canproof::ByteView::part(…) const, src/firmware/base/bytes.hpp:64`.
std::string where_is(const llvm::Instruction& instruction);
/// The file of a function as the compiler was given it; empty without line tables.
std::string file_of(const llvm::Function& function);
unsigned line_of(const llvm::Function& function);

}  // namespace canproof::host::prove
