// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#if 0
#include "sub\dir.hpp"  // flagged
#endif
int now();
