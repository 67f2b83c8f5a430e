// SPDX-License-Identifier: Apache-2.0
// Estimates the rate of corrupted frames that pass the checks of CAN.
#pragma once

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Bits of the longest data frame: eight bytes, 11-bit identifier, intermission, no stuff bits. The terms are: 1 start,
/// 11 identifier, 1 RTR, 2 reserved, 4 length, 64 data, 15 CRC, 1 CRC delimiter, 2 ACK, 7 end, 3 intermission.
constexpr int longest_frame_bits = 1 + 11 + 1 + 2 + 4 + 64 + 15 + 1 + 2 + 7 + 3;

/// Returns the probability that at least two of `bits` bits are wrong; `bit_error` is the probability that one bit is
/// wrong, from 0 to less than 1.
double two_or_more_wrong(int bits, double bit_error);
/// Returns an estimate of the probability that a frame is corrupted and still passes its 15-bit CRC.
double undetected_in_frame(double bit_error);
/// Returns how many frames of eight data bytes a fully loaded bus carries per hour; `bit_rate` is in bit/s.
double frames_an_hour(double bit_rate);

/// Returns the rates of undetected wrong frames for each bit rate of the devices, and the detection of each kind of
/// communication error.
Document residual_errors(const Register& content, const Analysis& analysis);

}  // namespace canproof::host
