#include "host/register/spec_files.hpp"

#include <fmt/format.h>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host {

SpecFiles read_spec_files(const std::filesystem::path& spec) {
    SpecFiles files;
    for (const auto& file : std::filesystem::recursive_directory_iterator(spec)) {
        if (file.is_directory() || file.path().extension() != ".toml") {
            continue;
        }
        files["spec/" + file.path().lexically_relative(spec).generic_string()] =
            read_file(file.path(), longest_toml_file);
    }
    if (files.empty()) {
        throw InputError{
            fmt::format("{} holds no .toml file; name the folder of a register, such as spec", spec.string())};
    }
    return files;
}

}  // namespace canproof::host
