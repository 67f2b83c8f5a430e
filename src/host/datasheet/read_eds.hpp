// SPDX-License-Identifier: Apache-2.0
// Reads an electronic data sheet or a device configuration file (CiA 306), or its XML form (CiA 311), as a device that
// can run.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

struct EdsResult {
    Part part;
    Faults faults;  ///< reasons why the file cannot be used; if there are any, `part` must not be used
    Faults notes;   ///< defects, each with the value that is assumed instead; the device can run in spite of them
};

/// Greatest length of a data sheet in bytes.
constexpr std::size_t longest_eds_file = std::size_t{16} << 20U;

/// Reads the whole text and reports all defects by line. A text that is no data sheet, or that describes more than a
/// device can contain, has faults. Any other defect is a note. `name` is the name of the file; without folder and
/// extension it becomes the name of the device. The services of the communication area are assigned by index, as in CiA
/// 301. Every entry with access rw is stored, except a DOMAIN and the entries of 1003h (error list), 1010h (store) and
/// 1011h (restore). Modules, tools and object links are ignored.
EdsResult read_eds(const std::string& text, const std::string& name);

}  // namespace canproof::host
