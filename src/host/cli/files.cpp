#include "host/cli/files.hpp"

#include <fmt/format.h>

#include <iterator>
#include <vector>

#include "host/bus/candump.hpp"

namespace canproof::host {

std::ifstream open_input(const std::string& path) {
    if (std::filesystem::is_directory(path)) {
        throw InputError{fmt::format("{} is a folder; name a file", path)};
    }
    std::ifstream in{path, std::ios::binary};
    if (!in) {
        throw InputError{fmt::format("cannot read {}; name an existing file", path)};
    }
    return in;
}

void load_memory(Memory& memory, const std::string& path) {
    std::ifstream in{path, std::ios::binary};
    if (!in) {
        return;  // the first run makes the file
    }
    const std::vector<char> bytes{std::istreambuf_iterator<char>{in}, {}};
    if (bytes.size() != memory.size()) {
        throw InputError{
            fmt::format("{} has {} bytes and is no image of this device's memory ({} bytes); remove it or name another",
                        path, bytes.size(), memory.size())};
    }
    memory.bytes().assign(bytes.begin(), bytes.end());
}

void save_memory(Memory& memory, const std::string& path) {
    std::ofstream out{path, std::ios::binary};
    out.write(reinterpret_cast<const char*>(memory.bytes().data()), static_cast<std::streamsize>(memory.size()));
    if (!out.flush()) {
        throw InputError{fmt::format("cannot write {}", path)};
    }
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
