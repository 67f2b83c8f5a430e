// Each marked line must be flagged.
#pragma once  // flagged
int now();
