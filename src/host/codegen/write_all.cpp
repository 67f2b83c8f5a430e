// SPDX-License-Identifier: Apache-2.0
#include "host/codegen/write_all.hpp"

#include <fstream>
#include <sstream>

#include "host/base/replace_file.hpp"
#include "host/codegen/cpp_text.hpp"
#include "host/codegen/write_alterations.hpp"
#include "host/codegen/write_embedded.hpp"
#include "host/codegen/write_indices.hpp"
#include "host/codegen/write_literals.hpp"
#include "host/codegen/write_objects.hpp"
#include "host/codegen/write_profile.hpp"
#include "host/codegen/write_requirements.hpp"
#include "host/codegen/write_tables.hpp"
#include "host/codegen/write_written.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

namespace {

/// Writes a file only if its text has changed. An unchanged file keeps its time, so the build does not compile it
/// again.
void write_if_changed(const std::filesystem::path& path, const std::string& text) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream old;
    old << in.rdbuf();
    if (in.is_open() && old.str() == text) {
        return;
    }
    std::filesystem::create_directories(path.parent_path());
    replace_file(path, text);
}

}  // namespace

void write_all(const Register& content, const SpecFiles& files, const std::filesystem::path& out, Cells cells) {
    write_if_changed(out / "embedded_spec.cpp", write_embedded(files));
    if (cells == Cells::changeable) {
        write_if_changed(out / "alterations.cpp", write_alterations(content));
    }
    for (const auto& part : content.parts) {
        const auto folder = out / part.cpp_name();
        write_if_changed(folder / "requirements.hpp", write_requirements(content, part));
        write_if_changed(folder / "constants.hpp", write_constants(part, cells));
        write_if_changed(folder / "enumerations.hpp", write_enumerations(part));
        write_if_changed(folder / "tables.hpp", write_tables(content, part, cells));
        write_if_changed(folder / "index.hpp", write_indices(part));
        if (part.is_device()) {
            write_if_changed(folder / "objects.hpp", write_objects(part, cells));
            write_if_changed(folder / "signals.hpp", write_signals(part));
            write_if_changed(folder / "written.hpp", write_written(part));
            write_if_changed(folder / "profile.hpp", write_profile(part, cells));
            write_if_changed(folder / (part.name + ".eds"), write_eds(content, part));
        }
    }
}

}  // namespace canproof::host
