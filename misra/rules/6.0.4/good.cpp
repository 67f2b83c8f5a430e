// Nothing here may be flagged.
namespace own {
int begin();
}
int main() { return own::begin(); }
