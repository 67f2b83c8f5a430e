// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int factorial(const int value) {  // flagged
    return (value < 2) ? 1 : (value * factorial(value - 1));
}
int pong(int value);
int ping(const int value) { return pong(value); }  // flagged
int pong(const int value) { return ping(value); }  // flagged
