// volk's own code, compiled once for the program.
#define VOLK_IMPLEMENTATION
#include <volk.h>
