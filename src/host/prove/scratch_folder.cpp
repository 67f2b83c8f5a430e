// SPDX-License-Identifier: Apache-2.0
#include "host/prove/scratch_folder.hpp"

#include <cstdlib>

#include "host/base/input_error.hpp"

namespace canproof::host::prove {

ScratchFolder::ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "canproof-prove-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        throw InputError{"cannot make a folder below this one; make sure that it is writable and has free space: " +
                         std::filesystem::temp_directory_path().string()};
    }
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    // files that cannot be deleted stay in the system's folder for temporary files; they do no harm there
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace canproof::host::prove
