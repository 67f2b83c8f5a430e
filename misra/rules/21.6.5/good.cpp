// Nothing here may be flagged.
struct Unknown;
void keep(Unknown* place);
