// The backend of the CPU, from its own library.
#include <seaglass/water.h>
#include <seaglass/waves_fftw.h>

int main() {
    return seaglass::fftwWaves() && seaglass::version() == SEAGLASS_VERSION ? 0 : 1;
}
