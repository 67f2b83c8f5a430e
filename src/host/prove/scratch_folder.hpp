// A folder that goes with its owner.
#pragma once

#include <filesystem>

namespace canproof::host::prove {

class ScratchFolder {
  public:
    /// Throws InputError when there is no place for it.
    ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder();

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace canproof::host::prove
