// SPDX-License-Identifier: Apache-2.0
// Trigonometry in degrees and in single precision. It does not use sin, cos, atan2 and exp of libm, so that every
// target computes the same bits.
//
// Largest errors compared with double precision, tested in tests/devices/ax060805/blocks/angle_math_test.cpp and
// properties/devices/ax060805/tilt_property.cpp:
// atan2_degrees 0.00003 degree, sine and cosine 0.0000002, exp_of_negative 0.0000004.
#pragma once

namespace canproof::ax060805 {

/// Returns the direction of (x, y) in degrees, -180…180, for finite operands; 0 for (0, 0). Positive and negative zero
/// of y both count as positive, so that an exact half turn is +180.
float atan2_degrees(float y, float x) noexcept;

/// Returns the sine for |degrees| up to 360; exact at multiples of 90. cosine_of_degrees() has the same range.
float sine_of_degrees(float degrees) noexcept;
float cosine_of_degrees(float degrees) noexcept;

/// Returns e to the power of -x, for x from 0 to 4.
float exp_of_negative(float x) noexcept;

}  // namespace canproof::ax060805
