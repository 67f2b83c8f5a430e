// SPDX-License-Identifier: Apache-2.0
// The places of a device's values: in its image in RAM or in its constants in flash.
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

/// The value image of a device: entries in dictionary order, without gaps.
struct Layout {
    std::vector<std::vector<Placement>> placements;  ///< [object][entry], parallel to Part::objects
    std::vector<std::uint8_t> image;                 ///< defaults, without the node-ID
    std::vector<std::uint8_t> constants;
    std::uint32_t fingerprint{0};  ///< hash over the stored entries and their places
};

Layout make_layout(const Part& part);
/// Returns the size in bytes of the value image, that is, of make_layout(part).image.
std::size_t image_size(const Part& part);

/// Returns the bytes of a default: little-endian, strings padded with zeros to `size`.
std::vector<std::uint8_t> value_bytes(const Entry& entry, std::size_t size);

}  // namespace canproof::host
