// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <cstdarg>  // flagged
int read(std::va_list list);  // flagged
