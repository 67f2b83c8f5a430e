// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/sound_register.hpp"

#include <fmt/format.h>

#include "host/base/input_error.hpp"
#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

Register sound_register(const std::filesystem::path& spec) {
    if (!std::filesystem::is_directory(spec)) {
        throw InputError{
            fmt::format("{} is no folder; name the project with --root, or the register with --spec", spec.string())};
    }
    LoadResult loaded = load_register(with_shared_rules(read_spec_files(spec), embedded_spec()));
    if (!loaded.faults.empty()) {
        throw InputError{
            fmt::format("the register has {} fault(s), the first {}; `canproof spec check` lists all faults",
                        loaded.faults.size() + loaded.faults.left_out(), loaded.faults.front().text())};
    }
    return std::move(loaded.content);
}

}  // namespace canproof::host
