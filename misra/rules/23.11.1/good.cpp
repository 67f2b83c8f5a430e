// Nothing here may be flagged.
int hold(const int& held) { return held; }
