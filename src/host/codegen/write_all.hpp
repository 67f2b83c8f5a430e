// SPDX-License-Identifier: Apache-2.0
// Writes all files that are generated from the requirements register.
#pragma once

#include <filesystem>

#include "host/codegen/cpp_text.hpp"
#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

/// Writes all files below `out`. Does not write a file whose text is unchanged.
void write_all(const Register& content, const SpecFiles& files, const std::filesystem::path& out,
               Cells cells = Cells::constant);

}  // namespace canproof::host
