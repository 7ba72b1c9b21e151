// Memory does not run out here, and sanitizers have an operator new of their own.
#include "tests/unit/sea/starved.h"

namespace tests {

Fed::Fed() : left_(-1) {}
Fed::~Fed() {
    (void)left_;
}

} // namespace tests
