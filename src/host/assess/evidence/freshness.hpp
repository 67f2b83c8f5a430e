// Whether a measurement speaks of the sources as they are: by their contents where they are known, else as make judges
// it, by the times of files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

/// The folders that the firmware is made of, from `root`: its own and the register.
std::vector<std::string> firmware_sources(const std::filesystem::path& root);
/// … and those that test it.
std::vector<std::string> firmware_and_tests(const std::filesystem::path& root);
/// … and those of the host whose coverage is measured beside it.
std::vector<std::string> covered_sources(const std::filesystem::path& root);
/// … and those of the buses on a real kernel.
std::vector<std::string> socketcan_sources(const std::filesystem::path& root);
/// … and those of the theorems about it, with the prover.
std::vector<std::string> proof_sources(const std::filesystem::path& root);
/// … and that of the microcontroller.
std::vector<std::string> target_sources(const std::filesystem::path& root);

/// The first file below these folders of `root`, by name, that was written after `measured`; empty when there is none,
/// or nothing was measured. Reviews and READMEs change no measurement.
std::string newer_source(const std::filesystem::path& root, const std::vector<std::string>& folders,
                         const std::filesystem::path& measured);

/// The first of these sources that is not as it was when `measured` was made. A measurement that lies below
/// `root`/build and is younger than its sources when it is first looked at leaves a record of their contents in
/// build/freshness; from then on contents decide, whatever the times of files say. Without a record the times decide.
std::string changed_source(const std::filesystem::path& root, const std::vector<std::string>& folders,
                           const std::filesystem::path& measured);

/// The file that was written first of those below the folder; empty without any.
std::filesystem::path oldest_file(const std::filesystem::path& folder);

}  // namespace canproof::host
