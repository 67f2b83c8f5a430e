// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#define KNOWN_NAME 4
#if KNOWN_NAME > 3
#endif
int now();
