// SPDX-License-Identifier: Apache-2.0
// Computes where the values of a device are: in its image in RAM, or in its constants in flash.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// The place of an entry's value: in the image (RAM) or in the constant pool (flash).
struct Placement {
    bool constant{false};
    std::uint16_t offset{0};
    std::uint16_t size{0};
};

/// The layout of a device's values: the place of each entry, and the image of the defaults. In the image, the settings
/// follow all other values; both parts are in the order of the dictionary and padded with zeros to a multiple of
/// four bytes. A setting is stored or factory data, is not mapped into PDOs, and no measurement changes it.
struct Layout {
    /// places of the entries: placements[i][j] belongs to entry j of Part::objects[i]
    std::vector<std::vector<Placement>> placements;
    std::vector<std::uint8_t> image;  ///< bytes of the defaults; the node-ID is not added
    std::vector<std::uint8_t> constants;
    std::uint32_t fingerprint{0};  ///< hash of stored and mappable entries: place, type, rights, limits
    std::size_t settings_at{0};    ///< where the settings begin in the image
};

Layout make_layout(const Part& part);
/// Returns the size of the value image in bytes, equal to make_layout(part).image.size().
std::size_t image_size(const Part& part);

/// Returns the default in `size` bytes: numbers little-endian, strings cut to `size` or padded with zeros.
std::vector<std::uint8_t> value_bytes(const Entry& entry, std::size_t size);

}  // namespace canproof::host
