// SPDX-License-Identifier: Apache-2.0
// `canproof new`: writes a project with one device; the project builds and passes its tests.
#pragma once

#include <string>

namespace canproof::host {

struct NewOptions {
    std::string name;    ///< name of folder and device
    std::string eds;     ///< path of an EDS, DCF or XDD; empty: the objects of the template
    std::string manual;  ///< title of the device's manual; empty: derived from the device
    std::string prefix;  ///< prefix of the ids of requirements and decisions; empty: derived from the name
};

/// Writes the project into a new folder in the working directory. Returns the exit status. Throws InputError.
int write_new_project(const NewOptions& options);

}  // namespace canproof::host
