#include "host/assess/evidence/freshness.hpp"

#include "host/assess/firmware_scope.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

bool measured_by(const fs::path& file) {
    return file.filename() != "reviews.toml" && file.extension() != ".md";
}

std::string first_newer(const fs::path& root, const fs::path& folder, const fs::file_time_type time) {
    std::string first;
    for (const auto& one : fs::recursive_directory_iterator{folder}) {
        if (one.is_regular_file() && measured_by(one.path()) && one.last_write_time() > time) {
            const auto name = one.path().lexically_relative(root).generic_string();
            first = first.empty() || name < first ? name : first;
        }
    }
    return first;
}

std::vector<std::string> with(std::vector<std::string> folders, const std::vector<std::string>& more) {
    folders.insert(folders.end(), more.begin(), more.end());
    return folders;
}

}  // namespace

std::vector<std::string> firmware_sources(const fs::path& root) {
    std::vector<std::string> folders = firmware_folders(root);
    folders.emplace_back("spec");
    return folders;
}

std::vector<std::string> firmware_and_tests(const fs::path& root) {
    return with(firmware_sources(root), {"tests", "properties"});
}

std::vector<std::string> socketcan_sources(const fs::path& root) {
    return with(firmware_sources(root), {"src/host/sim/bus", "src/host/sim/run", "tests/socketcan"});
}

std::vector<std::string> target_sources(const fs::path& root) {
    return with(firmware_sources(root), {"src/target"});
}

std::string newer_source(const fs::path& root, const std::vector<std::string>& folders, const fs::path& measured) {
    if (!fs::exists(measured)) {
        return "";
    }
    const auto time = fs::last_write_time(measured);
    for (const auto& folder : folders) {
        if (fs::is_directory(root / folder)) {
            if (const auto name = first_newer(root, root / folder, time); !name.empty()) {
                return name;
            }
        }
    }
    return "";
}

fs::path oldest_file(const fs::path& folder) {
    fs::path oldest;
    if (fs::is_directory(folder)) {
        for (const auto& one : fs::directory_iterator{folder}) {
            if (one.is_regular_file() && (oldest.empty() || one.last_write_time() < fs::last_write_time(oldest))) {
                oldest = one.path();
            }
        }
    }
    return oldest;
}

}  // namespace canproof::host
