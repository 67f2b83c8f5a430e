// SPDX-License-Identifier: Apache-2.0
// Decides whether a measurement is up to date with its sources. It compares the recorded contents of the sources;
// without a record, it compares the times of the files, as make does.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// Returns the folders of the firmware and the folder of the requirements register, relative to `root`.
std::vector<std::string> firmware_sources(const std::filesystem::path& root);
/// Returns firmware_sources() and the folders of tests and properties.
std::vector<std::string> firmware_and_tests(const std::filesystem::path& root);
/// Returns firmware_and_tests() and the folders of the host whose coverage is measured.
std::vector<std::string> covered_sources(const std::filesystem::path& root);
/// Returns firmware_sources() and the folders of the host's buses, runs and SocketCAN tests.
std::vector<std::string> socketcan_sources(const std::filesystem::path& root);
/// Returns firmware_sources() and the other folders on which the exhibit (the result of one tool) with this key
/// depends, such as the rules, deviations and reviews for `misra`.
std::vector<std::string> exhibit_sources(const std::filesystem::path& root, const std::string& key);
/// Returns firmware_sources() and src/target, the folder of the code for the microcontroller.
std::vector<std::string> target_sources(const std::filesystem::path& root);

/// Returns the first file below these folders of `root`, by order of the folders and then of the names, that was
/// written after `measured`. Returns an empty text when there is no such file or `measured` does not exist. Ignores
/// `.md` files, the `reviews.toml` files of the requirements register, and the corpora of the fuzz targets.
std::string newer_source(const std::filesystem::path& root, const std::vector<std::string>& folders,
                         const std::filesystem::path& measured);

/// Returns the first of these sources that differs from its state when `measured` was made. Returns an empty text when
/// there is none. The first call records the contents of the sources in build/freshness, if `measured` is below
/// `root`/build and younger than its sources. Later calls compare the contents and ignore the times of the files.
/// Without a record, the times decide.
std::string changed_source(const std::filesystem::path& root, const std::vector<std::string>& folders,
                           const std::filesystem::path& measured);

/// Returns the file of this folder that was written first; an empty path when the folder has no file.
std::filesystem::path oldest_file(const std::filesystem::path& folder);

}  // namespace canproof::host
