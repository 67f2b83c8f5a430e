// SPDX-License-Identifier: Apache-2.0
// A temporary folder that is deleted together with the object that owns it.
#pragma once

#include <filesystem>

namespace canproof::host::prove {

class ScratchFolder {
  public:
    /// Makes the folder. Throws InputError when it cannot be made.
    ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder();

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace canproof::host::prove
