#include "host/cli/files.hpp"

#include <fmt/format.h>

#include "host/bus/candump.hpp"

namespace canproof::host {

std::ifstream open_input(const std::string& path) {
    std::ifstream in{path, std::ios::binary};
    if (!in) {
        throw InputError{fmt::format("cannot read {}; name an existing file", path)};
    }
    return in;
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
    if (const auto folder = path.parent_path(); !folder.empty()) {
        std::filesystem::create_directories(folder);
    }
    std::ofstream out{path, std::ios::binary};
    out << bytes;
    if (!out.flush()) {
        throw InputError{fmt::format("cannot write {}", path.string())};
    }
}

}  // namespace canproof::host
