#include "program/program.h"

int main(int argc, char** argv) {
    return demos::runProgram(argc, argv);
}
