// CiA 306: an electronic data sheet, or a device configuration file, as a device that can be run; CiA 311: the same in
// XML.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

struct EdsResult {
    Part part;
    Faults faults;  ///< the file cannot be given a meaning: the part is not to be used
    Faults notes;   ///< what is wrong, and what is assumed instead; the device runs
};

/// Longer files are no data sheets.
constexpr std::size_t longest_eds_file = std::size_t{16} << 20U;

/// Reads everything and tells everything that is wrong, by line. Refused is what is no data sheet, or describes more
/// than a device can hold; whatever else is wrong is a note. `name` is the file's: the device is called by it, without
/// folder and extension. The services of the communication area are assigned by index, as CiA 301 does; every writable
/// entry is stored. Modules, tools and object links are passed over.
EdsResult read_eds(const std::string& text, const std::string& name);

}  // namespace canproof::host
