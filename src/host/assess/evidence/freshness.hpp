// Whether a measurement speaks of the sources as they are: as make judges it, by the times of files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// What the firmware is made of.
std::vector<std::string> firmware_sources();
/// … and what tests it.
std::vector<std::string> firmware_and_tests();

/// The first file below these folders of `root`, by name, that was written after `measured`; empty when there is none,
/// or nothing was measured. Reviews and READMEs change no measurement.
std::string newer_source(const std::filesystem::path& root, const std::vector<std::string>& folders,
                         const std::filesystem::path& measured);

/// The file that was written first of those below the folder; empty without any.
std::filesystem::path oldest_file(const std::filesystem::path& folder);

}  // namespace canproof::host
