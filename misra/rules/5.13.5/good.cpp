// Nothing here may be flagged.
long long big() { return 1LL; }
