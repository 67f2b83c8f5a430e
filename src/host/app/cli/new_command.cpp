// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/new_command.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <filesystem>

#include "host/app/new/new_project.hpp"
#include "host/base/input_error.hpp"
#include "host/base/replace_folder.hpp"
#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "host/selection/eds_device.hpp"
#include "host/sim/devices/served_pdos.hpp"

namespace canproof::host {

namespace {

/// Loads the requirements register of the new project. Throws InputError when it has faults, for example because the
/// data sheet contains an object that no device of canproof supports.
void check_register(const std::map<std::string, std::string>& files) {
    SpecFiles spec;
    for (const auto& [path, text] : files) {
        if (path.rfind("spec/", 0) == 0) {
            spec.emplace(path, text);
        }
    }
    const LoadResult loaded = load_register(with_shared_rules(std::move(spec), embedded_spec()));
    if (!loaded.faults.empty()) {
        throw InputError{
            fmt::format("nothing is written, because the register of the new project would have {} fault(s); correct "
                        "the data sheet or the options; the first fault: {}",
                        loaded.faults.size() + loaded.faults.left_out(), loaded.faults.front().text())};
    }
}

void make_runnable(const std::filesystem::path& script) {
    using std::filesystem::perms;
    std::filesystem::permissions(script, perms::owner_exec | perms::group_exec | perms::others_exec,
                                 std::filesystem::perm_options::add);
}

}  // namespace

int write_new_project(const NewOptions& options) {
    NewProject project;
    project.name = options.name;
    project.prefix = options.prefix;
    project.manual = options.manual;
    project.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
    const std::filesystem::path folder{options.name};
    if (std::filesystem::exists(std::filesystem::symlink_status(folder))) {
        throw InputError{fmt::format("{0} exists; choose another name, or remove {0}", folder.string())};
    }
    if (!options.eds.empty()) {
        project.eds = read_eds_part(options.eds);
        check_served_pdos(*project.eds);
    }
    const auto files = project_files(project);
    check_register(files);
    replace_folder(std::filesystem::absolute(folder), files);
    make_runnable(folder / "run");
    make_runnable(folder / "test");
    fmt::print("{} files in {}; next: cd {} && ./run && ./test\n", files.size(), folder.string(), folder.string());
    return 0;
}

}  // namespace canproof::host
