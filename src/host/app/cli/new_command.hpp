// `canproof new`: a folder with one device that builds and tests at once.
#pragma once

#include <string>

namespace canproof::host {

struct NewOptions {
    std::string name;    ///< of folder and device
    std::string eds;     ///< file: EDS, DCF or XDD; empty: the template's objects
    std::string manual;  ///< title; empty: from the device
    std::string prefix;  ///< of its ids; empty: from the name
};

/// Writes the folder into the working directory. Returns the exit status. Throws InputError.
int write_new_project(const NewOptions& options);

}  // namespace canproof::host
