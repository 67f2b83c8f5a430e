// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#ifndef GOOD_HPP
#define GOOD_HPP
int now();
#endif
