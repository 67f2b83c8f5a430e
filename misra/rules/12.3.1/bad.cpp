// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
union Both {  // flagged
    int whole;
    float real;
};
