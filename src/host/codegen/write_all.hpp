// Everything that the compiler of the register writes.
#pragma once

#include <filesystem>

#include "host/codegen/cpp_text.hpp"
#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

/// All of it as files below `out`; files whose text stays the same are left alone.
void write_all(const Register& content, const SpecFiles& files, const std::filesystem::path& out,
               Cells cells = Cells::constant);

}  // namespace canproof::host
