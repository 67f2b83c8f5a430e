// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
#if 0
#elif 1
#endif
int now();
