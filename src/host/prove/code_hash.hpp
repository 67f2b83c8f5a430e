// SPDX-License-Identifier: Apache-2.0
// Hashes of the code that a theorem can execute, with the prover. While the code stays the same, so does the verdict.
#pragma once

#include <set>
#include <string>

#include "host/prove/program.hpp"

namespace canproof::host::prove {

/// The code that a theorem reaches: functions and global variables, without names of files and numbers of lines. The
/// hashes are SHA-256; they also cover this program, and the versions of LLVM and z3.
struct ReachedCode {
    std::string whole;  ///< hash of all of this code; empty when it was not computed
    std::string outer;  ///< hash of this code without the bodies of the functions in `covered`, and of `theory`
    std::set<std::string> left_out;  ///< names of these functions
};

/// Returns the names of the functions of src/firmware/base that a theorem reaches.
std::set<std::string> reached_base(const Program& program, const std::string& theorem);

/// `covered` are the names of functions of src/firmware/base that theorems about it reach. `theory` is the text of
/// these theorems.
ReachedCode reached_code(const Program& program, const std::string& theorem, const std::set<std::string>& covered,
                         const std::string& theory);

}  // namespace canproof::host::prove
