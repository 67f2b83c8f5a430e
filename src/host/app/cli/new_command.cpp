// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/new_command.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <vector>

#include "host/app/new/new_project.hpp"
#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/base/replace_folder.hpp"
#include "host/base/utf8.hpp"
#include "host/datasheet/read_eds.hpp"
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

/// Returns the texts of a data sheet that go into files of the project.
std::vector<std::string> texts_of(const Part& part) {
    std::vector<std::string> all{part.info.title, part.info.vendor};
    all.insert(all.end(), part.info.part_numbers.begin(), part.info.part_numbers.end());
    for (const Object& object : part.objects) {
        all.push_back(object.name);
        for (const Entry& entry : object.entries) {
            all.push_back(entry.name);
            all.push_back(std::holds_alternative<std::string>(entry.value) ? std::get<std::string>(entry.value) : "");
        }
    }
    return all;
}

/// Checks that the texts of a data sheet are UTF-8, as all files of the project are. Throws InputError with the line.
void check_texts(const std::string& file, const Part& part) {
    for (const std::string& text : texts_of(part)) {
        if (!is_utf8(text)) {
            const std::string sheet = read_file(file, longest_eds_file);
            const auto at = static_cast<std::ptrdiff_t>(std::min(sheet.find(text), sheet.size()));
            throw InputError{fmt::format("{}:{}: `{}` is not UTF-8; write this text in ASCII", file,
                                         1 + std::count(sheet.begin(), sheet.begin() + at, '\n'), shown_text(text))};
        }
    }
}

/// Checks that the title of the manual fits into the files of the project. Throws InputError.
void check_title(const std::string& title) {
    const bool has_quotes = title.find_first_of("\"\\") != std::string::npos;
    if (has_quotes || title != shown_text(title)) {
        throw InputError{fmt::format("the title of the manual `{}` has {}; leave them out", shown_text(title),
                                     has_quotes ? "quotes or backslashes" : "control characters")};
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
    check_title(options.manual);
    project.manual = options.manual;
    project.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
    const std::filesystem::path folder{options.name};
    if (std::filesystem::exists(std::filesystem::symlink_status(folder))) {
        throw InputError{fmt::format("{0} exists; choose another name, or remove {0}", folder.string())};
    }
    if (!options.eds.empty()) {
        project.eds = read_eds_part(options.eds);
        check_served_pdos(*project.eds);
        check_texts(options.eds, *project.eds);
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
