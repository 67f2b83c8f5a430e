// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#ifndef GOOD_HPP
#define GOOD_HPP
int now();
#endif
